// The experimenter's window: what it shows of the session and of the trial under way.

#include <algorithm>
#include <chrono>
#include <iostream>

#include <QtCore/QTime>
#include <QtGui/QFontMetrics>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableView>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/live_plots.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/session/session_window_text.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(SessionWindow, SaysWhichSessionItIsAndHowFarItIs) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  EXPECT_TRUE(child<QLabel>(*window, "session_title").text().startsWith("Session 13 · P013 · "));
  window->resize(1280, 720);
  QCoreApplication::processEvents();
  EXPECT_TRUE(child<QLabel>(*window, "session_title")
                  .text()
                  .contains("Which of six pictures shows the felt texture?"))
      << child<QLabel>(*window, "session_title").text().toStdString();
  EXPECT_TRUE(child<QLabel>(*window, "session_title").text().endsWith(" · RUN"));
  EXPECT_EQ(child<QLabel>(*window, "block").text(), "Block 2 of 3");
  EXPECT_EQ(child<QLabel>(*window, "trial").text(), "trial 17 of 60");
  EXPECT_EQ(child<QLabel>(*window, "elapsed").text(), "18:42 elapsed");
  EXPECT_EQ(child<QLabel>(*window, "left").text(), "about 23 min left");
  EXPECT_EQ(child<QLabel>(*window, "now").text(), "Trial 17: feeling S2, 6.2 s");
  EXPECT_TRUE(child<QLabel>(*window, "health").text().contains("1000 Hz · p99 31 µs late"));
  EXPECT_TRUE(child<QLabel>(*window, "stored").text().contains("attempts stored: 18"));
}

TEST(SessionWindow, SaysAtWhatTimeOfDayTheSessionIsExpectedToEnd) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const std::int64_t machine_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                                      std::chrono::steady_clock::now().time_since_epoch())
                                      .count();
  SessionFacts facts = *session.monitor.facts();
  facts.row.pacing = "real_time";
  facts.clock_ahead_ns = session.monitor.snapshot().now_ns - machine_ns;
  session.monitor.set_facts(facts);
  session.monitor.update([](SessionSnapshot& s) { s.expected_left_s = 725.0; });
  const QTime before = QTime::currentTime();
  const auto window = session.window();
  const QString left = child<QLabel>(*window, "left").text();
  const QTime after = QTime::currentTime();
  const QString words = "about 12 min, until %1";
  EXPECT_TRUE(left == words.arg(before.addSecs(725).toString("HH:mm")) ||
              left == words.arg(after.addSecs(725).toString("HH:mm")))
      << left.toStdString();
}

TEST(SessionWindow, CanBeCancelledWhileItIsPrepared) {
  SessionMonitor preparing{};
  SessionRequests requests{};
  SessionWindow window(preparing, requests, {});
  const QSignalSpy cancelled(&window, &SessionWindow::cancel_wanted);
  auto& cancel = child<QPushButton>(window, "abort");
  EXPECT_TRUE(cancel.text().startsWith("Cancel"));
  EXPECT_TRUE(cancel.isEnabled());
  EXPECT_FALSE(child<QPushButton>(window, "pause").isEnabled());
  EXPECT_EQ(child<QProgressBar>(window, "progress").maximum(), 0) << "to and fro";
  EXPECT_FALSE(child<QLabel>(window, "why_disabled").text().contains("No session is under way"));
  preparing.update([](SessionSnapshot& s) { s.compared = 0.25; });
  window.show();
  EXPECT_TRUE(eventually([&] { return child<QProgressBar>(window, "progress").value() == 25; }));
  cancel.click();
  EXPECT_EQ(cancelled.size(), 1);
  EXPECT_FALSE(cancel.isEnabled());
  preparing.update([](SessionSnapshot& s) { s.phase = SessionPhase::ended; });
  window.show_end({.state = SessionState::stopped});
  EXPECT_TRUE(window.may_close());
}

TEST(SessionWindow, CancelsATrialWithTheMouseThatIsBeingPrepared) {
  for (const bool is_closed : {false, true}) {
    SessionMonitor preparing{};
    SessionRequests requests{};
    SessionWindow window(preparing, requests, {});
    window.set_only_tried(true);
    window.show();
    const QSignalSpy cancelled(&window, &SessionWindow::cancel_wanted);
    const QSignalSpy closed(&window, &SessionWindow::closed);
    auto& end = child<QPushButton>(window, "abort");
    if (is_closed) {
      window.close();
    } else {
      end.click();
    }
    EXPECT_EQ(child<QLabel>(window, "stored").text(), "nothing is stored in the study");
    EXPECT_EQ(cancelled.size(), 1);
    EXPECT_FALSE(end.isEnabled());
    EXPECT_EQ(closed.size(), 0);
    window.close();
    EXPECT_EQ(cancelled.size(), 1) << "once";
    preparing.update([](SessionSnapshot& s) { s.phase = SessionPhase::ended; });
    window.show_end({.state = SessionState::stopped});
    EXPECT_EQ(closed.size(), 1);
  }
}

TEST(SessionWindow, NamesEveryOutcomeInFullWhereConditionsAreHidden) {
  FilledMonitor session{};
  session.answer_up_to(34);
  const auto window = session.window();
  window->resize(1280, 720);
  window->show();
  const auto& plan = child<QTableView>(*window, "plan");
  ASSERT_TRUE(eventually([&] { return plan.columnWidth(2) > 0; }));
  constexpr int kCellPadding = 16;
  for (int row = 0; row < plan.model()->rowCount(); ++row) {
    const QString outcome = plan.model()->index(row, 2).data().toString();
    // A reason takes further lines.
    const QRect room(0, 0, plan.columnWidth(2) - kCellPadding, 10'000);
    const QRect needed = plan.fontMetrics().boundingRect(
        room, outcome.contains(": ") ? Qt::TextWordWrap : Qt::TextSingleLine, outcome);
    EXPECT_LE(needed.width(), room.width()) << outcome.toStdString();
    EXPECT_LE(needed.height(), plan.rowHeight(row)) << outcome.toStdString();
  }
}

TEST(SessionWindow, ShowsEveryCodeOfTheTrialUnderWay) {
  FilledMonitor session("chapter_matching", SessionMode::run);
  session.answer_up_to(1);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  window->resize(1366, 768);
  window->show();
  const QAbstractItemView& plan = child<QTableView>(*window, "plan");
  EXPECT_TRUE(eventually([&] {
    return child<QTableView>(*window, "plan").columnWidth(1) >= plan.sizeHintForColumn(1);
  }));
}

TEST(SessionWindow, KeepsTheButtonsOfItsDialogsApart) {
  FilledMonitor session{};
  session.answer_up_to(2);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  child<QPushButton>(*window, "abort").click();
  auto& dialog = child<QWidget>(*window, "abort_dialog");
  dialog.resize(300, 200);
  QCoreApplication::processEvents();
  const QRect field = child<QLineEdit>(dialog, "reason").geometry();
  EXPECT_FALSE(field.intersects(child<QPushButton>(dialog, "reason_given").geometry()))
      << field.width();
}

TEST(SessionWindow, TellsTheLastScreenFromTheFirst) {
  FilledMonitor session{};
  session.monitor.update([](SessionSnapshot& s) { s.trials_done = 0; });
  session.set_phase(SessionPhase::ready);
  EXPECT_TRUE(child<QLabel>(*session.window(), "now").text().startsWith("Preparation"));
  session.monitor.update([](SessionSnapshot& s) { s.trials_done = s.trials; });
  EXPECT_EQ(child<QLabel>(*session.window(), "now").text(),
            "After the last trial: the participant is reading");
}

TEST(SessionWindow, ShowsNoTimeLeftThatIsUnknown) {
  SessionMonitor preparing{};
  SessionRequests requests{};
  SessionWindow empty(preparing, requests, {});
  EXPECT_EQ(child<QLabel>(empty, "left").text(), "time left: –");
  FilledMonitor session{};
  session.monitor.update([](SessionSnapshot& s) { s.expected_left_s.reset(); });
  const auto window = session.window();
  EXPECT_EQ(child<QLabel>(*window, "left").text(), "time left: –");
}

TEST(SessionWindow, ShowsTheWholeNumberOfTheTrialUnderWay) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  const auto& plan = child<QTableView>(*window, "plan");
  const QFontMetrics letters(text_font(TextSize::body, true));
  constexpr int kCellPadding = 24;
  EXPECT_GE(plan.columnWidth(0), letters.horizontalAdvance("▶ 17") + kCellPadding);
}

/// A contact of which the force lay in its band for 75 %, the speed for 80 %.
void feel(FilledMonitor& session) {
  for (int i = 0; i < 600; ++i) {
    LiveBin bin{};
    bin.time_ns = i * 16'666'667LL;
    bin.touching = i < 500;
    session.monitor.add_bin(bin);
  }
  session.monitor.update([](SessionSnapshot& s) {
    s.hand = {
        .surface = 1,
        .force_N = {.samples = 8000, .mean = 1.4, .sd = 0.8, .fraction_in_band = 0.75},
        .speed_m_per_s = {.samples = 7000, .mean = 0.052, .sd = 0.016, .fraction_in_band = 0.8}};
  });
}

TEST(SessionWindow, SaysHowMuchOfTheContactLayInTheBands) {
  FilledMonitor session{};
  session.answer_up_to(16);
  feel(session);
  const auto window = session.window();
  EXPECT_TRUE(child<QLabel>(*window, "force_compliance").text().contains("in band 75 %"));
  EXPECT_TRUE(child<QLabel>(*window, "speed_compliance").text().contains("in band 80 %"));
}

// The trial that comes may be asked otherwise, and after the last one none comes.
TEST(SessionWindow, HoldsAContactToItsOwnBandsUntilTheNextTrialBegins) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  feel(session);
  const auto window = session.window();
  session.monitor.update([](SessionSnapshot& s) { s.trial = 0; });
  session.set_phase(SessionPhase::feedback);
  window->refresh();
  EXPECT_TRUE(child<QLabel>(*window, "force_compliance").text().contains("in band 75 %"));
}

TEST(SessionWindow, SaysOfTheMaskingNoiseWhatIsAndNothingWhereThereIsNone) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto health = [&](MaskingState masking) {
    session.monitor.update([masking](SessionSnapshot& s) { s.masking = masking; });
    const auto window = session.window();
    return child<QLabel>(*window, "health").text();
  };
  EXPECT_TRUE(health(MaskingState::on).endsWith("0 saturated · masking noise on"));
  EXPECT_TRUE(health(MaskingState::off).endsWith("0 saturated · masking noise off"));
  EXPECT_TRUE(health(MaskingState::none).endsWith("0 saturated"));
  EXPECT_TRUE(health(MaskingState::no_card).endsWith(" · no sound output: no masking noise"));
  EXPECT_TRUE(health(MaskingState::no_card).contains("▲"));
  EXPECT_TRUE(
      health(MaskingState::elsewhere).endsWith(" · masking noise from another source (measured)"));
  EXPECT_FALSE(health(MaskingState::elsewhere).contains("▲"));
  EXPECT_TRUE(health(MaskingState::silent)
                  .endsWith(" · the sound card produces no sound: no masking noise"));
}

TEST(SessionWindow, StatesWhyASurfaceThatAppearedAroundTheProbeHasNoForce) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  session.monitor.update([](SessionSnapshot& s) { s.is_inside = true; });
  const auto window = session.window();
  const QString health = child<QLabel>(*window, "health").text();
  EXPECT_TRUE(health.contains("the probe is inside the surface: no force until it has left"));
  EXPECT_TRUE(health.contains("▲"));
}

TEST(SessionWindow, SaysFromWhenTheTimeOfAnAnswerCounts) {
  FilledMonitor session{};
  session.answer_up_to(16);
  AttemptSummary attempt{};
  attempt.trial = 17;
  attempt.attempt = 1;
  attempt.outcome = AttemptOutcome::answered;
  attempt.answers = {"B, incorrect"};
  attempt.from_cue_s = 11.3;
  session.monitor.add_attempt(attempt);
  const auto window = session.window();
  for (const QSize size : {QSize(1366, 768), QSize(1280, 720)}) {
    window->resize(size);
    const auto& last = child<QLabel>(*window, "last_answer");
    EXPECT_TRUE(last.text().endsWith("11.3 s after the cue")) << last.text().toStdString();
    EXPECT_LE(last.sizeHint().width(), last.width()) << "nothing of it is cut off";
  }
}

TEST(SessionWindow, HandsTheFocusOfWhatGoesAwayToNoButton) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  child<QPushButton>(*window, "skip").click();
  ASSERT_TRUE(child<QLineEdit>(*window, "reason").hasFocus());
  QTest::keyClicks(&child<QLineEdit>(*window, "reason"), "unwell");
  QTest::keyClick(&child<QLineEdit>(*window, "reason"), Qt::Key_Return);
  const std::optional<Phrase> typed = session.requests.take_skip();
  EXPECT_EQ(typed, "unwell");
  EXPECT_EQ(typed->code(), nullptr);
  EXPECT_EQ(QApplication::focusWidget(), window.get());

  auto& skip = child<QPushButton>(*window, "skip");
  skip.setFocus();
  ASSERT_TRUE(skip.hasFocus());
  session.set_phase(SessionPhase::iti);  // no trial to be skipped any more
  window->refresh();
  EXPECT_FALSE(skip.isEnabled());
  EXPECT_EQ(QApplication::focusWidget(), window.get());

  QTest::keyClick(window.get(), Qt::Key_Tab);
  EXPECT_NE(QApplication::focusWidget(), window.get()) << "by Tab everything is reached";
}

TEST(SessionWindow, SaysBesideTheButtonsWhyOneCannotBePressed) {
  FilledMonitor session{};
  session.set_phase(SessionPhase::iti);
  const auto window = session.window();
  EXPECT_FALSE(child<QPushButton>(*window, "repeat_last").isEnabled());
  EXPECT_FALSE(child<QPushButton>(*window, "skip").isEnabled());
  const QString why = child<QLabel>(*window, "why_disabled").text();
  EXPECT_TRUE(why.contains("no trial has been completed yet"));
  EXPECT_TRUE(why.contains("no trial is under way"));
}

TEST(SessionWindow, ShowsTheMirrorThatItIsGiven) {
  FilledMonitor session{};
  const auto window = session.window();
  auto* mirror = new QLabel("what the participant sees");
  window->set_mirror(mirror);
  EXPECT_TRUE(window->isAncestorOf(mirror));
  EXPECT_TRUE(eventually([&] { return mirror->isVisible(); }));
}

// Printed, not asserted: how long a frame takes depends on what else the machine does.
TEST(SessionWindow, DrawsAFrameWithNewBins) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  session.stroke(12.0);
  const auto window = session.window();
  child<QPushButton>(*window, "unblind").click();
  give_reason(*window, "the dearest frame has the envelope of the force");
  QTest::qWait(20);
  std::vector<double> frames_ms{};
  for (int frame = 0; frame < 300; ++frame) {
    session.stroke(SessionMonitor::kBin_s);
    session.monitor.update([](SessionSnapshot& s) {
      s.now_ns += 16'666'667;
      s.contact_s += 1.0 / 60.0;
    });
    const auto began = std::chrono::steady_clock::now();
    window->refresh();
    QCoreApplication::sendPostedEvents();  // paints
    QCoreApplication::processEvents();
    frames_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began)
            .count());
  }
  std::sort(frames_ms.begin(), frames_ms.end());
  std::cout << "a frame: median " << frames_ms[150] << " ms, p95 " << frames_ms[285] << " ms\n";
  const auto* plots = window->findChild<LivePlots*>();
  EXPECT_GT(plots->pressing_points(), 590);
}

}  // namespace
}  // namespace asperity
