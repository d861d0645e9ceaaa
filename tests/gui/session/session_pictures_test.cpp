// The session window as it looks in a session, for people to look at.

#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/conductor/reason.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/fault_panel.h"
#include "app/gui/study/settings.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

void take_both(SessionWindow& window, const QString& name) {
  auto& application = static_cast<QApplication&>(*QCoreApplication::instance());
  for (const bool dark : {false, true}) {
    apply_theme(application, dark ? ThemeChoice::dark : ThemeChoice::light);
    const QString look = dark ? "-dark" : "";
    take_screenshot(window, name + look, {1366, 768});
    take_screenshot(window, name + "-large" + look, {1920, 1080});
  }
  apply_theme(application, ThemeChoice::light);
}

TEST(SessionPictures, ASurfaceIsFelt) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  session.stroke(25.0);
  const auto window = session.window();
  for (QPushButton* phrase : window->findChildren<QPushButton*>("phrase")) {
    if (phrase->text() != "Distracted") phrase->click();
  }
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "session-window");
}

TEST(SessionPictures, ASurfaceIsFeltInGerman) {
  apply_language("de");
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  session.stroke(25.0);
  const auto window = session.window();
  EXPECT_EQ(window->findChild<QPushButton*>("emergency_stop")->text(),
            QString("■ NOT-HALT\nF12 aus jedem Fenster"));
  EXPECT_LE(window->minimumSizeHint().width(), 1366);  // longer words fit too
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "german-session-window");
  apply_language("en");
}

TEST(SessionPictures, APilotIsPausedWithNamesShown) {
  FilledMonitor session("improved_selection", SessionMode::pilot);
  session.answer_up_to(9);
  session.set_phase(SessionPhase::paused);
  session.requests.pause();
  session.stroke(12.0);
  const auto window = session.window();
  window->findChild<QPushButton*>("unblind")->click();
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "session-pilot");
}

TEST(SessionPictures, TheEmergencyStopIsPressed) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.stroke(25.0);
  const auto window = session.window();
  window->findChild<QPushButton*>("emergency_stop")->pressed();
  session.set_phase(SessionPhase::fault);
  session.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::emergency_stop;
    s.trouble = SessionTrouble{
        .what =
            "The emergency stop was pressed in trial 17. The force is zero until the fault is "
            "cleared.",
        .time_ns = s.now_ns,
        .remedy = SessionTrouble::Remedy::clear_fault};
  });
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "session-emergency");
}

TEST(SessionPictures, TheParticipantsScreenIsLost) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::fault);
  session.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::emergency_stop;
    s.trouble = SessionTrouble{
        .what =
            "The emergency stop was pressed in trial 17. The force is zero until the fault is "
            "cleared.",
        .time_ns = s.now_ns,
        .remedy = SessionTrouble::Remedy::clear_fault};
  });
  session.stroke(25.0);
  const auto window = session.window();
  window->tell_screen_lost("HDMI-1", ScreenLoss::force_stopped);
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "session-screen-lost");
}

TEST(SessionPictures, TheDiskIsFull) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  window->show_failure(
      "The study could not be written: database or disk is full. The force is at zero and the "
      "session has stopped. Every finished trial is stored (16 of them in this stretch). When the "
      "cause is mended, go on with this session from the page Sessions.",
      AfterFailure::go_on);
  take_both(*window, "session-disk-full");
}

TEST(SessionPictures, ASessionDoesNotBegin) {
  SessionMonitor monitor{};
  SessionRequests requests{};
  SessionWindow window(monitor, requests, "/data/rough-surfaces");
  window.show();
  monitor.update([](SessionSnapshot& s) { s.phase = SessionPhase::ended; });
  window.refresh();
  window.show_failure(
      "The lock session-P013 is in use by process 4711 on host lab1, started 09:12. The session "
      "did "
      "not begin and no trial was run. When the cause is mended, start it again.",
      AfterFailure::start_again);
  take_both(window, "session-not-begun");
}

TEST(SessionPictures, TheEmergencyStopIsPressedInGerman) {
  apply_language("de");
  FilledMonitor session{};
  session.answer_up_to(16);
  session.stroke(25.0);
  const auto window = session.window();
  window->findChild<QPushButton*>("emergency_stop")->pressed();
  session.set_phase(SessionPhase::fault);
  session.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::emergency_stop;
    s.trouble = SessionTrouble{
        .what = phrase("Troubles", "%1 The force is zero until the stop is cleared.")
                    .with(phrase_of(Reason::stopped_in_trial).with("17").as_sentence()),
        .time_ns = s.now_ns,
        .remedy = SessionTrouble::Remedy::clear_fault};
  });
  window->refresh();
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "german-session-emergency");
  EXPECT_TRUE(window->findChild<FaultPanel*>()->text().endsWith(
      "Der NOT-HALT wurde in Durchgang 17 gedrückt. Die Kraft ist null, bis der Halt aufgehoben "
      "ist."))
      << window->findChild<FaultPanel*>()->text().toStdString();
  apply_language("en");
}

TEST(SessionPictures, AReasonIsAskedWhileTheParticipantAnswers) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.open_response(true);
  session.stroke(25.0);
  const auto window = session.window();
  window->findChild<QPushButton*>("skip")->click();
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  take_both(*window, "session-skip");
}

TEST(SessionPictures, DialogsAreOpen) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  window->findChild<QPushButton*>("abort")->click();
  auto* abort = window->findChild<QWidget*>("abort_dialog");
  take_screenshot(*abort, "session-abort", abort->sizeHint());
  abort->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(window->may_close());
  auto* close = window->findChild<QWidget*>("close_dialog");
  take_screenshot(*close, "session-close", close->sizeHint());
}

TEST(SessionPictures, TheSessionHasEnded) {
  FilledMonitor session{};
  session.answer_up_to(static_cast<int>(session.plan->trials.size()));
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  take_both(*window, "session-end");
}

}  // namespace
}  // namespace asperity
