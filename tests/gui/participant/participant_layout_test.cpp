// Every scene on every size of screen: nothing overlaps, is left out or has small letters.

#include "app/gui/participant/participant_layout.h"

#include <algorithm>
#include <numeric>

#include <QtGui/QFontMetricsF>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/participant/pages/participant_font.h"
#include "app/gui/participant/participant_keys.h"
#include "app/gui/participant/type_size.h"
#include "tests/gui/participant/scenes.h"

namespace asperity {
namespace {

using Item = ParticipantItem;

/// A window on a screen: its size, and what 24 points are there.
struct Pane {
  QSizeF size{};
  double letters_px = 32.0;
};
const std::vector<Pane> kPanes = {
    {{1366.0, 768.0}},       {{1920.0, 1080.0}},       {{683.0, 768.0}},
    {{960.0, 1080.0}},       {{1366.0, 768.0}, 37.3},   // on 14 inches
    {{683.0, 768.0}, 37.3},  {{1920.0, 1080.0}, 55.2},  // on 13.3 inches, not scaled by the desktop
    {{960.0, 1080.0}, 55.2}, {{1093.0, 614.0}},         // 1366 × 768 at 125 %
    {{546.0, 614.0}},        {{683.0, 700.0}},  // beside the experimenter's window, over a bar
    {{683.0, 668.0}},                           // with the band of a pilot
    {{960.0, 1016.0}},
};
ParticipantLayoutInputs inputs_for(const Pane& pane, int page = 1) {
  return {.size = pane.size, .smallest_text_px = pane.letters_px, .page = page, .cue_shown = true};
}
std::string name_of(const Pane& pane) {
  return std::to_string(static_cast<int>(pane.size.width())) + " wide, letters of " +
         std::to_string(pane.letters_px);
}

std::vector<std::pair<std::string, ParticipantScene>> every_scene() {
  auto scenes = scenes::all();
  for (auto& more : scenes::demanding()) scenes.push_back(std::move(more));
  return scenes;
}

/// All its pages, as they are turned.
std::vector<std::vector<Item>> pages_of(const ParticipantScene& scene,
                                        ParticipantLayoutInputs inputs) {
  std::vector<std::vector<Item>> pages{};
  for (bool more = true; more && pages.size() < 50;) {
    pages.push_back(lay_out(scene, inputs));
    more = false;
    for (const Item& item : pages.back()) {
      const bool turns = item.action && item.action->what == ParticipantAction::What::turn_to;
      if (!turns || item.action->number != inputs.page + 1) continue;
      ++inputs.page;
      more = true;
      break;
    }
  }
  return pages;
}

void expect_order(const std::vector<Item>& items, const Pane& pane, const std::string& name) {
  const QRectF page(QPointF(), pane.size);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto where = [&] {
      return name + " at " + name_of(pane) + ": " + (items[i].text + items[i].key).toStdString();
    };
    EXPECT_TRUE(page.contains(items[i].rect)) << where();
    EXPECT_GT(items[i].rect.width(), 30.0) << where();
    EXPECT_GT(items[i].rect.height(), 30.0) << where();
    // On the smallest screens a cue comes over what was read before it.
    const bool is_small = pane.size.height() < 660.0 * pane.letters_px / 32.0;
    if (items[i].kind == Item::Kind::cue && is_small) {
      const auto is_covered = [&](const Item& item) {
        return item.kind != Item::Kind::words && item.kind != Item::Kind::cue &&
               item.rect.intersects(items[i].rect);
      };
      EXPECT_TRUE(std::none_of(items.begin(), items.end(), is_covered)) << where();
      continue;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const QRectF common = items[i].rect.intersected(items[j].rect);
      EXPECT_LT(std::max(0.0, common.width()) * std::max(0.0, common.height()), 1.0)
          << where() << " over " << (items[j].text + items[j].key).toStdString();
    }
  }
}

/// As it is drawn.
void expect_letters(const Item& item, const Pane& pane, const std::string& name) {
  const auto where = [&] { return name + " at " + name_of(pane) + ": " + item.text.toStdString(); };
  if (item.text.isEmpty() && item.key.isEmpty()) return;
  EXPECT_GE(item.size_px, pane.letters_px) << where();
  EXPECT_GE(item.size_px, 32) << where();
  const double unit = item.size_px / 32.0;
  QRectF room = item.rect;
  bool wraps = false;
  switch (item.kind) {
    case Item::Kind::words:
    case Item::Kind::cue:
      wraps = true;
      break;
    case Item::Kind::option:
      wraps = !item.key.isEmpty();
      if (wraps) room.adjust(72.0 * unit, 0.0, -12.0 * unit, 0.0);
      break;
    case Item::Kind::control:
      wraps = true;
      room.adjust(16.0 * unit, 0.0, -16.0 * unit, 0.0);
      room.adjust(0.0, 0.0,
                  -QFontMetricsF(participant_font(item.size_px, false)).horizontalAdvance(item.key),
                  0.0);
      break;
    case Item::Kind::picture:
      EXPECT_GE(item.side, 30.0) << where() << item.key.toStdString();
      return;
    case Item::Kind::chip:
    case Item::Kind::scale:
    case Item::Kind::line:
    case Item::Kind::pad:
    case Item::Kind::number:
    case Item::Kind::standard:
    case Item::Kind::field:
    case Item::Kind::workspace:
    case Item::Kind::surface:
    case Item::Kind::guide:
      break;
  }
  const QFontMetricsF metrics(
      participant_font(item.size_px, item.bold || item.kind == Item::Kind::control));
  QString text = item.text;
  if (item.kind == Item::Kind::chip && item.key.isEmpty()) text += QString::fromUtf8(" ✓");
  if (item.kind == Item::Kind::chip && !item.given.isEmpty()) text += "  " + item.given;
  const QRectF needed = metrics.boundingRect(QRectF(0.0, 0.0, wraps ? room.width() : 1e6, 1e6),
                                             wraps ? Qt::TextWordWrap : 0, text);
  EXPECT_LE(needed.height(), room.height() + 1.0) << where();
  EXPECT_LE(needed.width(), room.width() + 1.0) << where();
}

std::vector<Item> picture_items(const std::vector<Item>& items) {
  std::vector<Item> pictures{};
  for (const Item& item : items) {
    if (item.kind == Item::Kind::picture) pictures.push_back(item);
  }
  return pictures;
}

const Item* find(const std::vector<Item>& items, Item::Kind kind, const QString& text) {
  for (const Item& item : items) {
    if (item.kind == kind && item.text == text) return &item;
  }
  return nullptr;
}

TEST(ParticipantLayout, FitsEverySceneIntoEverySizeInLettersOf24PointsWithoutOverlap) {
  for (const char* const language : {"en", "de"}) {  // the longest
    apply_language(language);
    for (const auto& [name, scene] : every_scene()) {
      for (const Pane& pane : kPanes) {
        for (const auto& items : pages_of(scene, inputs_for(pane))) {
          expect_order(items, pane, name);
          for (const Item& item : items) expect_letters(item, pane, name);
        }
      }
    }
  }
  apply_language("en");
}

TEST(ParticipantLayout, FitsEverySceneIntoEverySizeForLeftHandedParticipants) {
  for (const auto& [name, scene] : every_scene()) {
    for (const Pane& pane : kPanes) {
      ParticipantLayoutInputs inputs = inputs_for(pane);
      inputs.mirrored = true;
      for (const auto& items : pages_of(scene, inputs)) expect_order(items, pane, name);
    }
  }
}

TEST(ParticipantLayout, DividesWordsThatDoNotFitAndLeavesNoneOut) {
  for (const Pane& pane : kPanes) {
    ParticipantScene scene = scenes::to_read();
    scene.text = scenes::sentences(40);
    const auto pages = pages_of(scene, inputs_for(pane));
    ASSERT_GT(pages.size(), 2U) << name_of(pane);
    QStringList read{};
    for (std::size_t i = 0; i < pages.size(); ++i) {
      const auto& items = pages[i];
      const QString number = QString("Page %1 of %2").arg(i + 1).arg(pages.size());
      ASSERT_NE(find(items, Item::Kind::words, number), nullptr) << number.toStdString();
      for (const Item& item : items) {
        if (item.kind == Item::Kind::words && item.text.startsWith("Sentence")) read << item.text;
      }
      EXPECT_EQ(find(items, Item::Kind::control, "Back") != nullptr, i > 0);
      const Item* on = find(items, Item::Kind::control, "Continue");
      ASSERT_NE(on, nullptr);
      EXPECT_TRUE(on->key == "Return" || on->key == "⏎");
      EXPECT_EQ(on->action->what == ParticipantAction::What::confirm, i + 1 == pages.size());
    }
    EXPECT_EQ(read.join(' ').toStdString() + ' ', scene.text) << name_of(pane);
    // Between sentences.
    for (const QString& part : read) EXPECT_TRUE(part.endsWith('.')) << part.toStdString();
  }
}

TEST(ParticipantLayout, DividesASentenceThatIsLongerThanAPageBetweenWords) {
  ParticipantScene scene = scenes::to_read();
  scene.text.clear();
  for (int i = 0; i < 300; ++i) scene.text += "word" + std::to_string(i) + ' ';
  QString read{};
  for (const auto& items : pages_of(scene, {.size = {683.0, 768.0}})) {
    for (const Item& item : items) {
      if (item.text.startsWith("word")) read += item.text + ' ';
    }
  }
  EXPECT_EQ(read.toStdString(), scene.text);
}

TEST(ParticipantLayout, AsksOnPagesOfItsOwnWhereAQuestionLeavesNoRoomForItsAnswers) {
  ParticipantScene scene = scenes::recognition(6);
  scene.text = scenes::sentences(6) + "Which of these did you feel?";
  const auto pages = pages_of(scene, {.size = {683.0, 768.0}});
  ASSERT_GT(pages.size(), 1U);
  for (std::size_t i = 0; i + 1 < pages.size(); ++i) {
    EXPECT_TRUE(picture_items(pages[i]).empty());
    EXPECT_EQ(find(pages[i], Item::Kind::control, "Confirm"), nullptr);
  }
  EXPECT_EQ(picture_items(pages.back()).size(), 6U);
  EXPECT_NE(find(pages.back(), Item::Kind::control, "Confirm"), nullptr);
  // What it comes to stands over the pictures.
  const auto asks = [](const Item& item) {
    return item.kind == Item::Kind::words && item.text.endsWith("Which of these did you feel?");
  };
  EXPECT_TRUE(std::any_of(pages.back().begin(), pages.back().end(), asks));
  EXPECT_EQ(picture_items(lay_out(scene, {.size = {683.0, 768.0}, .page = 0})).size(), 6U);
}

TEST(ParticipantLayout, ShowsEveryOptionOfALongListOnceAndTheChosenOnesPage) {
  ParticipantScene scene = scenes::form_choice();
  scene.choices.clear();
  for (int i = 1; i <= 20; ++i) {
    scene.choices.push_back(
        {.key = key_of_option(i),
         .text = "a rather long answer, which has the number " + std::to_string(i)});
  }
  ParticipantLayoutInputs inputs{.size = {683.0, 768.0}};
  std::vector<int> seen{};
  for (const auto& items : pages_of(scene, inputs)) {
    for (const Item& item : items) {
      if (item.kind == Item::Kind::option) seen.push_back(item.action->number);
    }
  }
  std::vector<int> all(20);
  std::iota(all.begin(), all.end(), 1);
  EXPECT_EQ(seen, all);
  for (const int chosen : all) {
    inputs.page = 0;
    for (ParticipantScene::Choice& choice : scene.choices) choice.chosen = false;
    scene.choices.at(static_cast<std::size_t>(chosen) - 1).chosen = true;
    const auto items = lay_out(scene, inputs);
    EXPECT_EQ(std::count_if(
                  items.begin(), items.end(),
                  [](const Item& item) { return item.kind == Item::Kind::option && item.chosen; }),
              1)
        << chosen;
  }
}

TEST(ParticipantLayout, ShowsAllThatMayBeTypedIntoANumber) {
  for (const Pane& pane : kPanes) {
    ParticipantLayoutInputs inputs = inputs_for(pane);
    inputs.draft.number = "-12345678901";
    for (const Item& item : lay_out(scenes::form_number(), inputs)) {
      expect_letters(item, pane, "number");
    }
  }
}

// 24/72 inch: the glass of each of these is measured in millimetres.
TEST(TypeSize, Is24PointsOnTheGlassAndNeverLessThan32Pixels) {
  const auto px = [](QSizeF size_px, QSizeF size_mm, double logical = 96.0) {
    return smallest_text_px({.size_px = size_px, .size_mm = size_mm, .logical_per_inch = logical});
  };
  EXPECT_DOUBLE_EQ(px({1920, 1080}, {531, 299}), 32.0);  // 24 inches: 92 per inch
  EXPECT_NEAR(px({1920, 1080}, {294, 165}), 1920 / 294.0 * 25.4 / 3.0, 0.2);  // 13.3 inches: 166
  EXPECT_NEAR(px({3840, 2160}, {597, 336}), 3840 / 597.0 * 25.4 / 3.0, 0.2);  // 27 inches: 163
  EXPECT_DOUBLE_EQ(px({1920, 1080}, {531, 299}, 144.0), 48.0);  // as the desktop was asked to
  EXPECT_DOUBLE_EQ(px({1920, 1080}, {160, 90}), 32.0);          // a television's proportions
  EXPECT_DOUBLE_EQ(px({1920, 1080}, {0, 0}), 32.0);             // a projector
  EXPECT_DOUBLE_EQ(px({3840, 2160}, {300, 300}), 32.0);         // cannot be
  EXPECT_DOUBLE_EQ(px({1920, 1080}, {1600, 900}), 32.0);        // seen from afar
}

TEST(ParticipantLayout, ShowsPicturesOfOneSizeAndLargeEnough) {
  for (const int count : {2, 3, 4, 5, 6, 8, 12, 16}) {
    for (const Pane& pane : kPanes) {
      const QSizeF size = pane.size;
      const auto pictures = picture_items(lay_out(scenes::recognition(count), inputs_for(pane, 0)));
      ASSERT_EQ(static_cast<int>(pictures.size()), count);
      for (const Item& picture : pictures) {
        EXPECT_EQ(picture.side, pictures.front().side);
        EXPECT_EQ(picture.rect.size(), pictures.front().rect.size());
      }
      // On usual screens three tenths of the window's height for up to six, a tenth at the very least.
      const bool usual = pane.letters_px * 768.0 / size.height() <= 32.0;
      if (!usual) continue;
      const double part = count <= 6 && size.width() > 1.1 * size.height() ? 0.29 : 0.085;
      EXPECT_GE(pictures.front().side, part * size.height()) << count << " at " << name_of(pane);
    }
  }
}

TEST(ParticipantLayout, MatchesTwelvePicturesOnHalfOfASmallScreenWithoutMakingThemTiny) {
  for (const bool german : {false, true}) {
    apply_language(german ? "de" : "en");
    for (const bool mirrored : {false, true}) {
      const ParticipantScene scene = scenes::matching(12);
      const auto items = lay_out(scene, {.size = {683.0, 700.0}, .mirrored = mirrored});
      const auto pictures = picture_items(items);
      ASSERT_EQ(pictures.size(), 12U);
      EXPECT_GE(pictures.front().side, 90.0);
      // Where there is room, they stand beside their surfaces as ever.
      const auto whole = lay_out(scene, {.size = {1366.0, 768.0}, .mirrored = mirrored});
      EXPECT_EQ(find(whole, Item::Kind::chip, "A")->rect.left(),
                find(whole, Item::Kind::chip, "B")->rect.left());
    }
  }
  apply_language("en");
}

TEST(ParticipantLayout, GivesACueAPlaceOfItsOwnAndMovesNothingForIt) {
  for (const QSizeF size :
       {QSizeF(683.0, 700.0), QSizeF(683.0, 768.0), QSizeF(960.0, 1016.0), QSizeF(1366.0, 768.0)}) {
    ParticipantScene scene = scenes::matching(6);
    scene.cue = "Please assign a picture to surface C first.";
    const auto quiet = lay_out(scene, {.size = size});
    const auto told = lay_out(scene, {.size = size, .cue_shown = true});
    const Item* cue = find(told, Item::Kind::cue, QString::fromStdString(scene.cue));
    ASSERT_NE(cue, nullptr);
    for (const Item& item : quiet) {
      if (item.text == "Block 3 of 6") continue;  // it may stand in its place
      EXPECT_FALSE(item.rect.intersects(cue->rect)) << item.text.toStdString();
      const auto same = [&](const Item& other) {
        return other.rect == item.rect && other.text == item.text && other.key == item.key;
      };
      EXPECT_TRUE(std::any_of(told.begin(), told.end(), same)) << item.text.toStdString();
    }
  }
}

TEST(ParticipantLayout, PutsSixPicturesIntoTwoFullRows) {
  const auto pictures = picture_items(lay_out(scenes::recognition(6), {}));
  EXPECT_EQ(pictures[0].rect.top(), pictures[2].rect.top());
  EXPECT_LT(pictures[2].rect.bottom(), pictures[3].rect.top());
  EXPECT_EQ(pictures[3].rect.left(), pictures[0].rect.left());
}

TEST(ParticipantLayout, MirrorsSurfacesAndControlsForLeftHandedParticipants) {
  const auto right = lay_out(scenes::matching(4), {});
  const auto left = lay_out(scenes::matching(4), {.mirrored = true});
  const double middle = 1366.0 / 2.0;
  EXPECT_LT(find(right, Item::Kind::chip, "A")->rect.right(), middle);
  EXPECT_GT(find(left, Item::Kind::chip, "A")->rect.left(), middle);
  EXPECT_GT(find(right, Item::Kind::control, "Confirm")->rect.left(), middle);
  EXPECT_LT(find(left, Item::Kind::control, "Confirm")->rect.right(), middle);
}

TEST(ParticipantLayout, SaysProgressByBlocksOnly) {
  const auto items = lay_out(scenes::recognition(6), {});
  EXPECT_NE(find(items, Item::Kind::words, "Block 3 of 6"), nullptr);
  EXPECT_EQ(find(lay_out(scenes::to_read(), {}), Item::Kind::words, "Block 0 of 0"), nullptr);
}

TEST(ParticipantLayout, SaysHowLongARestStillLasts) {
  const auto waiting = lay_out(scenes::rest(0), {.rest_left_s = 83});
  EXPECT_NE(find(waiting, Item::Kind::words, "You can continue in 1:23"), nullptr);
  EXPECT_FALSE(find(waiting, Item::Kind::control, "Continue")->ready);
  const auto over = lay_out(scenes::rest(0), {});
  EXPECT_NE(find(over, Item::Kind::words, "You can continue when you are ready."), nullptr);
  EXPECT_TRUE(find(over, Item::Kind::control, "Continue")->ready);
}

// Whatever the language of the windows is: here English.
TEST(ParticipantLayout, SpeaksTheLanguageOfTheProtocol) {
  ParticipantScene rest = scenes::rest(0);
  rest.language = "de";
  EXPECT_NE(find(lay_out(rest, {}), Item::Kind::control, "Weiter"), nullptr);
  rest.language = "de-AT";
  EXPECT_NE(find(lay_out(rest, {}), Item::Kind::control, "Weiter"), nullptr);
  rest.language = "fi";  // the program has no Finnish
  EXPECT_NE(find(lay_out(rest, {}), Item::Kind::control, "Continue"), nullptr);
  ParticipantScene number = scenes::form_number();
  number.language = "de";
  number.form = NumberForm{.minimum = 0.5, .maximum = 120.0};
  EXPECT_NE(find(lay_out(number, {}), Item::Kind::words, "Von 0,5 bis 120"), nullptr);
}

TEST(ParticipantLayout, GivesEveryThingThatCanBePressedAKey) {
  for (const auto& [name, scene] : scenes::all()) {
    for (const Item& item : lay_out(scene, {})) {
      if (!item.action) continue;
      if (item.kind == Item::Kind::scale) {  // its mark is moved, and others are reached
        EXPECT_TRUE(action_of_key(scene, Qt::Key_Right, {})) << name;
        EXPECT_TRUE(action_of_key(scene, Qt::Key_Down, {})) << name;
        continue;
      }
      if (item.kind == Item::Kind::line) {  // its end is moved
        EXPECT_TRUE(action_of_key(scene, Qt::Key_Right, {})) << name;
        EXPECT_TRUE(action_of_key(scene, Qt::Key_Left, {})) << name;
        continue;
      }
      QString key = item.key.isEmpty() ? item.text : item.key;
      int code = key.size() == 1 ? key.front().toUpper().unicode() : 0;
      if (key == "Return") code = Qt::Key_Return;
      if (key == "Space") code = Qt::Key_Space;
      if (item.action->what == ParticipantAction::What::erase) code = Qt::Key_Backspace;
      if (item.action->text == "-") key = "-";
      // Keys of two digits are typed one after the other.
      if (key.size() == 2) continue;
      const auto action = action_of_key(scene, code, code == Qt::Key_Return ? "\r" : key);
      ASSERT_TRUE(action) << name << ": " << key.toStdString();
      EXPECT_EQ(action->what, item.action->what) << name << ": " << key.toStdString();
      EXPECT_EQ(action->number, item.action->number) << name << ": " << key.toStdString();
      EXPECT_EQ(action->text, item.action->text) << name << ": " << key.toStdString();
    }
  }
}

TEST(ParticipantLayout, HasNothingToPressWhereNothingIsToBeDone) {
  for (const auto& [name, scene] : scenes::all()) {
    if (name != "blank" && name != "feedback" && name != "paused" && name != "ended") continue;
    for (const Item& item : lay_out(scene, {})) EXPECT_FALSE(item.action) << name;
    EXPECT_FALSE(action_of_key(scene, Qt::Key_Return, "\r")) << name;
    EXPECT_FALSE(action_of_key(scene, Qt::Key_1, "1")) << name;
  }
}

// By mouse the participant has to see where the surface is, and to press there and on nothing else.
TEST(ParticipantLayout, ShowsTheSurfaceOfAMouseAndLaysNothingOverIt) {
  int shown = 0;
  for (const auto& [name, scene] : scenes::all()) {
    if (scene.kind != ParticipantScene::Kind::feel || scene.show_workspace) continue;
    ++shown;
    ParticipantLayoutInputs inputs{};
    const auto surfaces_in = [](const std::vector<Item>& items) {
      return std::count_if(items.begin(), items.end(),
                           [](const Item& item) { return item.kind == Item::Kind::surface; });
    };
    EXPECT_EQ(surfaces_in(lay_out(scene, inputs)), 0) << name << ": felt with a device";
    inputs.surface_aspect = 1.5;
    const std::vector<Item> items = lay_out(scene, inputs);
    ASSERT_EQ(surfaces_in(items), 1) << name;
    const Item& surface = *std::find_if(items.begin(), items.end(), [](const Item& item) {
      return item.kind == Item::Kind::surface;
    });
    EXPECT_NEAR(surface.rect.width() / surface.rect.height(), 1.5, 0.02) << name;
    EXPECT_GT(surface.rect.height(), 150.0) << name;
    EXPECT_FALSE(surface.action) << name;
    for (const Item& item : items) {
      if (&item == &surface) continue;
      EXPECT_FALSE(item.rect.intersects(surface.rect)) << name << ": " << item.text.toStdString();
    }
    EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const Item& item) {
      return item.text.startsWith("Keep the left mouse button pressed on the surface");
    })) << name;
  }
  EXPECT_GT(shown, 0);
}

}  // namespace
}  // namespace asperity
