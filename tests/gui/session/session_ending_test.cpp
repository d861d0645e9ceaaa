// The troubles of a session in the experimenter's window, its end, and its closing.

#include <algorithm>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/session/session_window_text.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(SessionWindow, ShowsATroubleWithTheButtonThatHelps) {
  FilledMonitor session{};
  session.answer_up_to(4);
  session.requests.pause();
  session.set_phase(SessionPhase::paused);
  session.monitor.update([](SessionSnapshot& s) {
    s.trouble = SessionTrouble{.what = "The masking noise stopped; the session is paused.",
                               .time_ns = s.now_ns,
                               .remedy = SessionTrouble::Remedy::resume};
  });
  const auto window = session.window();
  const auto& banner = child<QWidget>(*window, "trouble");
  ASSERT_TRUE(banner.isVisible());
  const auto buttons = banner.findChildren<QPushButton*>();
  const auto resume = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Resume";
  });
  ASSERT_NE(resume, buttons.end());
  (*resume)->click();
  EXPECT_FALSE(session.requests.pending().pause);
}

TEST(SessionWindow, ShowsWhatTheDeviceComplainsOfUntilItIsOver) {
  FilledMonitor session{};
  session.answer_up_to(4);
  const auto window = session.window();
  EXPECT_FALSE(child<QWidget>(*window, "device_trouble").isVisible());
  const auto complain = [&](const std::string& complaint) {
    session.monitor.update([&](SessionSnapshot& s) { s.device_complaint = complaint; });
    window->refresh();
  };
  complain("Its motors are warm.");
  const auto& banner = child<QWidget>(*window, "device_trouble");
  EXPECT_TRUE(banner.isVisible());
  EXPECT_TRUE(texts_of(banner).filter("The device reports: Its motors are warm.").size() > 0);
  complain("");
  EXPECT_FALSE(banner.isVisible());
}

TEST(SessionWindow, HidesTheBannerOnceTheTroubleIsOver) {
  FilledMonitor session{};
  session.answer_up_to(4);
  session.monitor.update([](SessionSnapshot& s) {
    s.trouble = SessionTrouble{.what = "The disk is nearly full.", .time_ns = s.now_ns};
  });
  const auto window = session.window();
  ASSERT_TRUE(child<QWidget>(*window, "trouble").isVisible());
  session.monitor.update([](SessionSnapshot& s) { s.trouble.reset(); });
  window->refresh();
  EXPECT_FALSE(child<QWidget>(*window, "trouble").isVisible());
}

TEST(SessionWindow, OffersNoWayOnAfterAFaultThatCannotBeCleared) {
  FilledMonitor session{};
  session.answer_up_to(4);
  session.set_phase(SessionPhase::fault);
  session.monitor.update([](SessionSnapshot& s) {
    s.fault = Fault::device_lost;
    s.trouble = SessionTrouble{.what = "The device does not answer.", .time_ns = s.now_ns};
  });
  const auto window = session.window();
  EXPECT_TRUE(child<QLabel>(*window, "fault_text").text().contains("The device does not answer."));
  EXPECT_FALSE(child<QPushButton>(*window, "fault_clear").isVisible());
}

TEST(SessionWindow, DoesNotCountTrialsThatWereNotNeededAsCompleted) {
  FilledMonitor session{};
  session.answer_up_to(static_cast<int>(session.plan->trials.size()));
  session.monitor.update([](SessionSnapshot& s) { s.trials_not_needed = 6; });
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  const QString text = child<QLabel>(*window, "end_text").text();
  EXPECT_TRUE(text.contains("Trials completed: 54 of 60. Trials not needed,"))
      << text.toStdString();
  EXPECT_TRUE(text.contains("could no longer be: 6. Attempts: ")) << text.toStdString();
}

TEST(SessionWindow, SumsUpASessionThatHasEnded) {
  FilledMonitor session{};
  session.answer_up_to(static_cast<int>(session.plan->trials.size()));
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  EXPECT_TRUE(child<QLabel>(*window, "end_title").isVisible());
  EXPECT_TRUE(child<QLabel>(*window, "end_title").text().contains("complete"));
  EXPECT_TRUE(child<QLabel>(*window, "end_text").text().contains("Trials completed: 60 of 60"));
  EXPECT_TRUE(child<QLabel>(*window, "end_text").text().contains("7 flagged"));
  EXPECT_FALSE(child<QLabel>(*window, "end_text").text().contains("not needed"));
  EXPECT_TRUE(child<QLabel>(*window, "end_text").text().contains("7 × too fast: 41 % in band"));
  EXPECT_TRUE(
      child<QLabel>(*window, "end_place").text().contains("/data/rough-surfaces/study.sqlite"));
  QSignalSpy trials(window.get(), &SessionWindow::trials_wanted);
  QSignalSpy results(window.get(), &SessionWindow::results_wanted);
  QSignalSpy closed(window.get(), &SessionWindow::closed);
  child<QPushButton>(*window, "see_trials").click();
  child<QPushButton>(*window, "see_table").click();
  EXPECT_EQ(trials.count(), 1);
  EXPECT_EQ(results.count(), 1);
  child<QPushButton>(*window, "close").click();
  EXPECT_EQ(closed.count(), 1);
  EXPECT_FALSE(window->isVisible());
}

TEST(SessionWindow, SaysWhatStoppedASessionEarly) {
  FilledMonitor session{};
  session.answer_up_to(9);
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  window->show_end({.state = SessionState::stopped, .reason = "on request, after the block"});
  EXPECT_TRUE(child<QLabel>(*window, "end_title").text().contains("stopped"));
  const QString text = child<QLabel>(*window, "end_text").text();
  EXPECT_TRUE(text.contains("on request, after the block"));
  EXPECT_TRUE(text.contains("Resume the session now"));
  // The trial under way may be lost: what is stored is what was finished.
  const QString place = child<QLabel>(*window, "end_place").text();
  EXPECT_TRUE(place.startsWith("Every completed trial is stored in ")) << place.toStdString();
}

TEST(SessionWindow, ShowsHowTheResponsesToAnchorsChanged) {
  FilledMonitor session{};
  session.answer_up_to(static_cast<int>(session.plan->trials.size()));
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  window->show_end({.anchors = {Phrase("Anchors of block 1: 12 → 10 → 6.")}});
  EXPECT_TRUE(
      child<QLabel>(*window, "end_text").text().endsWith("\nAnchors of block 1: 12 → 10 → 6."));
}

TEST(SessionWindow, HidesTheAnchorsOfASessionThatCanBeResumedWhileItIsBlind) {
  FilledMonitor session("improved_selection", SessionMode::pilot);
  session.answer_up_to(9);
  session.set_phase(SessionPhase::ended);
  const auto window = session.window();
  window->show_end({.state = SessionState::stopped,
                    .reason = "on request, after the block",
                    .anchors = {Phrase("Anchors of block 1: correct → incorrect.")}});
  const auto& text = child<QLabel>(*window, "end_text");
  EXPECT_FALSE(text.text().contains("Anchors of block 1")) << text.text().toStdString();
  child<QPushButton>(*window, "unblind").click();
  EXPECT_TRUE(text.text().contains("Anchors of block 1: correct → incorrect."));
}

TEST(SessionWindow, AsksBeforeItClosesInASession) {
  FilledMonitor session{};
  session.answer_up_to(9);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  QSignalSpy closed(window.get(), &SessionWindow::closed);
  window->close();
  EXPECT_TRUE(window->isVisible());
  ASSERT_TRUE(child<QDialog>(*window, "close_dialog").isVisible());
  child<QPushButton>(*window, "close_keep").click();
  EXPECT_TRUE(window->isVisible());
  EXPECT_FALSE(session.requests.pending().stop.has_value());
  EXPECT_EQ(closed.count(), 0);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

  EXPECT_FALSE(window->may_close());
  child<QPushButton>(*window, "close_stop").click();
  EXPECT_EQ(session.requests.pending().stop, StopAfter::trial);
  EXPECT_TRUE(window->isVisible()) << "until the session has ended";
  session.set_phase(SessionPhase::ended);
  window->refresh();
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(closed.count(), 1);
  EXPECT_TRUE(window->may_close());
}

TEST(SessionWindow, AsksAlsoWhileTheSessionIsStillBeingPrepared) {
  SessionMonitor monitor{};  // no facts yet
  SessionRequests requests{};
  SessionWindow window(monitor, requests, {});
  window.show();
  QSignalSpy closed(&window, &SessionWindow::closed);
  window.close();
  EXPECT_EQ(closed.count(), 0);
  EXPECT_TRUE(window.isVisible());
  child<QPushButton>(window, "close_abort").click();
  EXPECT_TRUE(requests.take_abort().has_value());
}

TEST(SessionWindow, AbortsASessionWhoseWindowIsToGoAtOnce) {
  FilledMonitor session{};
  session.answer_up_to(9);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  window->close();
  child<QPushButton>(*window, "close_abort").click();
  EXPECT_TRUE(session.requests.take_abort().has_value());
}

TEST(SessionWindow, ClosesAfterAFailureWithoutAQuestion) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  window->show_failure("The disk is full: study.sqlite could not be written.", AfterFailure::go_on);
  EXPECT_TRUE(child<QWidget>(*window, "news").isVisible());
  EXPECT_TRUE(window->may_close());
}

TEST(SessionWindow, OffersWhatHelpsAfterAFailure) {
  struct Case {
    AfterFailure way;
    const char* verb;
  };
  for (const Case& each : {Case{AfterFailure::start_again, "Try again"},
                           Case{AfterFailure::check_again, "Check again"},
                           Case{AfterFailure::go_on, "Resume this session…"}}) {
    FilledMonitor session{};
    session.answer_up_to(2);
    session.set_phase(SessionPhase::ended);
    const auto window = session.window();
    QSignalSpy wanted(window.get(), &SessionWindow::way_on_wanted);
    window->show_failure("It broke off.", each.way);
    EXPECT_EQ(child<Banner>(*window, "news").text(), "It broke off.");
    const auto buttons = child<QWidget>(*window, "news").findChildren<QPushButton*>();
    const auto helps = std::find_if(buttons.begin(), buttons.end(), [&](const QPushButton* button) {
      return button->text() == each.verb;
    });
    ASSERT_NE(helps, buttons.end()) << each.verb;
    QTest::mouseClick(*helps, Qt::LeftButton);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted.first().first().value<AfterFailure>(), each.way);
  }
}

TEST(SessionWindow, OffersToTryAndToCheckAgainWhereNothingHasBegun) {
  SessionMonitor monitor{};
  SessionRequests requests{};
  SessionWindow window(monitor, requests, "/data/rough-surfaces");
  window.show();
  monitor.update([](SessionSnapshot& s) { s.phase = SessionPhase::ended; });
  window.refresh();
  window.show_failure("The study is in use by process 7.", AfterFailure::start_again);
  EXPECT_TRUE(child<QLabel>(window, "end_title").text().contains("did not begin"));
  EXPECT_EQ(child<QLabel>(window, "now").text(), "The session did not begin");
  EXPECT_FALSE(child<QPushButton>(window, "resume").isVisible());
  EXPECT_FALSE(child<QPushButton>(window, "see_table").isVisible());
  QSignalSpy wanted(&window, &SessionWindow::way_on_wanted);
  QTest::mouseClick(&child<QPushButton>(window, "start_again"), Qt::LeftButton);
  QTest::mouseClick(&child<QPushButton>(window, "check_everything_again"), Qt::LeftButton);
  ASSERT_EQ(wanted.count(), 2);
  EXPECT_EQ(wanted.at(0).first().value<AfterFailure>(), AfterFailure::start_again);
  EXPECT_EQ(wanted.at(1).first().value<AfterFailure>(), AfterFailure::check_again);
}

TEST(SessionWindow, OffersToGoOnWithWhatWasStoppedButNotWithWhatIsOver) {
  struct Case {
    SessionEnd end;
    bool goes_on;
  };
  for (const Case& each : {Case{{.state = SessionState::stopped, .reason = "as asked"}, true},
                           Case{{.state = SessionState::completed}, false},
                           Case{{.state = SessionState::stopped,
                           .reason = "the criterion was not met",
                           .as_the_protocol_says = true},
                                false}}) {
    FilledMonitor session{};
    session.answer_up_to(9);
    session.set_phase(SessionPhase::ended);
    const auto window = session.window();
    window->show_end(each.end);
    auto& go_on = child<QPushButton>(*window, "resume");
    EXPECT_EQ(go_on.isVisible(), each.goes_on) << each.end.reason.english();
    EXPECT_EQ(child<QLabel>(*window, "end_text").text().contains("Resume the session now"),
              each.goes_on);
    // One filled button on the page.
    EXPECT_EQ(go_on.property("role").toString(), each.goes_on ? "primary" : "plain");
    EXPECT_EQ(child<QPushButton>(*window, "see_table").property("role").toString(),
              each.goes_on ? "plain" : "primary");
    if (!each.goes_on) continue;
    QSignalSpy wanted(window.get(), &SessionWindow::way_on_wanted);
    QTest::mouseClick(&go_on, Qt::LeftButton);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted.first().first().value<AfterFailure>(), AfterFailure::go_on);
  }
}

}  // namespace
}  // namespace asperity
