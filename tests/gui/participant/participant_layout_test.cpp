#include "app/gui/participant/participant_layout.h"

#include <QtGui/QFontMetricsF>
#include <gtest/gtest.h>

#include "tests/gui/participant/scenes.h"

namespace asperity {
namespace {

using Item = ParticipantItem;

const std::vector<QSizeF> kSizes = {
    {1366.0, 768.0}, {1920.0, 1080.0}, {683.0, 768.0}, {960.0, 1080.0}};

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

TEST(ParticipantLayout, FitsEverySceneIntoEverySizeWithoutOverlap) {
  for (const auto& [name, scene] : scenes::all()) {
    for (const QSizeF size : kSizes) {
      for (const bool mirrored : {false, true}) {
        const std::vector<Item> items =
            lay_out(scene, {.size = size, .mirrored = mirrored, .cue_shown = true});
        const QRectF page(QPointF(), size);
        for (std::size_t i = 0; i < items.size(); ++i) {
          const auto where = [&] {
            return name + " at " + std::to_string(size.width()) + ": " +
                   (items[i].text + items[i].key).toStdString();
          };
          EXPECT_TRUE(page.contains(items[i].rect)) << where();
          EXPECT_GT(items[i].rect.width(), 40.0) << where();
          EXPECT_GT(items[i].rect.height(), 30.0) << where();
          for (std::size_t j = 0; j < i; ++j) {
            const QRectF common = items[i].rect.intersected(items[j].rect);
            EXPECT_LT(common.width() * common.height(), 1.0)
                << where() << " over " << (items[j].text + items[j].key).toStdString();
          }
        }
      }
    }
  }
}

TEST(ParticipantLayout, KeepsLettersAt24PointsAndInsideTheirPlace) {
  for (const auto& [name, scene] : scenes::all()) {
    for (const QSizeF size : kSizes) {
      for (const Item& item : lay_out(scene, {.size = size, .cue_shown = true})) {
        if (item.text.isEmpty()) continue;
        EXPECT_GE(item.size_px, 32) << name << ": " << item.text.toStdString();
        const QFontMetricsF metrics(participant_font(item.size_px, item.bold));
        if (item.kind == Item::Kind::words) {
          const QRectF needed = metrics.boundingRect(QRectF(0.0, 0.0, item.rect.width(), 1e6),
                                                     Qt::TextWordWrap, item.text);
          EXPECT_LE(needed.height(), item.rect.height() + 1.0)
              << name << ": " << item.text.toStdString();
        } else {
          const bool has_circle = item.kind == Item::Kind::option && !item.key.isEmpty();
          const double circle = has_circle ? 84.0 * item.size_px / 32.0 : 0.0;
          EXPECT_LE(metrics.horizontalAdvance(item.text) + circle, item.rect.width())
              << name << " at " << size.width() << ": " << item.text.toStdString();
        }
      }
    }
  }
}

TEST(ParticipantLayout, ShowsPicturesOfOneSizeAndLargeEnough) {
  for (const int count : {2, 3, 4, 5, 6, 8, 12}) {
    for (const QSizeF size : kSizes) {
      const auto pictures = picture_items(lay_out(scenes::recognition(count), {.size = size}));
      ASSERT_EQ(static_cast<int>(pictures.size()), count);
      for (const Item& picture : pictures) {
        EXPECT_EQ(picture.side, pictures.front().side);
        EXPECT_EQ(picture.rect.size(), pictures.front().rect.size());
      }
      // Three tenths of the window's height for up to six, a tenth at the very least.
      const double part = count <= 6 && size.width() > size.height() ? 0.29 : 0.1;
      EXPECT_GE(pictures.front().side, part * size.height()) << count << " at " << size.width();
    }
  }
}

TEST(ParticipantLayout, PutsSixPicturesIntoTwoFullRows) {
  const auto pictures = picture_items(lay_out(scenes::recognition(6), {}));
  EXPECT_EQ(pictures[0].rect.top(), pictures[2].rect.top());
  EXPECT_LT(pictures[2].rect.bottom(), pictures[3].rect.top());
  EXPECT_EQ(pictures[3].rect.left(), pictures[0].rect.left());
}

TEST(ParticipantLayout, MirrorsSurfacesAndControlsForLeftHandedPeople) {
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
  EXPECT_NE(find(waiting, Item::Kind::words, "You can go on in 1:23"), nullptr);
  EXPECT_FALSE(find(waiting, Item::Kind::control, "Go on")->ready);
  const auto over = lay_out(scenes::rest(0), {});
  EXPECT_NE(find(over, Item::Kind::words, "You can go on when you are ready."), nullptr);
  EXPECT_TRUE(find(over, Item::Kind::control, "Go on")->ready);
}

TEST(ParticipantLayout, GivesEveryThingThatCanBePressedAKey) {
  for (const auto& [name, scene] : scenes::all()) {
    for (const Item& item : lay_out(scene, {})) {
      if (!item.action) continue;
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

}  // namespace
}  // namespace asperity
