// The form of a protocol: its fields as a researcher uses them, the text that follows, and undo.

#include "app/gui/editor/form/protocol_form.h"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QCompleter>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableWidget>
#include <QtWidgets/QToolButton>
#include <nlohmann/json.hpp>

#include "app/gui/base/settings.h"
#include "app/gui/editor/form/text_card.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/protocol_views.h"
#include "protocols/file/json_document.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/form/form_pages.h"
#include "tests/gui/editor/form_of_protocol.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using nlohmann::json;

/// Names a control with the focus, for messages.
std::string focus_text() {
  const QWidget* const focused = QApplication::focusWidget();
  if (focused == nullptr) return "nothing";
  return std::string(focused->metaObject()->className()) + " " +
         focused->objectName().toStdString() + " " + focused->accessibleName().toStdString();
}

TEST_F(FormOfProtocol, WritesANumberInTheUnitOfTheFile) {
  const std::string before = library_text("amplitude_jnd");
  open(before);
  const std::string amplitude = "/stimuli/grating/parameters/amplitude_m";
  EXPECT_EQ(control<QLineEdit>(amplitude).text(), "50");
  EXPECT_EQ(control<QLineEdit>(amplitude).accessibleName(), "Amplitude");
  type_into(amplitude, "2.5");
  EXPECT_EQ(text(), replaced(before, "5e-05", "0.0000025"));
  undo();
  EXPECT_EQ(text(), before);  // also the notation of the number, in one step
  const std::string length = "/explorations/stroking/stroke_length_m/target";
  EXPECT_EQ(control<QLineEdit>(length).text(), "60");
  type_into(length, "65,5");
  EXPECT_EQ(text(), replaced(before, "\"target\": 0.06, \"maximum\": 0.08",
                             "\"target\": 0.0655, \"maximum\": 0.08"));
}

TEST_F(FormOfProtocol, UndoesAlsoWhatWasTypedInAFieldThatWasLeftAndInATextThatWasSaved) {
  open(library_text("amplitude_jnd"));
  views_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&views_));
  const auto friction = [this] { return tree()["material"]["friction"]; };
  const auto type_at_end = [this](const char* digit) {
    auto& field = control<QLineEdit>("/material/friction");
    field.setFocus();
    field.end(false);
    QTest::keyClicks(&field, digit);
  };
  type_at_end("1");
  control<QLineEdit>("/title").setFocus();
  type_at_end("2");
  EXPECT_EQ(friction(), 0.212);
  undo();
  EXPECT_EQ(friction(), 0.21) << "before the field was left";
  type_at_end("3");
  views_.text().document()->setModified(false);  // saved
  type_at_end("4");
  EXPECT_EQ(friction(), 0.2134);
  undo();
  EXPECT_EQ(friction(), 0.213) << "as it was saved";
}

TEST_F(FormOfProtocol, KeepsWhatIsTypedInPlaceOfANumberAndIsNone) {
  const std::string before = library_text("amplitude_jnd");
  open(before);
  type_into("/material/friction", "0.x");
  EXPECT_EQ(text(), replaced(before, "\"friction\": 0.2", "\"friction\": \"0.x\""));
  type_into("/title", "Another title");
  EXPECT_EQ(control<QLineEdit>("/material/friction").text(), "0.x") << "after another edit";
  type_into("/material/friction", "0.");
  EXPECT_EQ(tree()["material"]["friction"], 0) << "a point that decimals follow is none";
  QTest::keyClicks(&control<QLineEdit>("/material/friction"), "3");
  EXPECT_EQ(tree()["material"]["friction"], 0.3);
  for (int step = 0; step < 3; ++step) undo();
  EXPECT_EQ(text(), before);
}

TEST_F(FormOfProtocol, KeepsWhatIsNoneInAListAnIntervalAndAParameter) {
  const std::string interval = "\"interval_s\": {\"shortest\": 0.8, \"longest\": 1.2}";
  open(replaced(library_text("amplitude_jnd"), interval, "\"interval_s\": 1"));
  struct Typed {
    std::string pointer{};
    QString typed{};
    json written{};
  };
  const std::vector<Typed> all{
      {"/surface/extent_m", "80; b", json::array({0.08, "b"})},
      {"/stimuli/grating/parameters/amplitude_m", "50u", "50u"},
      {"/blocks/practice/arrangement/interval_s", "abc", "abc"},
  };
  for (const Typed& one : all) {
    type_into(one.pointer, one.typed);
    EXPECT_EQ(tree().at(json::json_pointer(one.pointer)), one.written);
  }
  for (const Typed& one : all) {
    EXPECT_EQ(control<QLineEdit>(one.pointer).text(), one.typed) << one.pointer;
  }
}

TEST_F(FormOfProtocol, LeavesWhatIsBeingTypedWhenACheckArrives) {
  open(library_text("amplitude_jnd"));
  auto& friction = control<QLineEdit>("/material/friction");
  friction.setFocus();
  friction.selectAll();
  QTest::keyClicks(&friction, "0.");
  views_.show_problems({}, {});
  QTest::keyClicks(&friction, "5");
  EXPECT_EQ(friction.text(), "0.5");
  EXPECT_EQ(tree()["material"]["friction"], 0.5);
}

TEST_F(FormOfProtocol, KeepsTheRowOfAValueThatWasEmptied) {
  const std::string before = library_text("amplitude_jnd");
  open(before);
  form().show_page("order");
  QApplication::processEvents();
  auto& trials =
      static_cast<QLineEdit&>(*child<FormPart>(form(), "/resume/practice_trials").focusProxy());
  trials.setFocus();
  trials.selectAll();
  QTest::keyClick(&trials, Qt::Key_Backspace);
  EXPECT_FALSE(tree()["resume"].contains("practice_trials"));
  QTest::keyClicks(QApplication::focusWidget(), "3");
  EXPECT_EQ(tree(), json::parse(before));
}

TEST_F(FormOfProtocol, SurvivesARemovalWhileANameIsTyped) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/textures/stone/code"), nullptr);
  auto& name =
      static_cast<QLineEdit&>(*child<FormPart>(form(), "name:/textures/stone").focusProxy());
  name.setFocus();
  name.selectAll();
  QTest::keyClicks(&name, "rock");
  click("remove:/textures/wood");
  EXPECT_TRUE(tree()["textures"].contains("rock"));
  EXPECT_FALSE(tree()["textures"].contains("wood"));
}

TEST_F(FormOfProtocol, CanBeClosedWhileANameIsTyped) {
  auto views = std::make_unique<ProtocolViews>(declarations_of(built_in_models()));
  views->text().setPlainText(QString::fromStdString(library_text("semantic_differential")));
  views->show();
  views->show_form_if_possible();
  auto& opened = child<ProtocolForm>(*views, "editor_form");
  opened.go_to("/textures/stone/code");
  QApplication::processEvents();
  auto& name =
      static_cast<QLineEdit&>(*child<FormPart>(opened, "name:/textures/stone").focusProxy());
  name.setFocus();
  name.selectAll();
  QTest::keyClicks(&name, "rock");
  int changes = 0;
  QObject::connect(views->text().document(), &QTextDocument::contentsChanged, [&] { ++changes; });
  views.reset();
  EXPECT_EQ(changes, 0) << "to close a form is no edit";
}

TEST_F(FormOfProtocol, WritesATypedNameBeforeItIsLeft) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/textures/stone/code"), nullptr);
  auto& name =
      static_cast<QLineEdit&>(*child<FormPart>(form(), "name:/textures/stone").focusProxy());
  name.setFocus();
  name.selectAll();
  QTest::keyClicks(&name, "rock");
  views_.commit();
  EXPECT_TRUE(tree()["textures"].contains("rock"));
}

TEST_F(FormOfProtocol, ShowsNoFieldsOfATextThatIsNoObject) {
  open(library_text("amplitude_jnd"));
  ASSERT_NE(part("/title"), nullptr);
  views_.text().replace_text("[]");
  EXPECT_FALSE(form().can_be_edited());
  form().show_page("task");
  views_.text().undo();
  EXPECT_TRUE(form().can_be_edited());
  EXPECT_TRUE(control<QLineEdit>("/title").isEnabled());
}

TEST_F(FormOfProtocol, StatesAndRemovesASettingThatHasADefault) {
  const std::string before = library_text("amplitude_jnd");
  open(before);
  const std::string feedback = "/blocks/comparisons/feedback";
  choose(feedback, "correctness");
  EXPECT_EQ(tree()["blocks"]["comparisons"]["feedback"], "correctness");
  choose(feedback, "none");
  EXPECT_EQ(text(), before);
  type_into("/blocks/comparisons/response_deadline_s", "8");
  EXPECT_EQ(tree()["blocks"]["comparisons"]["response_deadline_s"], 8);
  auto& deadline = control<QLineEdit>("/blocks/comparisons/response_deadline_s");
  deadline.selectAll();
  QTest::keyClick(&deadline, Qt::Key_Backspace);
  EXPECT_EQ(text(), before);
}

TEST_F(FormOfProtocol, AddsAScaleWithANameOfItsOwn) {
  const std::string before = library_text("semantic_differential");
  open(before);
  ASSERT_NE(part("/blocks/ratings/questions"), nullptr);
  click("add:/blocks/ratings/questions");
  EXPECT_EQ(tree()["blocks"]["ratings"]["questions"].size(), 9U);
  EXPECT_EQ(tree()["blocks"]["ratings"]["questions"][8]["name"], "wet_2");
  type_into("/blocks/ratings/questions/8/scale/labels/0", "matte");
  EXPECT_EQ(tree()["blocks"]["ratings"]["questions"][8]["scale"]["labels"][0], "matte");
  click_named("Move “wet_2” up");
  EXPECT_EQ(tree()["blocks"]["ratings"]["questions"][7]["name"], "wet_2");
  click_named("Remove “wet_2”");
  EXPECT_EQ(text(), before);
}

TEST_F(FormOfProtocol, MovesDuplicatesAndRemovesTheEntryWithTheFocusByKeys) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/blocks/ratings/questions/1"), nullptr);
  const auto names = [this] {
    std::string all{};
    const json file = tree();
    for (const json& question : file["blocks"]["ratings"]["questions"]) {
      all += question["name"].get<std::string>() + " ";
    }
    return all;
  };
  int duplicating = 0;
  for (QToolButton* const button : form().findChildren<QToolButton*>()) {
    if (!button->isVisible() || !button->accessibleName().startsWith("Duplicate “")) continue;
    EXPECT_EQ(button->toolTip(), button->accessibleName() + " (Alt+Shift+D)");
    ++duplicating;
  }
  EXPECT_GT(duplicating, 0);
  const auto press = [](Qt::Key key) {
    QTest::keyClick(QApplication::focusWidget(), key, Qt::AltModifier | Qt::ShiftModifier);
    QApplication::processEvents();
  };
  const std::string before = text();
  control<QLineEdit>("/blocks/ratings/questions/1/name").setFocus();
  press(Qt::Key_Down);
  EXPECT_EQ(names(), "rough slippery bumpy hot irregular coarse hard wet ");
  press(Qt::Key_Down);
  EXPECT_EQ(names(), "rough slippery hot bumpy irregular coarse hard wet ") << "the focus follows";
  press(Qt::Key_D);
  press(Qt::Key_Up);
  EXPECT_EQ(names(), "rough slippery hot bumpy_2 bumpy irregular coarse hard wet ");
  press(Qt::Key_Delete);
  EXPECT_EQ(names(), "rough slippery hot bumpy irregular coarse hard wet ");
  for (int step = 0; step < 5; ++step) undo();
  EXPECT_EQ(text(), before);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(views_.text().isVisible());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(form().isVisible());
}

TEST_F(FormOfProtocol, KeepsTheFocusWhereTickedEntriesAreChangedByKeys) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/blocks/ratings/questions/1"), nullptr);
  const auto names = [this] {
    std::string all{};
    const json file = tree();
    for (const json& question : file["blocks"]["ratings"]["questions"]) {
      all += question["name"].get<std::string>() + " ";
    }
    return all;
  };
  const auto box = [this](const QString& name) -> QCheckBox* {
    for (QCheckBox* const each : form().findChildren<QCheckBox*>()) {
      if (each->isVisible() && each->accessibleName() == "Choose “" + name + "”") return each;
    }
    throw std::runtime_error("no box of " + name.toStdString());
  };
  const auto press = [](Qt::Key key) {
    QTest::keyClick(QApplication::focusWidget(), key, Qt::AltModifier | Qt::ShiftModifier);
    QApplication::processEvents();
  };
  box("rough")->click();
  box("slippery")->click();
  box("slippery")->setFocus();
  press(Qt::Key_D);
  EXPECT_EQ(names(), "rough rough_2 bumpy slippery slippery_2 hot irregular coarse hard wet ");
  press(Qt::Key_Up);
  EXPECT_EQ(names(), "rough rough_2 bumpy slippery_2 slippery hot irregular coarse hard wet ")
      << "the focus is on the copy, which is not ticked";
  box("slippery")->setFocus();
  press(Qt::Key_Delete);
  EXPECT_EQ(names(), "rough_2 bumpy slippery_2 hot irregular coarse hard wet ");
  press(Qt::Key_Delete);
  EXPECT_EQ(names(), "rough_2 bumpy slippery_2 irregular coarse hard wet ")
      << "the focus is on the entry after the one that is gone";
}

TEST_F(FormOfProtocol, MovesDuplicatesAndRemovesSeveralAtOnce) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/blocks/ratings/questions"), nullptr);
  const auto names = [this] {
    std::string all{};
    const json file = tree();
    for (const json& question : file["blocks"]["ratings"]["questions"]) {
      all += question["name"].get<std::string>() + " ";
    }
    return all;
  };
  const auto tick = [this](const QString& name) {
    for (QCheckBox* const box : form().findChildren<QCheckBox*>()) {
      if (box->isVisible() && box->accessibleName() == "Choose “" + name + "”") box->click();
    }
  };
  tick("bumpy");
  tick("slippery");
  click_named("Move “bumpy” down");
  EXPECT_EQ(names(), "rough hot bumpy slippery irregular coarse hard wet ");
  click_named("Move “slippery” down");  // both are still ticked
  EXPECT_EQ(names(), "rough hot irregular bumpy slippery coarse hard wet ");
  click_named("Duplicate “slippery”");
  EXPECT_EQ(names(), "rough hot irregular bumpy bumpy_2 slippery slippery_2 coarse hard wet ");
  click_named("Remove “bumpy”");
  EXPECT_EQ(names(), "rough hot irregular bumpy_2 slippery_2 coarse hard wet ");
}

TEST_F(FormOfProtocol, RenamesATextureWithItsReferences) {
  const std::string before = library_text("semantic_differential");
  open(before);
  ASSERT_NE(part("/textures/cones_05/code"), nullptr);
  const auto& name = child<FormPart>(form(), "name:/textures/cones_05");
  auto& line = static_cast<QLineEdit&>(*name.focusProxy());
  line.setFocus();
  line.selectAll();
  QTest::keyClicks(&line, "fine_cones");
  EXPECT_EQ(text(), before);  // a name that is not complete is written nowhere
  QTest::keyClick(&line, Qt::Key_Return);
  EXPECT_EQ(text().find("\"cones_05\""), std::string::npos);
  EXPECT_EQ(tree()["factors"]["texture"]["levels"][4], "fine_cones");
}

/// Two groups, of which one reads a text of its own.
std::string with_groups() {
  json file = json::parse(library_text("amplitude_jnd"));
  file["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
  file["groups"] = {{"factor", "training"}};
  file["flow"][0]["groups"] = {"haptic"};
  return file.dump(1);
}

TEST_F(FormOfProtocol, RenamesALevelWithItsReferences) {
  open(with_groups());
  type_into("/factors/training/levels/0", "by hand");
  EXPECT_EQ(tree()["factors"]["training"]["levels"][0], "haptic") << "not complete";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(tree()["factors"]["training"]["levels"][0], "by hand");
  EXPECT_EQ(tree()["flow"][0]["groups"][0], "by hand");
}

/// Without the level of one texture.
std::string with_unused_texture() {
  json file = json::parse(library_text("semantic_differential"));
  auto& levels = file["factors"]["texture"]["levels"];
  levels.erase(std::find(levels.begin(), levels.end(), "cones_05"));
  return file.dump(1);
}

TEST_F(FormOfProtocol, TakesATextureForALevelFromThoseThatContainWhatIsTyped) {
  open(with_unused_texture());
  const json before = tree();
  const std::string level = "/factors/texture/levels/0";
  type_into(level, "CONES_");
  auto& line = control<QLineEdit>(level);
  const QAbstractItemModel& offered = *line.completer()->completionModel();
  const auto row_of = [&offered](const QString& name) {
    return offered.match(offered.index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly);
  };
  EXPECT_TRUE(row_of("metal").empty());
  ASSERT_FALSE(row_of("cones_05").empty());
  emit line.completer()->activated(QString("cones_05"));
  QApplication::processEvents();
  EXPECT_EQ(tree()["factors"]["texture"]["levels"][0], "cones_05");
  EXPECT_EQ(tree()["textures"], before["textures"]);
  QString refusal{};
  QObject::connect(&form(), &ProtocolForm::edit_refused, &form(),
                   [&refusal](const QString& why) { refusal = why; });
  emit line.completer()->activated(QString("cones_35"));  // another level has this name
  QApplication::processEvents();
  EXPECT_EQ(line.text(), "cones_05");
  EXPECT_TRUE(refusal.startsWith("Surfaces › Factors › texture › Levels")) << refusal.toStdString();
  const auto& at_field = child<QLabel>(*part(level), "form_problem");
  EXPECT_TRUE(at_field.isVisible());
  EXPECT_TRUE(at_field.text().contains("cones_35")) << at_field.text().toStdString();
  type_into(level, "leather");  // no texture is renamed
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(tree()["factors"]["texture"]["levels"][0], "leather");
  EXPECT_FALSE(at_field.isVisible());
  EXPECT_EQ(tree()["textures"], before["textures"]);
  undo();
  undo();
  EXPECT_EQ(tree(), before);
}

// The line shows the name, so it is that of the level from then on.
TEST_F(FormOfProtocol, WritesAHighlightedNameWhenItIsLeft) {
  open(with_unused_texture());
  type_into("/factors/texture/levels/0", "05");
  auto& line = control<QLineEdit>("/factors/texture/levels/0");
  QTest::keyClick(&line, Qt::Key_Down);
  QTest::keyClick(line.completer()->popup(), Qt::Key_Down);
  while (line.text() != "cones_05" && line.completer()->popup()->currentIndex().isValid()) {
    QTest::keyClick(line.completer()->popup(), Qt::Key_Down);
  }
  EXPECT_EQ(line.text(), "cones_05");
  QTest::keyClick(line.completer()->popup(), Qt::Key_Escape);
  QApplication::processEvents();
  QTest::keyClick(&line, Qt::Key_Tab);
  EXPECT_EQ(tree()["factors"]["texture"]["levels"][0], "cones_05");
}

TEST_F(FormOfProtocol, MakesALevelANumberWhereNothingRefersToIt) {
  open(with_groups());
  type_into("/factors/training/levels/1", "3");
  const QWidget* const field = QApplication::focusWidget();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(tree()["factors"]["training"]["levels"], json::parse(R"(["haptic", 3])"));
  EXPECT_EQ(QApplication::focusWidget(), field) << "made again";
  EXPECT_EQ(control<QLineEdit>("/factors/training/levels/1").text(), "3");
  EXPECT_GE(control<QComboBox>("/flow/0/groups/0").findData("3"), 0);
  type_into("/factors/training/levels/1", "touch");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  type_into("/factors/training/levels/0", "1");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(tree()["factors"]["training"]["levels"], json::parse(R"(["1", "touch"])"));
  EXPECT_EQ(tree()["flow"][0]["groups"], json::parse(R"(["1"])"));
}

TEST_F(FormOfProtocol, ShowsAndAddsTheGroupsOfAScreen) {
  open(with_groups());
  form().show_page("order");
  QApplication::processEvents();
  EXPECT_TRUE(child<QFrame>(form(), "card:/flow/0").findChildren<QLabel*>().size() > 0);
  std::string words{};
  for (const QLabel* const label : child<QFrame>(form(), "card:/flow/0").findChildren<QLabel*>()) {
    words += label->text().toStdString() + "|";
  }
  EXPECT_NE(words.find("haptic · "), std::string::npos) << words;
  std::size_t screen = 1;
  while (!tree()["flow"][screen].contains("screen")) ++screen;
  const std::string step = "/flow/" + std::to_string(screen);
  ASSERT_NE(part(step + "/screen"), nullptr);
  click("add:" + step + "/groups");  // not folded: a screen has few settings
  EXPECT_EQ(tree()["flow"][screen]["groups"], json::parse(R"(["visual"])"));
  choose(step + "/groups/0", "haptic");
  EXPECT_EQ(tree()["flow"][screen]["groups"], json::parse(R"(["haptic"])"));
}

TEST_F(FormOfProtocol, OffersWhatAPageIsNamedAfterWithoutUnfoldingSettings) {
  for (const LibraryProtocol& library : library_protocols()) {
    json protocol = json::parse(library.text);
    for (const auto& [page, key] : {std::pair("order", "groups"),
                                    {"participant", "participants"},
                                    {"device", "device"},
                                    {"analysis", "analysis"}}) {
      protocol.erase(key);
      open(protocol.dump());
      form().show_page(page);
      QApplication::processEvents();
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of what was made again
      const std::string name = std::string("add:/") + key;
      EXPECT_TRUE(child<QWidget>(form(), name.c_str()).isVisible()) << library.name << " " << key;
    }
  }
}

TEST_F(FormOfProtocol, MakesAFactorForGroups) {
  open(library_text("amplitude_jnd"));
  form().show_page("order");
  QApplication::processEvents();
  click("add:/groups");
  EXPECT_EQ(tree()["groups"]["factor"], "group") << "groups begin with a factor";
  for (QPushButton* const button : part("/groups/factor")->findChildren<QPushButton*>()) {
    EXPECT_EQ(button->text(), "New factor…");
    QTest::keyClick(button, Qt::Key_Space);
  }
  QApplication::processEvents();
  QApplication::processEvents();
  EXPECT_EQ(tree()["groups"]["factor"], "group_2");
  EXPECT_EQ(tree()["factors"]["group_2"]["levels"], json::parse(R"(["group_1", "group_2"])"));
  EXPECT_EQ(form().page().id, "surfaces");
  EXPECT_EQ(QApplication::focusWidget(), part("/factors/group_2/levels/0")->focusProxy())
      << focus_text();
  click("add:/factors/group_2/levels");
  EXPECT_EQ(tree()["factors"]["group_2"]["levels"][2], "group_3");
}

TEST_F(FormOfProtocol, KeepsAnEntryOpenWhenItIsRenamed) {
  int renamed = 0;
  for (const LibraryProtocol& library : library_protocols()) {
    const json file = json::parse(library.text);
    for (const char* const registry :
         {"textures", "bodies", "stimuli", "factors", "explorations", "blocks", "questions"}) {
      if (!file.contains(registry)) continue;
      const std::string list = "/" + std::string(registry);
      const std::string key = file[registry].items().begin().key();
      SCOPED_TRACE(std::string(library.name) + " " + list + "/" + key);
      open(std::string(library.text));
      form().go_to(list + "/" + key);
      QApplication::processEvents();
      auto& name = child<FormPart>(form(), ("name:" + list + "/" + key).c_str());
      name.focusProxy()->setFocus();
      static_cast<QLineEdit&>(*name.focusProxy()).selectAll();
      QTest::keyClicks(QApplication::focusWidget(), "other_name");
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      EXPECT_FALSE(QApplication::focusWidget()->objectName().startsWith("remove"));
      QApplication::processEvents();
      ASSERT_TRUE(tree()[registry].contains("other_name"));
      const std::string entry = list + "/other_name";
      const auto& card = child<QWidget>(form(), ("card:" + entry).c_str());
      const auto& key_field = child<FormPart>(form(), ("name:" + entry).c_str());
      EXPECT_TRUE(key_field.isVisible());
      EXPECT_TRUE(card.isAncestorOf(QApplication::focusWidget())) << focus_text();
      EXPECT_FALSE(key_field.isAncestorOf(QApplication::focusWidget())) << focus_text();
      EXPECT_TRUE(QApplication::focusWidget()->accessibleName() != "Fold “other_name”" &&
                  !QApplication::focusWidget()->objectName().startsWith("remove"))
          << focus_text();
      undo();
      QApplication::processEvents();
      EXPECT_EQ(text(), library.text);
      EXPECT_TRUE(child<FormPart>(form(), ("name:" + list + "/" + key).c_str()).isVisible());
      ++renamed;
    }
  }
  EXPECT_GE(renamed, 40);
}

TEST_F(FormOfProtocol, KeepsTheFocusInANameThatIsConfirmed) {
  open(library_text("amplitude_jnd"));
  ASSERT_NE(part("/blocks/practice"), nullptr);
  auto& name =
      static_cast<QLineEdit&>(*child<FormPart>(form(), "name:/blocks/practice").focusProxy());
  name.setFocus();
  name.selectAll();
  QTest::keyClicks(&name, "training");
  QTest::keyClick(&name, Qt::Key_Return);
  QApplication::processEvents();
  const auto& renamed = child<FormPart>(form(), "name:/blocks/training");
  EXPECT_TRUE(renamed.isAncestorOf(QApplication::focusWidget())) << focus_text();
}

TEST_F(FormOfProtocol, NeverGivesTheFocusToAButtonThatRemoves) {
  open(library_text("semantic_differential"));
  ASSERT_NE(part("/textures/stone/code"), nullptr);
  auto& remove = child<QToolButton>(form(), "remove:/textures/stone");
  remove.setFocus();
  QTest::keyClick(&remove, Qt::Key_Space);
  EXPECT_FALSE(tree()["textures"].contains("stone"));
  EXPECT_FALSE(QApplication::focusWidget()->objectName().startsWith("remove")) << focus_text();
  QApplication::processEvents();
  EXPECT_FALSE(QApplication::focusWidget()->objectName().startsWith("remove")) << focus_text();
  // In a list the next entry is at the place of the one that is gone.
  ASSERT_NE(part("/blocks/ratings/questions/1/name"), nullptr);
  auto& of_list = child<QToolButton>(form(), "remove:/blocks/ratings/questions/1");
  of_list.setFocus();
  QTest::keyClick(&of_list, Qt::Key_Space);
  QApplication::processEvents();
  EXPECT_EQ(QApplication::focusWidget()->objectName(), "choose:/blocks/ratings/questions/1");
}

TEST_F(FormOfProtocol, ShowsTheLastStateOfATextThatCannotBeRead) {
  const std::string before = library_text("amplitude_jnd");
  open(before);
  ASSERT_NE(part("/title"), nullptr);
  views_.text().setPlainText(QString::fromStdString(replaced(before, "\"title\":", "\"title\"")));
  EXPECT_FALSE(form().can_be_edited());
  EXPECT_FALSE(control<QLineEdit>("/title").isEnabled());
  EXPECT_TRUE(child<QLabel>(form(), "form_state").text().contains("not valid JSON"));
  views_.text().setPlainText(QString::fromStdString(before));
  EXPECT_TRUE(control<QLineEdit>("/title").isEnabled());
}

TEST_F(FormOfProtocol, ShowsAProblemNextToItsField) {
  open(library_text("amplitude_jnd"));
  Diagnostic problem{};
  problem.pointer = "/material/stiffness_N_per_m";
  problem.message = "too stiff";
  views_.show_problems({problem}, {});
  ASSERT_NE(part(problem.pointer), nullptr);
  int shown = 0;
  for (const QLabel* const label : form().findChildren<QLabel*>("form_problem")) {
    shown += label->isVisible() && label->text().contains("too stiff") ? 1 : 0;
  }
  EXPECT_EQ(shown, 1);
  views_.show_problems({}, {});
  for (const QLabel* const label : form().findChildren<QLabel*>("form_problem")) {
    EXPECT_FALSE(label->isVisible());
  }
}

TEST_F(FormOfProtocol, StatesThePermittedNumbersInTheUnitOfTheForm) {
  const auto problem_after = [this](const std::string& pointer) {
    open(library_text("amplitude_jnd"));
    type_into(pointer, "abc");
    const ProtocolReading reading =
        read_protocol_with_problems(text(), "p.json", declarations_of(built_in_models()));
    const auto problem = std::ranges::find(reading.problems, pointer, &Diagnostic::pointer);
    if (problem == reading.problems.end()) return "no problem at " + pointer;
    views_.show_problems({*problem}, {});
    QString shown{};
    for (const QLabel* const label : form().findChildren<QLabel*>("form_problem")) {
      if (label->isVisible()) shown += label->text();
    }
    EXPECT_EQ(shown, "✕ " + views_.sentence_of(*problem)) << "as in the list";
    return shown.section(". Expected", 0, 0).toStdString();
  };
  EXPECT_EQ(problem_after("/material/friction"),
            "✕ \"abc\" is not permitted here: write a number from 0 to 2");
  EXPECT_EQ(problem_after("/stimuli/grating/parameters/amplitude_m"),
            "✕ amplitude_m is \"abc\"; it must be a number from 0\u00a0µm to 5000\u00a0µm.");
  EXPECT_EQ(problem_after("/resume/practice_trials"),
            "✕ \"abc\" is not permitted here: write a whole number from 1 to 100");
  EXPECT_EQ(problem_after("/explorations/stroking/stroke_length_m/target"),
            "✕ \"abc\" is not permitted here: write a number (at least 0\u00a0mm)");
}

TEST_F(FormOfProtocol, ShowsAWarningInAnotherColourThanAProblem) {
  open(library_text("amplitude_jnd"));
  Diagnostic remark{};
  remark.pointer = "/material/stiffness_N_per_m";
  remark.message = "rather stiff";
  const auto shown = [this] {
    for (const QLabel* const label : form().findChildren<QLabel*>("form_problem")) {
      if (label->isVisible()) return label->text() + " " + label->styleSheet();
    }
    return QString();
  };
  const auto& pages = child<QListWidget>(form(), "form_pages");
  ASSERT_NE(part(remark.pointer), nullptr);
  views_.show_problems({}, {remark});
  EXPECT_EQ(shown(), "▲ rather stiff color: " + color_of(State::look).name());
  EXPECT_TRUE(pages.currentItem()->text().endsWith("▲\u00A01"));
  views_.show_problems({remark}, {});
  EXPECT_EQ(shown(), "✕ rather stiff color: " + color_of(State::stop).name());
  EXPECT_TRUE(pages.currentItem()->text().endsWith("✕\u00A01"));
  views_.show_problems({remark}, {remark});
  EXPECT_EQ(shown(), "✕ rather stiff\n▲ rather stiff color: " + color_of(State::stop).name());
}

TEST_F(FormOfProtocol, FindsLabelsValuesMeaningsAndNamesOfAllPages) {
  open(library_text("amplitude_jnd"));
  const auto is_found = [this](const std::string& place, const QString& words) {
    const std::vector<std::string> places = form().places_with(words);
    return std::find(places.begin(), places.end(), place) != places.end();
  };
  EXPECT_TRUE(is_found("/blocks/comparisons/question/prompt", "which SURFACE is rougher"));
  EXPECT_TRUE(is_found("/stimuli/grating", "grating"));
  EXPECT_TRUE(is_found("/stimuli/grating/parameters/amplitude_m", "50 µm"));
  EXPECT_TRUE(is_found("/blocks/practice/question/name", "name of the response in the data"));
  EXPECT_TRUE(is_found("/blocks/comparisons/response_deadline_s", "response deadline"))
      << "which is not stated";
  EXPECT_TRUE(form().places_with("").empty());
  EXPECT_TRUE(form().places_with("no such words").empty());
}

TEST_F(FormOfProtocol, LeadsToWhatIsFound) {
  open(library_text("semantic_differential"));
  const std::vector<std::string> places = form().places_with("e");
  EXPECT_GT(places.size(), 100U);
  constexpr std::size_t kStep = 3;  // opening all of them takes seconds
  for (std::size_t i = 0; i < places.size(); i += kStep) {
    const std::string& place = places[i];
    form().go_to(place);
    QApplication::processEvents();
    const QWidget* const focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr) << place;
    EXPECT_FALSE(focus->visibleRegion().isEmpty()) << place;
    if (focus->objectName() == QString::fromStdString("add:" + place)) continue;
    std::string part{};
    for (const QWidget* at = focus; at != nullptr && part.empty(); at = at->parentWidget()) {
      if (const auto* const one = qobject_cast<const FormPart*>(at)) part = one->pointer();
    }
    EXPECT_TRUE(part == place || part.starts_with(place + "/") ||
                (!part.empty() && place.starts_with(part + "/")))
        << place << ": " << focus_text() << " of " << part;
  }
}

TEST_F(FormOfProtocol, FindsByKeysFromPageToPageAndAround) {
  open(library_text("semantic_differential"));
  control<QLineEdit>("/title").setFocus();
  views_.find();
  auto& words = child<QLineEdit>(views_, "find_words");
  const auto& count = child<QLabel>(views_, "find_count");
  EXPECT_TRUE(words.hasFocus());
  EXPECT_EQ(words.accessibleName(), "Find in the form");
  QTest::keyClicks(&words, "metals");
  EXPECT_EQ(count.text(), "no match");
  EXPECT_EQ(words.accessibleDescription(), "no match");
  QTest::keyClick(&words, Qt::Key_Return);
  QTest::keyClick(&words, Qt::Key_Backspace);
  EXPECT_TRUE(words.hasFocus()) << "what is typed is not complete";
  EXPECT_EQ(count.text(), "5 matches");
  const std::vector<std::string> places{"/textures/metal", "/textures/metal/height_field",
                                        "/textures/metal/picture", "/factors/texture/levels/0",
                                        "/blocks/range/listed/2/texture"};
  EXPECT_EQ(form().places_with("metal"), places);
  QTest::keyClick(&words, Qt::Key_Return);
  QApplication::processEvents();
  EXPECT_TRUE(words.hasFocus()) << focus_text();
  ASSERT_EQ(marked().size(), 1U);
  marked().front()->setFocus();
  for (std::size_t i = 0; i < places.size(); ++i) {
    QApplication::processEvents();
    EXPECT_EQ(form().page().id, form_page_of(places[i]).id);
    EXPECT_TRUE(form().isAncestorOf(QApplication::focusWidget())) << focus_text();
    EXPECT_EQ(count.text(), QString("%1 of 5").arg(i + 1));
    if (const auto* const line = qobject_cast<QLineEdit*>(QApplication::focusWidget())) {
      EXPECT_EQ(line->selectedText(), "metal") << line->text().toStdString();
    }
    if (const auto* const table = qobject_cast<QTableWidget*>(QApplication::focusWidget())) {
      EXPECT_EQ(table->currentItem()->text(), "metal");
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F3);
  }
  QApplication::processEvents();
  EXPECT_EQ(count.text(), "1 of 5") << "around";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_F3, Qt::ShiftModifier);
  QApplication::processEvents();
  EXPECT_EQ(count.text(), "5 of 5");
  QWidget* const field = QApplication::focusWidget();
  views_.find();
  EXPECT_EQ(words.selectedText(), "metal");
  QTest::keyClick(&words, Qt::Key_Escape);
  EXPECT_FALSE(words.isVisible());
  EXPECT_EQ(QApplication::focusWidget(), field);
  views_.set_view(ProtocolViews::View::text);
  views_.find();
  EXPECT_EQ(words.accessibleName(), "Find in the text");
}

TEST_F(FormOfProtocol, MarksWhatIsFoundWhileTheSearchHasTheFocus) {
  const std::string before = library_text("semantic_differential");
  open(before);
  control<QLineEdit>("/title").setFocus();
  views_.find();
  auto& words = child<QLineEdit>(views_, "find_words");
  const std::string word = "surface";
  QTest::keyClicks(&words, QString::fromStdString(word));
  const std::vector<std::string> places = form().places_with(QString::fromStdString(word));
  ASSERT_GT(places.size(), 3U);
  bool has_lines = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    QTest::keyClick(&words, i % 2 == 0 ? Qt::Key_Return : Qt::Key_F3);
    QApplication::processEvents();
    EXPECT_TRUE(words.hasFocus()) << places[i] << ": " << focus_text();
    EXPECT_EQ(form().page().id, form_page_of(places[i]).id);
    ASSERT_EQ(marked().size(), 1U) << places[i];
    EXPECT_FALSE(marked().front()->visibleRegion().isEmpty()) << places[i];
    const auto* const box = qobject_cast<QPlainTextEdit*>(marked().front());
    if (box == nullptr || !box->toPlainText().contains("surface", Qt::CaseInsensitive)) continue;
    has_lines = true;
    EXPECT_EQ(box->textCursor().selectedText().toLower(), "surface");
    views_.show_problems({}, {});
    EXPECT_TRUE(box->textCursor().hasSelection()) << "as long as it has the frame";
  }
  int selected = 0;
  for (const auto* const box : form().findChildren<QPlainTextEdit*>()) {
    selected += box->textCursor().hasSelection() ? 1 : 0;
  }
  EXPECT_LE(selected, 1) << "that of the last place";
  EXPECT_TRUE(has_lines) << "a field in which Enter writes";
  QTest::keyClick(&words, Qt::Key_S);
  EXPECT_EQ(text(), before);
  take_screenshot(views_, "form-found", {900, 700});
  QWidget* const found = marked().front();
  QTest::keyClick(&words, Qt::Key_Escape);
  EXPECT_FALSE(words.isVisible());
  EXPECT_EQ(QApplication::focusWidget(), found) << focus_text();
  EXPECT_TRUE(marked().empty()) << "it has the focus";
  auto& other = control<QLineEdit>("/title");
  other.setFocus();
  views_.find();
  QTest::keyClick(&words, Qt::Key_Escape);
  EXPECT_EQ(QApplication::focusWidget(), &other) << "nothing was found since";
}

TEST_F(FormOfProtocol, ShowsListedTrialsAsATable) {
  const std::string before = library_text("semantic_differential");
  open(before);
  auto& table = control<QTableWidget>("/blocks/range/listed");
  ASSERT_EQ(table.rowCount(), 4);
  table.item(3, 0)->setText("stone");
  EXPECT_EQ(text(), replaced(before, "{\"texture\": \"metal\"}, {\"texture\": \"brick\"}",
                             "{\"texture\": \"metal\"}, {\"texture\": \"stone\"}"));
  table.selectRow(3);
  click("remove_rows:/blocks/range/listed");
  click("add:/blocks/range/listed");
  EXPECT_EQ(tree()["blocks"]["range"]["listed"].size(), 4U);
  EXPECT_EQ(tree()["blocks"]["range"]["listed"][3]["texture"], "metal");
}

TEST_F(FormOfProtocol, RemovesTheLevelsWithTheirTexture) {
  open(library_text("attributes_of_textures"));
  const std::string before = text();
  ASSERT_NE(part("/factors/texture/levels/0"), nullptr);
  form().show_page("surfaces");
  QApplication::processEvents();
  EXPECT_EQ(child<QToolButton>(form(), "remove:/textures/metal").accessibleName(),
            "Remove “metal”, and with it 2 entries of lists");
  click("remove:/textures/metal");
  EXPECT_FALSE(tree()["textures"].contains("metal"));
  EXPECT_EQ(tree()["factors"]["texture"]["levels"], json::parse(R"(["stone", "wood", "brick"])"));
  EXPECT_EQ(tree()["blocks"]["recognition"]["question"]["pictures"].size(), 5U);
  undo();
  EXPECT_EQ(text(), before) << "one step";
}

TEST_F(FormOfProtocol, EditsTheAnalysis) {
  open(library_text("semantic_differential"));
  const std::string scales = "/analysis/constructs/coarseness/scales";
  ASSERT_NE(part(scales + "/0"), nullptr);
  click("add:" + scales);
  const json added = tree()["analysis"]["constructs"]["coarseness"]["scales"];
  EXPECT_EQ(added, json::parse(R"(["rough", "bumpy", "coarse", "slippery"])"));
  click("add:/analysis/family");
  EXPECT_EQ(tree()["analysis"]["family"], json::parse(R"(["ratings", "rated_pairs"])"));
  const auto& test = control<QComboBox>("/analysis/family/1");
  EXPECT_EQ(test.currentText(),
            "rated_pairs: whether the ratings of two items differ, for every pair of items on "
            "every scale");
  EXPECT_EQ(test.findData("pairs"), -1) << "a test of another kind";
  click("add:/analysis/constructs/coarseness/reverse_keyed");
  click("add:/analysis/constructs");
  EXPECT_EQ(tree()["analysis"]["constructs"].size(), 2U);
  EXPECT_TRUE(form().findChildren<TextCard*>().isEmpty());
}

TEST_F(FormOfProtocol, BeginsAnAnalysisThatIsValid) {
  using Keys = std::vector<const char*>;
  const std::vector<std::pair<const char*, Keys>> settings{
      {"amplitude_jnd", {"family"}},
      {"improved_selection", {"family"}},
      {"semantic_differential", {"family", "constructs"}}};
  for (const auto& [name, keys] : settings) {
    json protocol = json::parse(library_text(name));
    protocol["analysis"] = json::object();
    open(protocol.dump());
    for (const char* const key : keys) {
      form().go_to(std::string("/analysis/") + key);
      QApplication::processEvents();
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of the text before
      click(std::string("add:/analysis/") + key);
      EXPECT_TRUE(tree()["analysis"].contains(key)) << name;
    }
    const ProtocolReading read =
        read_protocol_with_problems(text(), name, declarations_of(built_in_models()));
    EXPECT_TRUE(read.problems.empty()) << name << ": " << read.problems.front().message.english();
  }
}

TEST_F(FormOfProtocol, ShowsAlmostEverythingOfTheLibrary) {
  constexpr int kMostCards = 3;
  for (const LibraryProtocol& library : library_protocols()) {
    open(std::string(library.text));
    int cards = 0;
    for (const FormPage& page : form_pages()) {
      unfold(page);
      for (const TextCard* const card : form().findChildren<TextCard*>()) {
        if (!card->isVisible()) continue;
        ++cards;
        RecordProperty(std::string(library.name), card->pointer());
      }
    }
    EXPECT_LE(cards, kMostCards) << library.name;
    EXPECT_EQ(text(), library.text) << library.name;
  }
}

TEST_F(FormOfProtocol, NamesEveryControlForScreenReaders) {
  for (const char* const name : {"semantic_differential", "amplitude_jnd", "tools_matching"}) {
    open(library_text(name));
    for (const FormPage& page : form_pages()) {
      unfold(page);
      for (const QWidget* const widget : form().findChildren<QWidget*>()) {
        const bool can_be_reached =
            widget->isVisible() && widget->focusPolicy() != Qt::NoFocus && widget->isEnabled();
        const bool is_control = qobject_cast<const QLineEdit*>(widget) != nullptr ||
                                qobject_cast<const QComboBox*>(widget) != nullptr ||
                                qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
                                qobject_cast<const QToolButton*>(widget) != nullptr ||
                                qobject_cast<const QCheckBox*>(widget) != nullptr;
        if (!can_be_reached || !is_control) continue;
        EXPECT_FALSE(widget->accessibleName().isEmpty())
            << name << " " << page.id << " " << widget->metaObject()->className() << " in "
            << widget->parentWidget()->objectName().toStdString();
      }
    }
  }
}

/// What a field shows: the characters of a line or a box, the choice, the tick.
QString shown_in(const QWidget& control) {
  if (const auto* const line = qobject_cast<const QLineEdit*>(&control)) return line->text();
  if (const auto* const box = qobject_cast<const QPlainTextEdit*>(&control)) {
    return box->toPlainText();
  }
  if (const auto* const box = qobject_cast<const QComboBox*>(&control)) return box->currentText();
  return static_cast<const QCheckBox&>(control).isChecked() ? "ticked" : "not ticked";
}

/// Changes what the field shows, as a person would.
void change(QWidget& control) {
  if (auto* const box = qobject_cast<QComboBox*>(&control)) {
    const int index = (box->currentIndex() + 1) % std::max(box->count(), 1);
    box->setCurrentIndex(index);
    emit box->activated(index);
  } else if (auto* const tick = qobject_cast<QCheckBox*>(&control)) {
    tick->click();
  } else {
    control.setFocus();
    QTest::keyClick(&control, Qt::Key_End);
    QTest::keyClicks(&control, "1");
  }
}

// Two hundred changes of random fields: another form of the new text shows what the field shows, nothing outside of the value
// changes, and undo returns the bytes.
TEST_F(FormOfProtocol, ChangesOneValueOfTheText) {
  std::mt19937 random(11);
  int edits = 0;
  ProtocolViews other(declarations_of(built_in_models()));
  for (const LibraryProtocol& library : library_protocols()) {
    open(std::string(library.text));
    const std::string before = text();
    constexpr int kEditsPerProtocol = 8;
    constexpr int kEditsPerPage = 4;
    for (int tries = 0, done = 0; done < kEditsPerProtocol && tries < 40; ++tries) {
      if (tries % kEditsPerPage == 0) unfold(form_pages()[random() % form_pages().size()]);
      std::vector<FormPart*> parts{};
      for (FormPart* const part : form().findChildren<FormPart*>()) {
        // A name is written when it is complete: RenamesATextureWithItsReferences.
        const bool is_name = part->inherits("asperity::DeclaredNameField");
        if (part->isVisible() && part->focusProxy() != nullptr && !is_name &&
            qobject_cast<QTableWidget*>(part->focusProxy()) == nullptr) {
          parts.push_back(part);
        }
      }
      if (parts.empty()) continue;
      FormPart* const part = parts[random() % parts.size()];
      const std::string pointer = part->pointer();
      QWidget& control = *part->focusProxy();
      change(control);
      if (text() == before) continue;  // the name that is declared is not complete
      const QString shown = shown_in(*part->focusProxy());  // of a value that is bound, the other
      json expected = json::parse(before);
      const json::json_pointer place(pointer);
      if (tree().contains(place)) {
        expected[place] = tree().at(place);
      } else {
        expected.at(place.parent_pointer()).erase(place.back());
      }
      EXPECT_EQ(tree(), expected) << library.name << pointer;
      other.text().setPlainText(QString::fromStdString(text()));
      other.show_form_if_possible();
      auto& form_of_other = child<ProtocolForm>(other, "editor_form");
      form_of_other.go_to(pointer);
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of what was made again
      const auto& there = child<FormPart>(form_of_other, pointer.c_str());
      EXPECT_EQ(shown_in(*there.focusProxy()), shown) << library.name << pointer;
      views_.text().undo();
      EXPECT_EQ(text(), before) << library.name << pointer;
      ++edits;
      ++done;
    }
  }
  EXPECT_GE(edits, 200);
}

TEST_F(FormOfProtocol, Pictures) {
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qApp, choice);
    const QString end = choice == ThemeChoice::light ? "" : "-dark";
    open(library_text("semantic_differential"));
    for (const FormPage& page : form_pages()) {
      form().show_page(page.id);
      take_screenshot(views_, "form-" + QString::fromUtf8(page.id.data()) + end, {900, 700});
    }
    ASSERT_NE(part("/blocks/ratings/questions/2/scale/labels"), nullptr);
    take_screenshot(views_, "form-scale" + end, {900, 700});
    open(library_text("amplitude_jnd"));
    ASSERT_NE(part("/blocks/comparisons/procedure/steps"), nullptr);
    take_screenshot(views_, "form-procedure" + end, {900, 700});
    for (const char* const page : {"surfaces", "task", "order", "analysis"}) {
      for (const FormPage& each : form_pages()) {
        if (each.id == page) unfold(each);
      }
      take_screenshot(views_, "form-narrow-" + QString(page) + end, {590, 900});
    }
  }
  apply_theme(*qApp, ThemeChoice::light);
}

}  // namespace
}  // namespace asperity
