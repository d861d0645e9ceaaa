// The session window as it looks in a session, for people to look at.

#include <array>

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/fault_panel.h"
#include "app/words/reason.h"
#include "tests/gui/session/clipped.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// Whole and half screens of 768 and 1080 lines, under a bar and a title.
struct WindowShape {
  const char* name;
  QSize size;
  QSize picture;
};
constexpr std::array<WindowShape, 5> kShapes{{{"", {1366, 704}, {1366, 768}},
                                              {"-small", {1270, 688}, {1270, 688}},
                                              {"-large", {1920, 1016}, {1920, 1080}},
                                              {"-half", {683, 700}, {683, 700}},
                                              {"-half-large", {960, 1016}, {960, 1016}}}};

/// At every size nothing is clipped; pictures of it in both themes.
void look_at(SessionWindow& window, const QString& name) {
  auto& application = static_cast<QApplication&>(*QCoreApplication::instance());
  window.set_participant_window(true);
  for (const WindowShape& shape : kShapes) {
    window.resize(shape.size);
    window.refresh();
    // Banners and buttons find their height only once they have their width.
    (void)eventually([&] { return clipped_in(window).isEmpty(); });
    EXPECT_EQ(window.size(), shape.size) << name.toStdString();
    EXPECT_EQ(clipped_in(window).join("\n").toStdString(), "")
        << name.toStdString() << shape.name << " at " << shape.size.width();
  }
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) return;
  for (const bool dark : {false, true}) {
    apply_theme(application, dark ? ThemeChoice::dark : ThemeChoice::light);
    const QString look = dark ? "-dark" : "";
    for (const WindowShape& shape : kShapes) {
      take_screenshot(window, name + shape.name + look, shape.picture);
    }
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
  look_at(*window, "session-window");
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
  look_at(*window, "german-session-window");
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
  look_at(*window, "session-pilot");
}

TEST(SessionPictures, AStaircaseRuns) {
  FilledMonitor session("amplitude_jnd", SessionMode::pilot);
  session.answer_tracks(50, 38.0);
  session.set_phase(SessionPhase::contact);
  session.stroke(12.0);
  const auto window = session.window();
  window->findChild<QPushButton*>("unblind")->click();
  look_at(*window, "session-staircase");
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
  look_at(*window, "session-emergency");
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
  look_at(*window, "session-screen-lost");
}

TEST(SessionPictures, TheDiskIsFull) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  window->show_failure(
      "The study could not be written: database or disk is full. The force is zero and the "
      "session has stopped. Every completed trial is stored (18 attempts since the session was "
      "started or resumed). Fix the cause, then resume this session from the page Sessions.",
      AfterFailure::go_on);
  look_at(*window, "session-disk-full");
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
      "did not begin and no trial was run. Fix the cause, then start it again.",
      AfterFailure::start_again);
  look_at(window, "session-not-begun");
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
  look_at(*window, "german-session-emergency");
  EXPECT_TRUE(window->findChild<FaultPanel*>()->text().endsWith(
      "Der NOT-HALT wurde in Durchgang 17 gedrückt. Die Kraft ist null, bis der Halt quittiert "
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
  look_at(*window, "session-skip");
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
  look_at(*window, "session-end");
}

}  // namespace
}  // namespace asperity
