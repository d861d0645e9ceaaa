// The actions of a protocol in the study window.

#include <filesystem>

#include <QtCore/QPointer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/protocols_page.h"
#include "app/gui/window/study_window.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

TEST_F(StudyPages, DuplicateRenameAndDeleteAProtocolThatWasNeverRun) {
  open_demo();
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  const auto act = [this](const char* name) {
    child<QPushButton>(window_, "protocol_more").menu()->findChild<QAction*>(name)->trigger();
  };
  const QString first = table.selected_key();
  act("protocol_duplicate");
  ASSERT_TRUE(eventually([&] { return table.shown_rows() == 4; }));
  EXPECT_EQ(table.selected_key().toStdString(),
            QString(first).replace(".json", "_2.json").toStdString());

  act("protocol_rename");
  auto& name = child<QLineEdit>(window_, "protocol_file_name");
  ASSERT_TRUE(eventually([&] { return name.isVisible(); }));
  name.setText("No name");
  click("protocol_file_act");
  ASSERT_TRUE(
      eventually([&] { return texts_on("protocols_page").contains("cannot be the name"); }));
  name.setText("mine");
  click("protocol_file_act");
  ASSERT_TRUE(eventually([&] { return column(table, 1).contains("mine"); }));
  EXPECT_TRUE(table.selected_key().endsWith("/mine.json"));
  EXPECT_FALSE(name.isVisible());

  act("protocol_delete");
  auto& really = child<QPushButton>(window_, "protocol_file_act");
  ASSERT_TRUE(eventually([&] { return really.isVisible(); }));
  EXPECT_FALSE(name.isVisible());
  // Return does not delete: the file cannot be restored.
  const auto& cancel = child<QPushButton>(window_, "protocol_file_cancel");
  EXPECT_EQ(window_.focusWidget(), &cancel);
  QTest::keyClick(window_.focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(eventually([&] { return !really.isVisible(); }));
  EXPECT_EQ(table.shown_rows(), 4);
  act("protocol_delete");
  ASSERT_TRUE(eventually([&] { return really.isVisible(); }));
  really.click();
  EXPECT_TRUE(eventually([&] { return table.shown_rows() == 3; }));
}

TEST_F(PagesToRead, SayWhyAProtocolThatWasRunIsNeitherRenamedNorDeleted) {
  select_protocol("chapter_recognition.json");
  for (const char* const action : {"protocol_rename", "protocol_delete"}) {
    child<QPushButton>(window_, "protocol_more").menu()->findChild<QAction*>(action)->trigger();
    EXPECT_TRUE(eventually([&] {
      return texts_on("protocols_page")
          .contains("chapter_recognition.json has been run (12 sessions)");
    }));
    EXPECT_FALSE(child<QPushButton>(window_, "protocol_file_act").isVisible());
  }
  EXPECT_TRUE(std::filesystem::exists(window_.study()->folder() / "protocols" /
                                      "chapter_recognition.json"));
}

TEST_F(PagesToRead, SayWhichProtocolAPersonWantsToRun) {
  select_protocol("chapter_recognition.json");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  click("protocol_start");
  ASSERT_EQ(wanted.count(), 1);
  const auto wish = wanted[0][0].value<SessionWish>();
  EXPECT_EQ(wish.protocol.parent_path(), window_.study()->folder() / "protocols");
  EXPECT_FALSE(wish.participant);
  EXPECT_FALSE(wish.session);
}

TEST_F(PagesToRead, PreviewThePlanStepByStep) {
  select_protocol("chapter_recognition.json");
  click("protocol_preview");
  auto* page = window_.findChild<ProtocolsPage*>();  // the editor shows a plan as well
  const auto& plan = child<StudyTable>(*page, "plan_table");
  ASSERT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
  EXPECT_TRUE(column(plan, 2).contains("screen"));
  const QStringList before = column(plan, 3);
  QTest::mouseClick(&child<QPushButton>(*page, "plan_another"), Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return column(plan, 3) != before; }));
  take_screenshot(window_, "study-plan");
}

TEST_F(PagesToRead, ShowNoPlanOfTheRowBefore) {
  select_protocol("chapter_recognition.json");
  click("protocol_preview");
  auto* page = window_.findChild<ProtocolsPage*>();
  const auto& plan = child<StudyTable>(*page, "plan_table");
  ASSERT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
  select_protocol("chapter_matching.json");
  EXPECT_EQ(plan.shown_rows(), 0);
  EXPECT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
}

TEST_F(StudyPages, EditAProtocolInTheWindowAndLoseNothingOfIt) {
  open_demo();
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  const QString file = QString::fromStdString(
      (window_.study()->folder() / "protocols" / "chapter_recognition.json").string());
  table.select(file);
  click("protocol_edit");
  EXPECT_EQ(window_.shown_page(), "editor");
  auto* editor = window_.findChild<ProtocolEditorPage*>();
  EXPECT_EQ(QString::fromStdString(editor->file().string()), file);
  ASSERT_TRUE(eventually([&] { return editor->is_checked(); }));
  auto& plan = child<StudyTable>(*editor, "plan_table");
  ASSERT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
  take_screenshot(window_, "study-editor");

  auto& pages = child<QListWidget>(window_, "navigation");
  QTest::mouseClick(pages.viewport(), Qt::LeftButton, {},
                    pages.visualItemRect(pages.item(0)).center());
  EXPECT_EQ(window_.shown_page(), "protocols");
  click("protocol_edit");
  EXPECT_EQ(window_.shown_page(), "editor");

  QTest::keyClicks(&child<ProtocolTextEdit>(*editor, "editor_text"), "  ");
  window_.show_page("sessions");
  window_.close();
  EXPECT_TRUE(window_.isVisible());
  EXPECT_EQ(window_.shown_page(), "editor");
  click("editor_leave_stay");
  const QPointer<ProtocolEditorPage> before(editor);
  choose_theme("&Dark");
  EXPECT_TRUE(theme().dark) << "without a question: nothing is lost";
  ASSERT_TRUE(eventually([&] { return before.isNull(); }));
  editor = window_.findChild<ProtocolEditorPage*>();
  ASSERT_NE(editor, nullptr);
  EXPECT_EQ(window_.shown_page(), "editor");
  EXPECT_EQ(editor->content().substr(0, 3), "  {");
  EXPECT_TRUE(editor->has_unsaved_changes());
  ASSERT_TRUE(eventually([&] { return editor->is_checked(); }));
  click("editor_save");
  ASSERT_TRUE(eventually([&] { return !editor->has_unsaved_changes(); }));
  apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), ThemeChoice::light);

  QTest::keyClicks(&child<ProtocolTextEdit>(*editor, "editor_text"), "  ");
  window_.close();
  EXPECT_TRUE(window_.isVisible());
  click("editor_leave_discard");
  EXPECT_TRUE(eventually([&] { return !window_.isVisible(); }));
}

TEST_F(PagesToRead, SayWhichProtocolIsToBeSimulated) {
  select_protocol("chapter_recognition.json");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  click("protocol_simulate");
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted[0][0].value<SessionWish>().simulate);
}

}  // namespace
}  // namespace asperity
