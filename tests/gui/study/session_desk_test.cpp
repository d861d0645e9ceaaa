// From the pages of a study to the page before a session, and what may not happen meanwhile.

#include "app/gui/study/session_desk.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include "app/gui/look/controls.h"
#include "app/gui/start/start_page.h"
#include "app/gui/study/study_table.h"
#include "app/gui/study/study_window.h"
#include "tests/gui/study/quiet_home.h"

namespace asperity {
namespace {

class TheSessionDesk : public QuietHome {
 protected:
  TheSessionDesk() : desk_(window_, nullptr) {
    window_.resize(1366, 768);
    window_.show();
  }
  ~TheSessionDesk() override { apply_theme(*qApp, ThemeChoice::light); }

  void open_demo() {
    ASSERT_TRUE(window_.open_study(small_demo_study()));
    auto& table = child<StudyTable>(window_, "protocols_table");
    ASSERT_TRUE(eventually([&] { return table.shown_rows() == 3; }));
    table.select(QString::fromStdString(
        (window_.study()->folder() / "protocols" / "chapter_recognition.json").string()));
  }
  StartPage& start_page() {
    auto* page = qobject_cast<StartPage*>(window_.page("start"));
    if (page == nullptr) throw std::runtime_error("there is no page before a session");
    return *page;
  }
  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(window_, button), Qt::LeftButton);
  }
  void choose_theme(const QString& name) {
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->text().remove('&') == name) action->trigger();
    }
    QCoreApplication::processEvents();
  }
  bool can_start() {
    return eventually([this] { return child<QPushButton>(window_, "start").isEnabled(); });
  }

  StudyWindow window_{};
  SessionDesk desk_;
};

TEST_F(TheSessionDesk, OpensThePageBeforeASessionInTheModeThatWasAskedFor) {
  open_demo();
  click("protocol_simulate");
  EXPECT_EQ(window_.shown_page(), "start");
  EXPECT_EQ(start_page().order().inputs.mode, SessionMode::simulate);
  EXPECT_EQ(start_page().order().inputs.protocol.filename(), "chapter_recognition.json");
  window_.show_page("protocols");
  click("protocol_start");
  EXPECT_EQ(start_page().order().inputs.mode, SessionMode::run);
}

TEST_F(TheSessionDesk, KeepsWhatIsFilledInFromAChangeOfTheme) {
  open_demo();
  click("protocol_start");
  const QPointer<StartPage> page = &start_page();
  choose_theme("Dark");
  EXPECT_FALSE(page.isNull());
  EXPECT_FALSE(theme().dark);
  EXPECT_TRUE(window_.banner().text().contains("would be lost"))
      << window_.banner().text().toStdString();
  window_.show_page("protocols");
  choose_theme("Dark");
  EXPECT_TRUE(theme().dark);
}

TEST_F(TheSessionDesk, SimulatesSeveralWithTheWindowKeptOpen) {
  open_demo();
  click("protocol_simulate");
  child<QSpinBox>(window_, "virtual_participants").setValue(200);
  ASSERT_TRUE(can_start());
  click("start");
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(window_.banner().text().contains("Stop the simulation first."));
  click("simulation_cancel");
  ASSERT_TRUE(eventually([this] { return child<QPushButton>(window_, "start").isVisible(); }));
  EXPECT_TRUE(window_.close());
}

TEST_F(TheSessionDesk, LeavesThePageBeforeASessionWhileOneRuns) {
  open_demo();
  click("protocol_simulate");
  ASSERT_TRUE(can_start());
  QSignalSpy ended(&start_page(), &StartPage::start_wanted);
  click("start");
  ASSERT_EQ(ended.count(), 1);
  EXPECT_FALSE(start_page().isVisible());
  ASSERT_TRUE(eventually([this] { return !desk_.is_running(); }));
}

}  // namespace
}  // namespace asperity
