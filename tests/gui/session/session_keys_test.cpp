// Every key of the experimenter, from every window, and the emergency stop at its press.

#include <algorithm>

#include <QtCore/QPointer>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/session/rig/recorder.h"
#include "app/session/rig/rig.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

class SessionKeysTest : public testing::Test {
 protected:
  SessionKeysTest() {
    session_.answer_up_to(16);
    session_.set_phase(SessionPhase::contact);
    window_ = session_.window();
  }

  template <class Widget>
  Widget& find(const char* name) {
    return child<Widget>(*window_, name);
  }
  SessionRequests::Pending pending() const { return session_.requests.pending(); }

  FilledMonitor session_{};
  std::unique_ptr<SessionWindow> window_{};
};

TEST_F(SessionKeysTest, EscAndF6AskForAPauseAndF5WithdrawsIt) {
  for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_F6}) {
    QTest::keyClick(window_.get(), key);
    EXPECT_TRUE(pending().pause);
    EXPECT_TRUE(find<QLabel>("pending").text().contains("Pausing after this trial"));
    QTest::keyClick(window_.get(), Qt::Key_F5);
    EXPECT_FALSE(pending().pause);
    EXPECT_TRUE(find<QLabel>("pending").text().isEmpty());
  }
}

TEST_F(SessionKeysTest, APauseThatHasHappenedSaysSinceWhenAndWhatEndsIt) {
  session_.requests.pause();
  session_.set_phase(SessionPhase::paused);
  window_->refresh();
  EXPECT_TRUE(find<QLabel>("pending").text().contains("Paused since"));
  EXPECT_TRUE(find<QPushButton>("pause").text().startsWith("Resume"));
  find<QPushButton>("pause").click();
  EXPECT_FALSE(pending().pause);
}

TEST_F(SessionKeysTest, F7AndF8AskForAStopAndWithdrawIt) {
  QTest::keyClick(window_.get(), Qt::Key_F7);
  EXPECT_EQ(pending().stop, StopAfter::trial);
  EXPECT_TRUE(find<QLabel>("pending").text().contains("Stopping after this trial"));
  QTest::keyClick(window_.get(), Qt::Key_F8);
  EXPECT_EQ(pending().stop, StopAfter::block);
  EXPECT_TRUE(find<QLabel>("pending").text().contains("Stopping after this block"));
  QTest::keyClick(window_.get(), Qt::Key_F8);
  EXPECT_FALSE(pending().stop.has_value());
}

TEST_F(SessionKeysTest, F2GoesToTheNote) {
  QTest::keyClick(window_.get(), Qt::Key_F2);
  EXPECT_TRUE(find<QLineEdit>("note").hasFocus());
  QTest::keyClicks(&find<QLineEdit>("note"), "hand slipped");
  QTest::keyClick(&find<QLineEdit>("note"), Qt::Key_Return);
  const auto remarks = session_.requests.take_remarks();
  const auto note = std::find_if(remarks.begin(), remarks.end(),
                                 [](const auto& remark) { return remark.kind == "note"; });
  ASSERT_NE(note, remarks.end());
  EXPECT_EQ(note->text, "hand slipped");
}

TEST_F(SessionKeysTest, CtrlRRepeatsTheLastTrialForAReason) {
  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
  EXPECT_FALSE(pending().repeat_last) << "not without a reason";
  EXPECT_FALSE(find<QPushButton>("reason_given").isEnabled());
  QTest::keyClicks(&find<QLineEdit>("reason"), "wrong key");
  QTest::keyClick(&find<QLineEdit>("reason"), Qt::Key_Return);
  EXPECT_EQ(session_.requests.take_repeat(), "wrong key");
}

TEST_F(SessionKeysTest, EscTakesAnOpenQuestionAwayBeforeItPauses) {
  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
  ASSERT_TRUE(window_->findChild<QWidget*>("reason_form")->isVisible());
  QTest::keyClick(&find<QLineEdit>("reason"), Qt::Key_Escape);
  EXPECT_FALSE(window_->findChild<QWidget*>("reason_form")->isVisible());
  EXPECT_FALSE(pending().pause);
  EXPECT_FALSE(session_.requests.take_repeat().has_value());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(pending().pause);
}

TEST_F(SessionKeysTest, CtrlShiftQAbortsForAReasonAndSaysThatNothingIsLost) {
  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  const QPointer<QDialog> dialog(&find<QDialog>("abort_dialog"));
  ASSERT_TRUE(dialog->isVisible());
  bool says = false;
  for (const QLabel* label : dialog->findChildren<QLabel*>()) {
    says = says || label->text().contains("Nothing is lost");
  }
  EXPECT_TRUE(says);
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(dialog == nullptr || !dialog->isVisible());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(session_.requests.take_abort().has_value());
  EXPECT_FALSE(pending().pause) << "Esc closed the dialog, and did no more";

  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  auto& again = find<QDialog>("abort_dialog");
  QTest::keyClicks(again.findChild<QLineEdit*>("reason"), "unwell");
  again.findChild<QPushButton*>("reason_given")->click();
  EXPECT_EQ(session_.requests.take_abort(), "unwell");
}

TEST_F(SessionKeysTest, WorkFromAnotherWindowOfTheProgram) {
  QWidget other{};
  auto* field = new QLineEdit(&other);
  other.show();
  other.activateWindow();
  field->setFocus();
  QTest::keyClick(field, Qt::Key_F7);
  EXPECT_EQ(pending().stop, StopAfter::trial);
  QTest::keyClick(field, Qt::Key_F6);
  EXPECT_TRUE(pending().pause);
}

TEST_F(SessionKeysTest, LeaveTheParticipantsKeysAlone) {
  QWidget other{};
  auto* field = new QLineEdit(&other);
  other.show();
  field->setFocus();
  QTest::keyClicks(field, "1234 abc");
  EXPECT_EQ(field->text(), "1234 abc");
  EXPECT_FALSE(pending().pause);
  EXPECT_FALSE(pending().stop.has_value());
}

TEST_F(SessionKeysTest, MeanNothingOnceTheSessionHasEnded) {
  session_.set_phase(SessionPhase::ended);
  window_->refresh();
  QTest::keyClick(window_.get(), Qt::Key_F6);
  QTest::keyClick(window_.get(), Qt::Key_F7);
  EXPECT_FALSE(pending().pause);
  EXPECT_FALSE(pending().stop.has_value());
  // It would otherwise stop the next session before it begins.
  QTest::keyClick(window_.get(), Qt::Key_F12);
  SteppedRig rig(RigSettings{}, 1);
  session_.requests.attach(rig);
  Recorder recorder{};
  rig.pass(0.005, recorder);
  EXPECT_EQ(rig.loop().status().fault, Fault::none);
  session_.requests.detach();
}

class EmergencyStop : public SessionKeysTest {
 protected:
  EmergencyStop() { session_.requests.attach(rig_); }
  ~EmergencyStop() override { session_.requests.detach(); }
  Fault fault() {
    rig_.pass(0.002, recorder_);
    return rig_.loop().status().fault;
  }

  SteppedRig rig_{RigSettings{}, 1};
  Recorder recorder_{};
};

TEST_F(EmergencyStop, ReachesTheLoopAtThePressOfItsKey) {
  ASSERT_EQ(fault(), Fault::none);
  QTest::keyPress(window_.get(), Qt::Key_F12);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, HasThePauseKeyAsWell) {
  QTest::keyPress(window_.get(), Qt::Key_Pause);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, HasCtrlSpaceAsWell) {
  QTest::keyPress(window_.get(), Qt::Key_Space);
  EXPECT_EQ(fault(), Fault::none) << "Space alone is the participant's";
  QTest::keyPress(window_.get(), Qt::Key_Space, Qt::ControlModifier);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, WorksWhileTheNoteHasTheFocus) {
  auto& note = find<QLineEdit>("note");
  note.setFocus();
  QTest::keyClicks(&note, "half a no");
  QTest::keyPress(&note, Qt::Key_F12);
  EXPECT_EQ(fault(), Fault::emergency_stop);
  EXPECT_EQ(note.text(), "half a no");
}

TEST_F(EmergencyStop, WorksWhileADialogIsOpen) {
  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  const QPointer<QDialog> dialog(&find<QDialog>("abort_dialog"));
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog, kPatience_ms));
  // As it comes from the window system: to the window, not to a widget.
  QTest::keyPress(dialog->windowHandle(), Qt::Key_F12);
  EXPECT_EQ(fault(), Fault::emergency_stop);
  EXPECT_TRUE(dialog == nullptr || !dialog->isVisible()) << "it would stand in the way";
}

TEST_F(EmergencyStop, IsHeardInTheWindowBesideADialog) {
  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(find<QDialog>("abort_dialog").isVisible());
  QTest::keyPress(window_->windowHandle(), Qt::Key_F12);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, IsClickedBesideADialog) {
  QTest::keyClick(window_.get(), Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(find<QDialog>("abort_dialog").isVisible());
  auto& button = find<QPushButton>("emergency_stop");
  QTest::mousePress(window_->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                    button.mapTo(window_.get(), button.rect().center()));
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, WorksFromTheParticipantsWindow) {
  QWidget participant{};
  participant.show();
  participant.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&participant, kPatience_ms));
  QTest::keyPress(participant.windowHandle(), Qt::Key_F12);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, HappensWhenItsButtonIsPressedNotWhenItIsReleased) {
  QTest::mousePress(&find<QPushButton>("emergency_stop"), Qt::LeftButton);
  EXPECT_EQ(fault(), Fault::emergency_stop);
}

TEST_F(EmergencyStop, SaysWhatWasZeroedAndContinuesOnlyWhenItIsSafe) {
  QTest::keyPress(window_.get(), Qt::Key_F12);
  EXPECT_TRUE(find<QLabel>("fault_text").isVisible());
  EXPECT_TRUE(find<QLabel>("fault_text").text().contains("is awaited"));
  session_.set_phase(SessionPhase::fault);
  session_.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::emergency_stop;
    s.trouble = SessionTrouble{
        .what =
            "The emergency stop was pressed in trial 17. The force is zero until the fault is "
            "cleared.",
        .time_ns = s.now_ns,
        .remedy = SessionTrouble::Remedy::clear_fault};
  });
  window_->refresh();
  EXPECT_TRUE(find<QLabel>("fault_text").text().contains("EMERGENCY STOP at "));
  EXPECT_TRUE(find<QLabel>("fault_text").text().contains("pressed in trial 17. The force is zero"));

  auto& clear = find<QPushButton>("fault_clear");
  EXPECT_FALSE(clear.isEnabled());
  clear.click();
  EXPECT_FALSE(session_.requests.take_clear_fault());
  find<QAbstractButton>("fault_safe").click();
  clear.click();
  EXPECT_TRUE(session_.requests.take_clear_fault());

  session_.set_phase(SessionPhase::iti);
  session_.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::none;
    s.trouble.reset();
  });
  window_->refresh();
  EXPECT_FALSE(find<QLabel>("fault_text").isVisible());
}

TEST_F(EmergencyStop, SaysWhenClearingItFailedAndAsksAgain) {
  QTest::keyPress(window_.get(), Qt::Key_F12);
  session_.set_phase(SessionPhase::fault);
  const auto publish = [this](const char* what) {
    session_.monitor.update([what](SessionSnapshot& s) {
      s.now_ns += 50'000'000;
      s.fault = Fault::emergency_stop;
      s.trouble = SessionTrouble{
          .what = what, .time_ns = s.now_ns, .remedy = SessionTrouble::Remedy::clear_fault};
    });
    window_->refresh();
  };
  publish("The emergency stop was pressed.");
  find<QAbstractButton>("fault_safe").click();
  find<QPushButton>("fault_clear").click();
  window_->refresh();
  EXPECT_FALSE(find<QLabel>("fault_text").isVisible());
  EXPECT_TRUE(find<QLabel>("pending").text().contains("Clearing the fault"));
  publish("The device is not ready yet: it does not answer.");
  EXPECT_TRUE(find<QLabel>("fault_text").isVisible());
  EXPECT_TRUE(find<QLabel>("fault_text").text().contains("it does not answer"));
  EXPECT_FALSE(find<QPushButton>("fault_clear").isEnabled());
}

TEST_F(EmergencyStop, AsksAgainWhetherItIsSafeTheNextTime) {
  QTest::keyPress(window_.get(), Qt::Key_F12);
  find<QAbstractButton>("fault_safe").click();
  find<QPushButton>("fault_clear").click();
  window_->refresh();
  QTest::keyPress(window_.get(), Qt::Key_F12);
  EXPECT_FALSE(find<QPushButton>("fault_clear").isEnabled());
}

}  // namespace
}  // namespace asperity
