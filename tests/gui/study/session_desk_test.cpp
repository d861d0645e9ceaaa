// From the pages of a study to the page before a session, and what may not happen meanwhile.

#include "app/gui/window/session_desk.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/start/start_page.h"
#include "app/gui/window/study_window.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "tests/app/punctual_trial.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/full_disk.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/support/patient_servo.h"

namespace asperity {
namespace {

class TheSessionDesk : public QuietHome {
 protected:
  TheSessionDesk() : desk_(window_, nullptr) {
    window_.resize(1366, 768);
    window_.show();
  }
  ~TheSessionDesk() override { apply_theme(*qApp, ThemeChoice::light); }

  void open_demo(const std::shared_ptr<GatedExamination>& gate = nullptr) {
    ASSERT_TRUE(window_.open_study(small_demo_study()));
    if (gate != nullptr) window_.study()->examiner().set_examine(examine_through(gate));
    window_.study()->set_device_trial(punctual_trial);
    window_.study()->set_servo(patient_servo());
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

TEST_F(TheSessionDesk, KeepsWhatIsFilledInThroughAChangeOfTheme) {
  open_demo();
  click("protocol_start");
  const auto label = [this] { return child<QLineEdit>(window_, "participant_label").text(); };
  const auto is_read = [this] {
    return child<QLineEdit>(window_, "participant_label").isEnabled();
  };
  ASSERT_TRUE(eventually(is_read));
  child<QLineEdit>(window_, "participant_label").setText("P044");
  click("mode_pilot");
  QPointer<StartPage> page = &start_page();
  choose_theme("Dark");
  EXPECT_TRUE(theme().dark);
  EXPECT_TRUE(page.isNull());
  EXPECT_EQ(window_.shown_page(), "start");
  ASSERT_TRUE(eventually(is_read));
  EXPECT_EQ(label(), "P044");
  EXPECT_EQ(start_page().mode(), SessionMode::pilot);

  window_.show_page("protocols");
  page = &start_page();
  choose_theme("Light");
  EXPECT_FALSE(theme().dark);
  EXPECT_TRUE(page.isNull());
  window_.show_page("start");
  ASSERT_TRUE(eventually(is_read));
  EXPECT_EQ(label(), "P044");
  EXPECT_EQ(start_page().mode(), SessionMode::pilot);
}

TEST_F(TheSessionDesk, SimulatesSeveralWithTheWindowKeptOpen) {
  open_demo();
  click("protocol_simulate");
  child<QSpinBox>(window_, "virtual_participants").setValue(200);
  ASSERT_TRUE(can_start());
  click("start");
  EXPECT_FALSE(window_.close());
  EXPECT_TRUE(window_.banner().text().contains("Cancel the simulation first."));
  QTest::mouseClick(&child<QPushButton>(child<QWidget>(window_, "simulating"), "task_cancel"),
                    Qt::LeftButton);
  ASSERT_TRUE(eventually([this] { return child<QPushButton>(window_, "start").isEnabled(); }));
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

TEST_F(TheSessionDesk, ExaminesNoStimuliWhileASessionRuns) {
  const auto gate = std::make_shared<GatedExamination>();
  open_demo(gate);
  const StimulusExaminer& examiner = window_.study()->examiner();
  click("protocol_simulate");
  ASSERT_TRUE(can_start()) << "the session does not wait for the examination";
  ASSERT_TRUE(eventually([&] { return gate->running == 1; }));
  click("start");
  EXPECT_TRUE(examiner.is_held());
  window_.show_page("protocols");
  const auto& note = child<QLabel>(window_, "protocols_examining");
  EXPECT_TRUE(note.isVisible());
  EXPECT_EQ(note.text(), "The stimuli are examined when the device is free again.");
  const int begun = gate->begun;
  ASSERT_TRUE(eventually([&] {
    if (!desk_.is_running()) return true;
    EXPECT_EQ(gate->begun, begun);
    return false;
  }));
  EXPECT_TRUE(eventually([&] { return !examiner.is_held() && gate->begun > begun; }));
  EXPECT_TRUE(note.text().startsWith("Examining stimuli: ")) << note.text().toStdString();
  gate->is_open = true;
  const auto& table = child<StudyTable>(window_, "protocols_table");
  EXPECT_TRUE(eventually([&] {
    return !note.isVisible() && table.text_at(0, 5) == "▲ valid, 1 warning";
  })) << table.text_at(0, 5).toStdString();
}

/// What the page before a session would start, without its looking at everything first.
class TroubledDesk : public TheSessionDesk {
 protected:
  void order_a_simulation() {
    open_demo();
    click("protocol_simulate");
    ASSERT_TRUE(eventually([this] { return start_page().is_read(); }));
    order_ = start_page().order();
  }
  Banner& news() { return child<Banner>(*desk_.session_window(), "news"); }
  bool fails() {
    return eventually([this] { return news().isVisible(); });
  }
  void help(const QString& verb) {
    for (QPushButton* button : news().findChildren<QPushButton*>()) {
      if (button->text() == verb) return QTest::mouseClick(button, Qt::LeftButton);
    }
    ADD_FAILURE() << "no button says " << verb.toStdString();
  }
  std::filesystem::path protocol() {
    return window_.study()->folder() / "protocols" / "chapter_recognition.json";
  }

  SessionOrder order_{};
};

TEST_F(TroubledDesk, TriesAgainOnceAnotherProgramHasLetGoOfTheParticipant) {
  order_a_simulation();
  {
    const StudyLock elsewhere(window_.study()->folder(),
                              Study::session_lock_name(order_.inputs.participant));
    desk_.begin(order_);
    ASSERT_TRUE(fails());
    EXPECT_TRUE(news().text().contains("is in use by process")) << news().text().toStdString();
  }
  const QPointer<SessionWindow> before = desk_.session_window();
  help("Try again");
  ASSERT_TRUE(eventually([&] { return before.isNull(); }));
  ASSERT_NE(desk_.runner(), nullptr);
  EXPECT_EQ(desk_.runner()->order().inputs.seed, order_.inputs.seed);
  EXPECT_TRUE(eventually([this] { return desk_.runner()->monitor().facts() != nullptr; }));
}

TEST_F(TroubledDesk, ChecksAgainWhenTheProtocolHasChangedSinceTheCheck) {
  order_a_simulation();
  const std::string text = read_file(protocol()) + "\n";
  write_file(protocol(), text, Overwrite::allow);
  desk_.begin(order_);
  ASSERT_TRUE(fails());
  EXPECT_TRUE(news().text().contains("has changed since it was checked"));
  help("Check again");
  EXPECT_EQ(desk_.runner(), nullptr);
  EXPECT_EQ(window_.shown_page(), "start");
  EXPECT_TRUE(eventually([&] { return start_page().order().protocol_sha256 == sha256_of(text); }));
  EXPECT_EQ(start_page().order().inputs.mode, SessionMode::simulate);
}

TEST_F(TroubledDesk, ContinuesWithTheSessionThatFilledTheDisk) {
  order_a_simulation();
  desk_.begin(order_);
  QSignalSpy done(desk_.runner(), &SessionRunner::attempt_done);
  ASSERT_TRUE(eventually([&] { return !done.isEmpty(); }));
  {
    const FullDisk full(4096);
    ASSERT_TRUE(fails());
  }
  EXPECT_TRUE(news().text().contains("The force is zero")) << news().text().toStdString();
  const std::int64_t session = desk_.runner()->monitor().facts()->row.id;
  help("Resume this session…");
  EXPECT_EQ(desk_.runner(), nullptr);
  EXPECT_EQ(window_.shown_page(), "start");
  EXPECT_TRUE(eventually([this] { return start_page().order().inputs.resume; }));
  const RunInputs inputs = start_page().order().inputs;
  EXPECT_EQ(inputs.resumed_session, session);
  EXPECT_EQ(inputs.participant, order_.inputs.participant);
}

}  // namespace
}  // namespace asperity
