// The plan of a session in the experimenter's window: its rows, their marks, the responses.

#include <QtCore/QRegularExpression>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTableView>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/session/plan_table.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(SessionWindow, ElidesNeitherTitleNorNamesOfThePlan) {
  FilledMonitor session("improved_selection", SessionMode::pilot);
  session.answer_up_to(9);
  session.set_phase(SessionPhase::paused);
  session.requests.pause();
  const auto window = session.window();
  child<QPushButton>(*window, "unblind").click();
  const auto& plan = child<QTableView>(*window, "plan");
  const auto& title = child<QLabel>(*window, "session_title");
  for (const QSize size : {QSize(683, 700), QSize(1270, 688), QSize(1920, 1016)}) {
    window->resize(size);
    window->refresh();
    QCoreApplication::processEvents();
    // A heading has the room of all columns.
    const QStringList cut = cut_cells(plan).filter(QRegularExpression("^(?!Block )"));
    EXPECT_EQ(cut.join(" | ").toStdString(), "") << size.width();
    EXPECT_EQ(title.text(), title.toolTip()) << size.width();
  }
}

TEST(SessionWindow, MarksTheTrialUnderWayAndSaysEveryAttempt) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::contact);
  const auto window = session.window();
  auto& model = window->findChild<PlanTable*>()->model();
  const auto text = [&model](int trial, int column) {
    return model.index(model.row_of(trial), column).data().toString();
  };
  EXPECT_EQ(text(17, 0), "▶ 17");
  EXPECT_EQ(text(17, 2), "feeling 6.2 s");
  EXPECT_EQ(text(16, 0), "16");
  EXPECT_TRUE(text(10, 2).endsWith(" · attempt 2")) << text(10, 2).toStdString();
  const QString history =
      model.index(model.row_of(10), 2).data(Qt::ToolTipRole).toString().section('\n', 0, 0);
  EXPECT_TRUE(history.endsWith("previously: not explored as instructed")) << history.toStdString();
  EXPECT_EQ(text(6, 2), "▲ skipped");
  // The reason, so that the participant can be corrected after the trial.
  EXPECT_TRUE(text(13, 2).endsWith("flagged: too fast: 41 % in band")) << text(13, 2).toStdString();
}

/// The rows of the plan that are marked, "17: next".
QStringList marked(SessionWindow& window) {
  window.refresh();
  const auto& model = window.findChild<PlanTable*>()->model();
  QStringList rows{};
  for (int row = 0; row < model.rowCount(); ++row) {
    const QString number = model.index(row, 0).data().toString();
    if (!number.startsWith("▶ ")) continue;
    rows += QString("%1: %2").arg(number.mid(2), model.index(row, 2).data().toString());
  }
  return rows;
}

TEST(SessionWindow, MarksTheTrialThatComesInEveryPhaseBetweenTrials) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  const auto& model = window->findChild<PlanTable*>()->model();
  const auto in = [&](SessionPhase phase) {
    session.set_phase(phase);
    return marked(*window);
  };
  for (const SessionPhase phase :
       {SessionPhase::iti, SessionPhase::feedback, SessionPhase::ready, SessionPhase::questions}) {
    EXPECT_EQ(in(phase), QStringList{"17: next"}) << text_of(phase);
    EXPECT_TRUE(model.index(model.row_of(16), 2).data().toString().startsWith("✓ "));
  }
  EXPECT_EQ(in(SessionPhase::rest), QStringList{"17: after the break"});
  EXPECT_EQ(in(SessionPhase::paused), QStringList{"17: paused before this trial"});
  EXPECT_EQ(in(SessionPhase::contact), QStringList{"17: feeling 6.2 s"});
  session.set_phase(SessionPhase::feedback);
  window->refresh();
  EXPECT_EQ(child<QLabel>(*window, "now").text(), "Trial 16: feedback");
  EXPECT_TRUE(child<QLabel>(*window, "trial").text().startsWith("trial 16 of "))
      << "the trial that the feedback is about";
}

TEST(SessionWindow, MarksNoTrialWhereNoneComes) {
  FilledMonitor session{};
  session.answer_up_to(60);
  const auto window = session.window();
  for (const SessionPhase phase :
       {SessionPhase::rest, SessionPhase::questions, SessionPhase::ended}) {
    session.set_phase(phase);
    EXPECT_EQ(marked(*window), QStringList{}) << text_of(phase);
  }
  EXPECT_EQ(child<QLabel>(*window, "trial").text(), "trials: 60");
}

TEST(SessionWindow, MarksWhatTheExperimenterHasAskedFor) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.set_phase(SessionPhase::rest);
  const auto window = session.window();
  session.requests.repeat_last("wrong key");
  EXPECT_TRUE(marked(*window).join("").startsWith("16: after the break · attempt 2"));
  session.requests.stop_after(StopAfter::trial);
  EXPECT_EQ(marked(*window), QStringList{}) << "the session ends";
  session.set_phase(SessionPhase::contact);
  EXPECT_EQ(marked(*window), QStringList{"17: feeling 6.2 s"}) << "which is still under way";
  session.requests.take_repeat();
  session.requests.stop_after(StopAfter::block);
  session.set_phase(SessionPhase::iti);
  EXPECT_EQ(marked(*window), QStringList{"17: next"}) << "of the same block";
  const auto& header = child<QLabel>(*window, "now");
  EXPECT_EQ(header.text(), "Between trials; next: trial 17");
  session.monitor.update([](SessionSnapshot& s) { s.block = 1; });
  EXPECT_EQ(marked(*window), QStringList{}) << "the block is over";
  EXPECT_EQ(header.text(), "Between trials");
}

TEST(SessionWindow, ShowsResponsesOnLinesWithoutRoundingErrors) {
  FilledMonitor session{};
  session.answer_up_to(1);
  AttemptSummary attempt{};
  attempt.trial = 5;
  attempt.attempt = 1;
  attempt.answers = {"25.799999999999997", "-42.4", "-8.400000000000006", "59.80000000000001"};
  session.monitor.add_attempt(attempt);
  const auto window = session.window();
  const auto& model = window->findChild<PlanTable*>()->model();
  EXPECT_EQ(model.index(model.row_of(5), 2).data().toString(), "✓ 25.8 −42.4 −8.4 59.8");
  EXPECT_TRUE(child<QLabel>(*window, "last_answer").text().contains("25.8 −42.4 −8.4 59.8"));
}

TEST(SessionWindow, CallsAnEmergencyStopByItsNameInThePlan) {
  FilledMonitor session{};
  session.answer_up_to(1);
  AttemptSummary attempt{};
  attempt.trial = 5;
  attempt.attempt = 1;
  attempt.outcome = AttemptOutcome::emergency_stop;
  attempt.valid = false;
  attempt.reason = "the emergency stop was pressed";
  session.monitor.add_attempt(attempt);
  const auto window = session.window();
  const auto& model = window->findChild<PlanTable*>()->model();
  EXPECT_EQ(model.index(model.row_of(5), 2).data().toString(), "▲ emergency stop");
}

TEST(SessionWindow, KeepsTheTrialUnderWayInSightUntilThePersonScrolls) {
  FilledMonitor session{};
  session.answer_up_to(1);
  const auto window = session.window();
  auto& plan = *window->findChild<PlanTable*>();
  auto& view = child<QTableView>(*window, "plan");
  const auto in_sight = [&](int trial) {
    return view.viewport()->rect().contains(
        view.visualRect(plan.model().index(plan.model().row_of(trial), 0)));
  };
  session.answer_up_to(49);
  window->refresh();
  EXPECT_TRUE(in_sight(50));
  view.verticalScrollBar()->triggerAction(QAbstractSlider::SliderToMinimum);
  session.answer_up_to(51);
  window->refresh();
  EXPECT_FALSE(plan.is_following());
  EXPECT_FALSE(in_sight(52));
  child<QPushButton>(*window, "plan_follow").click();
  EXPECT_TRUE(in_sight(52));
}

}  // namespace
}  // namespace asperity
