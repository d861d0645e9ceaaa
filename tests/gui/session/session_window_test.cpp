// The experimenter's window: what it shows and hides, and what it asks.

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>

#include <QtCore/QRegularExpression>
#include <QtCore/QTime>
#include <QtGui/QAction>
#include <QtGui/QFontMetrics>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTableView>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/fitted_label.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/track_panel.h"
#include "tests/gui/session/clipped.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// Everything that a person can read in a window, tool tips included.
QStringList texts_of(const QWidget& window) {
  QStringList texts{window.windowTitle()};
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    texts += {widget->toolTip(), widget->windowTitle(), widget->accessibleName()};
    for (const char* const property : {"text", "placeholderText", "words"}) {
      texts += widget->property(property).toString();
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(widget);
    if (view == nullptr || view->model() == nullptr) continue;
    const QAbstractItemModel& model = *view->model();
    for (int row = 0; row < model.rowCount(); ++row) {
      for (int column = 0; column < model.columnCount(); ++column) {
        for (int role = 0; role <= Qt::UserRole + 8; ++role) {
          const QVariant value = model.index(row, column).data(role);
          if (value.typeId() == QMetaType::QString) texts += value.toString();
        }
      }
    }
  }
  return texts;
}

/// What nobody may read who is blind.
QStringList names_of(const FilledMonitor& session) {
  QStringList names{};
  for (const auto& [name, texture] : session.protocol->textures) {
    names += QString::fromStdString(name);
  }
  for (const Trial& trial : session.plan->trials) {
    for (const PlannedPresentation& surface : trial.presentations) {
      names += QString::fromStdString(surface.stimulus.model);
      names += QString::fromStdString(surface.stimulus.texture);
    }
  }
  names.removeDuplicates();
  names.removeAll("");
  return names;
}

QStringList names_shown(const QWidget& window, const FilledMonitor& session) {
  QStringList shown{};
  for (const QString& name : names_of(session)) {
    const QRegularExpression word("\\b" + QRegularExpression::escape(name) + "\\b",
                                  QRegularExpression::CaseInsensitiveOption);
    if (!texts_of(window).filter(word).isEmpty()) shown += name;
  }
  return shown;
}

void give_reason(const QWidget& window, const QString& reason) {
  child<QLineEdit>(window, "reason").setText(reason);
  child<QPushButton>(window, "reason_given").click();
}

std::vector<std::string> kinds(const std::vector<SessionRequests::Remark>& remarks) {
  std::vector<std::string> names{};
  for (const auto& remark : remarks) names.push_back(remark.kind);
  return names;
}

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

// A screen of 1280 × 720, of which a frame takes some.
TEST(SessionWindow, HasRoomForPlanPlotsAndPhrasesOnASmallScreen) {
  for (const QSize size : {QSize(1270, 688), QSize(1180, 688), QSize(1180, 800)}) {
    FilledMonitor session{};
    session.answer_up_to(16);
    session.set_phase(SessionPhase::contact);
    const auto window = session.window();
    window->resize(size);
    window->show();
    const std::string at = std::to_string(size.width()) + " × " + std::to_string(size.height());
    EXPECT_TRUE(eventually([&] { return clipped_in(*window).isEmpty(); }))
        << at << clipped_in(*window).join("\n").toStdString();
    const auto& plan = child<QTableView>(*window, "plan");
    EXPECT_GE(plan.viewport()->height(), 5 * plan.rowHeight(1)) << at;
    if (auto* show_notes = window->findChild<QPushButton*>("show_notes");
        show_notes != nullptr && show_notes->isVisible()) {
      show_notes->click();
    }
    const auto& notes = child<QWidget>(*window, "notes");
    const int top = notes.mapTo(window.get(), QPoint(0, 0)).y();
    for (const QPushButton* phrase : window->findChildren<QPushButton*>("phrase")) {
      if (!phrase->isVisible()) continue;
      EXPECT_LE(phrase->mapTo(window.get(), QPoint(0, phrase->height())).y(), top) << at;
    }
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

TEST(SessionWindow, ShowsNoNameAnywhereWhileItIsBlind) {
  for (const char* const protocol :
       {"improved_recognition", "improved_selection", "chapter_matching", "roughness_diameter"}) {
    FilledMonitor session(protocol);
    session.answer_up_to(1);
    session.set_phase(SessionPhase::contact);
    session.monitor.update([&session](SessionSnapshot& s) {
      const StimulusDescription& stimulus = session.plan->trials[0].presentations[0].stimulus;
      s.trouble = SessionTrouble{.what = "The model \"" + stimulus.model + "\" refused stimuli/" +
                                         stimulus.texture + ".png.",
                                 .time_ns = s.now_ns,
                                 .remedy = SessionTrouble::Remedy::resume};
    });
    session.stroke(3.0);
    const auto window = session.window();
    EXPECT_EQ(names_shown(*window, session).join(' ').toStdString(), "") << protocol;
    EXPECT_FALSE(texts_of(*window).filter("refused").isEmpty()) << "the rest of it is said";

    child<QPushButton>(*window, "unblind").click();
    give_reason(*window, "a surface feels wrong");
    EXPECT_FALSE(names_shown(*window, session).isEmpty())
        << "otherwise this test would not see a name if there was one";
    child<QPushButton>(*window, "unblind").click();
    EXPECT_EQ(names_shown(*window, session).join(' ').toStdString(), "") << "blind again";
  }
}

TEST(SessionWindow, UnblindsForAReasonThatIsStoredAndStaysMarked) {
  FilledMonitor session{};
  session.answer_up_to(3);
  const auto window = session.window();
  child<QPushButton>(*window, "unblind").click();
  EXPECT_TRUE(window->is_blind());
  EXPECT_FALSE(child<QPushButton>(*window, "reason_given").isEnabled());
  give_reason(*window, "a surface feels wrong");
  EXPECT_FALSE(window->is_blind());
  EXPECT_TRUE(child<QLabel>(*window, "blindness").text().contains("UNBLINDED at"));
  const auto remarks = session.requests.take_remarks();
  ASSERT_EQ(kinds(remarks), std::vector<std::string>{"unblinded"});
  EXPECT_EQ(remarks.back().text, "a surface feels wrong");

  child<QPushButton>(*window, "unblind").click();
  EXPECT_TRUE(window->is_blind());
  EXPECT_TRUE(child<QLabel>(*window, "blindness").text().contains("UNBLINDED at"));
  EXPECT_EQ(kinds(session.requests.take_remarks()), std::vector<std::string>{"blinded_again"});
}

TEST(SessionWindow, ShowsTheRunningTracksUnlessBlind) {
  FilledMonitor session("amplitude_jnd", SessionMode::pilot);
  session.answer_tracks(20);
  const auto window = session.window();
  const auto& panel = child<TrackPanel>(*window, "track_panel");
  EXPECT_TRUE(panel.isVisibleTo(window.get()));
  EXPECT_TRUE(panel.lines().isEmpty()) << "blind";
  EXPECT_EQ(panel.marks(), 0);
  EXPECT_TRUE(panel.accessibleName().contains("hidden"));
  child<QPushButton>(*window, "unblind").click();
  ASSERT_FALSE(panel.lines().isEmpty());
  EXPECT_TRUE(panel.lines().front().startsWith("Track 1"));
  EXPECT_TRUE(panel.lines().front().contains(": mean of the reversals "))
      << panel.lines().front().toStdString();
  EXPECT_TRUE(panel.toolTip().startsWith(panel.lines().join('\n')));
  const int marks = panel.marks();
  EXPECT_GT(marks, 15);  // some of the twenty are catch trials
  session.answer_tracks(21);
  window->refresh();
  EXPECT_GE(panel.marks(), marks);
  child<QPushButton>(*window, "unblind").click();
  EXPECT_EQ(panel.marks(), 0) << "blind again";
  EXPECT_TRUE(panel.toolTip().isEmpty());
  EXPECT_TRUE(panel.accessibleName().contains("hidden"));
}

TEST(SessionWindow, ShowsThePosteriorOfATrack) {
  FilledMonitor session("amplitude_jnd_psi", SessionMode::pilot);
  session.answer_tracks(12);
  const auto window = session.window();
  child<QPushButton>(*window, "unblind").click();
  const QStringList lines = child<TrackPanel>(*window, "track_panel").lines();
  ASSERT_FALSE(lines.isEmpty());
  EXPECT_TRUE(lines.front().contains("posterior median")) << lines.front().toStdString();
  EXPECT_TRUE(lines.front().contains("95 % interval"));
}

TEST(SessionWindow, ShowsTheTracksOfAMatchingOfRoughness) {
  FilledMonitor session("realism_of_models", SessionMode::pilot);
  session.answer_tracks(16);
  const auto window = session.window();
  child<QPushButton>(*window, "unblind").click();
  EXPECT_GT(child<TrackPanel>(*window, "track_panel").lines().size(), 1);
}

TEST(SessionWindow, HasNoPlaceForTracksInOtherSessions) {
  FilledMonitor session{};
  session.answer_up_to(3);
  const auto window = session.window();
  EXPECT_FALSE(child<TrackPanel>(*window, "track_panel").isVisibleTo(window.get()));
}

TEST(SessionWindow, ShowsTheNamesOfAPilotAtOnce) {
  for (const SessionMode mode : {SessionMode::pilot, SessionMode::simulate}) {
    FilledMonitor session("improved_recognition", mode);
    session.answer_up_to(3);
    const auto window = session.window();
    EXPECT_TRUE(names_shown(*window, session).isEmpty());
    child<QPushButton>(*window, "unblind").click();
    EXPECT_FALSE(names_shown(*window, session).isEmpty());
    EXPECT_TRUE(kinds(session.requests.take_remarks()).empty());
  }
}

TEST(SessionWindow, DrawsThePressingForceAloneWhileItIsBlind) {
  FilledMonitor session{};
  session.answer_up_to(3);
  session.stroke(12.0);
  const auto window = session.window();
  const auto* plots = window->findChild<LivePlots*>();
  EXPECT_GT(plots->pressing_points(), 590);
  EXPECT_EQ(plots->sent_force_points(), 0);
  child<QPushButton>(*window, "unblind").click();
  give_reason(*window, "a surface feels wrong");
  EXPECT_GT(plots->sent_force_points(), 590);
  child<QPushButton>(*window, "unblind").click();
  EXPECT_EQ(plots->sent_force_points(), 0);
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

TEST(SessionWindow, HidesRightAndWrongWhileBlindButWhereTheParticipantIsTold) {
  FilledMonitor session{};
  session.answer_up_to(34);  // 28 trials of familiarisation and practice tell, the main ones do not
  const auto window = session.window();
  auto& model = window->findChild<PlanTable*>()->model();
  const auto outcome = [&model](int trial) {
    return model.index(model.row_of(trial), 2).data().toString();
  };
  EXPECT_TRUE(outcome(11).contains("correct")) << outcome(11).toStdString();
  EXPECT_EQ(outcome(32), "✓ 5");
  EXPECT_FALSE(child<QLabel>(*window, "last_answer").text().contains("correct"));
  child<QPushButton>(*window, "unblind").click();
  give_reason(*window, "a surface feels wrong");
  EXPECT_EQ(outcome(32), "✓ 5, correct");
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

TEST(SessionWindow, GreysTheNoteWhileKeysAnswerTheTrialAndSaysSo) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  auto& note = child<QLineEdit>(*window, "note");
  note.setFocus();
  ASSERT_TRUE(note.hasFocus());
  note.setText("half");
  session.open_response(true);
  window->refresh();
  EXPECT_FALSE(note.isEnabled());
  EXPECT_EQ(note.text(), "half");
  EXPECT_EQ(child<QLabel>(*window, "note_locked").text(), "Keys reserved for the response");
  const QWidget* focus = QApplication::focusWidget();
  EXPECT_EQ(qobject_cast<const QPushButton*>(focus), nullptr)
      << "the participant's Space would press it";

  auto& phrase = child<QPushButton>(*window, "phrase");
  QTest::mouseClick(&phrase, Qt::LeftButton);
  EXPECT_FALSE(phrase.hasFocus());
  EXPECT_EQ(kinds(session.requests.take_remarks()), std::vector<std::string>{"note"});

  session.open_response(false);
  window->refresh();
  EXPECT_TRUE(note.isEnabled());
  EXPECT_FALSE(note.hasFocus());
}

TEST(SessionWindow, LeavesTheNoteOpenToWhoHasAKeyboardOfTheirOwn) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  window->set_own_keyboard(true);
  session.open_response(true);
  window->refresh();
  EXPECT_TRUE(child<QLineEdit>(*window, "note").isEnabled());
}

TEST(SessionWindow, KeepsPhrasesOfOnesOwnForLaterSessions) {
  remember_note_phrases({});
  const auto phrases_of = [](const SessionWindow& window) {
    QStringList phrases{};
    for (const QPushButton* button : window.findChildren<QPushButton*>("phrase")) {
      phrases += button->property("phrase").toString();
    }
    return phrases;
  };
  FilledMonitor session{};
  session.answer_up_to(2);
  {
    const auto window = session.window();
    EXPECT_FALSE(phrases_of(*window).contains("Glove worn"));
    auto& keep = child<QPushButton>(*window, "keep_phrase");
    EXPECT_FALSE(keep.isVisible());
    child<QLineEdit>(*window, "note").setText("Glove worn");
    QTest::mouseClick(&keep, Qt::LeftButton);
    EXPECT_TRUE(kinds(session.requests.take_remarks()).empty()) << "kept, not noted";
  }
  const auto window = session.window();
  session.open_response(true);  // by mouse alone
  window->refresh();
  QPushButton* own = nullptr;
  for (QPushButton* button : window->findChildren<QPushButton*>("phrase")) {
    if (button->property("phrase") == "Glove worn") own = button;
  }
  ASSERT_NE(own, nullptr);
  QTest::mouseClick(own, Qt::LeftButton);
  const auto remarks = session.requests.take_remarks();
  ASSERT_EQ(kinds(remarks), std::vector<std::string>{"note"});
  EXPECT_EQ(remarks.front().text, "Glove worn");

  ASSERT_EQ(own->actions().size(), 1);
  own->actions().front()->trigger();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_FALSE(phrases_of(*window).contains("Glove worn"));
  EXPECT_TRUE(note_phrases().empty());
}

TEST(SessionWindow, ShowsItsPhrasesWholeAndLeavesSomeOutWhereThereIsNoRoom) {
  remember_note_phrases({"one", "two", "a phrase that is longer than any button"});
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  const auto buttons = window->findChildren<QPushButton*>("phrase");
  ASSERT_EQ(buttons.size(), 12);
  for (const QPushButton* button : buttons) {
    EXPECT_LE(button->fontMetrics().horizontalAdvance(button->text()), button->width() - 10)
        << button->text().toStdString();
    EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
  }
  window->resize(1366, window->minimumSizeHint().height());
  QCoreApplication::processEvents();
  EXPECT_TRUE(buttons.front()->isVisible()) << "one's own stay";
  EXPECT_FALSE(buttons.back()->isVisible());
  remember_note_phrases({});
}

TEST(SessionWindow, LetsTheOldestPhraseOfOnesOwnGo) {
  remember_note_phrases({"one", "two", "three"});
  FilledMonitor session{};
  const auto window = session.window();
  child<QLineEdit>(*window, "note").setText("four");
  child<QPushButton>(*window, "keep_phrase").click();
  EXPECT_EQ(note_phrases(), (QStringList{"two", "three", "four"}));
  remember_note_phrases({});
}

TEST(SessionWindow, AsksWhyATrialIsSkippedAndTakesAReasonByMouse) {
  FilledMonitor session{};
  session.answer_up_to(16);
  session.open_response(true);
  const auto window = session.window();
  child<QPushButton>(*window, "skip").click();
  EXPECT_FALSE(child<QLineEdit>(*window, "reason").isEnabled());
  const auto buttons = window->findChild<QWidget*>("reason_form")->findChildren<QPushButton*>();
  const auto ready = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Technical problem";
  });
  ASSERT_NE(ready, buttons.end());
  QTest::mouseClick(*ready, Qt::LeftButton);
  child<QPushButton>(*window, "reason_given").click();
  const std::optional<Phrase> chosen = session.requests.take_skip();
  ASSERT_TRUE(chosen);
  EXPECT_STREQ(chosen->code(), "technical_problem");
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

/// What somebody sees of the parts of the window, by its name.
QStringList parts_shown(const QWidget& window) {
  QStringList shown{};
  for (const char* const name : {"plan", "force_plot", "last_answer", "note", "show_plan"}) {
    if (child<QWidget>(window, name).isVisible()) shown += name;
  }
  return shown;
}

TEST(SessionWindow, ShowsItsPartsSideBySideOrOneAtATimeAsItsSizeAllows) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  const QStringList all{"plan", "force_plot", "last_answer", "note"};
  for (const QSize size : {QSize(1366, 700), QSize(960, 1016), QSize(960, 700), QSize(683, 700),
                           QSize(960, 1016), QSize(1366, 700), QSize(683, 700)}) {
    window->resize(size);
    const bool narrow = size.width() < 840 || (size.width() < 1264 && size.height() < 780);
    EXPECT_EQ(parts_shown(*window), narrow ? (QStringList{"plan", "show_plan"}) : all)
        << size.width() << " × " << size.height();
  }
  // By mouse, and by Tab and Space.
  QTest::mouseClick(&child<QPushButton>(*window, "show_plots"), Qt::LeftButton);
  EXPECT_EQ(parts_shown(*window), (QStringList{"force_plot", "show_plan"}));
  EXPECT_FALSE(child<QPushButton>(*window, "show_plots").hasFocus())
      << "it would hear the participant's Space";
  auto& notes = child<QPushButton>(*window, "show_notes");
  for (int i = 0; i < 30 && !notes.hasFocus(); ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  ASSERT_TRUE(notes.hasFocus());
  QTest::keyClick(&notes, Qt::Key_Space);
  EXPECT_EQ(parts_shown(*window), (QStringList{"last_answer", "note", "show_plan"}));
}

TEST(SessionWindow, BringsTheNotesForwardWhereSomebodyIsToTypeOne) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  window->resize(683, 700);
  ASSERT_FALSE(child<QLineEdit>(*window, "note").isVisible());
  QTest::keyClick(window.get(), Qt::Key_F2);
  EXPECT_TRUE(child<QLineEdit>(*window, "note").hasFocus());
}

TEST(SessionWindow, KeepsItsSizeWhateverStandsInIt) {
  FilledMonitor session{};
  session.answer_up_to(4);
  const auto window = session.window();
  for (const QSize size : {QSize(1366, 704), QSize(960, 1016), QSize(683, 700)}) {
    window->resize(size);
    session.requests.pause();
    session.requests.stop_after(StopAfter::block);
    session.set_phase(SessionPhase::paused);
    session.monitor.update([](SessionSnapshot& s) {
      s.health.missed_deadlines = 1'234'567;
      s.health.lost_records = 7'654'321;
      s.health.lateness_p99_s = 1.0;
      s.rows_stored = 1'000'000;
      s.trouble = SessionTrouble{.what = std::string(400, 'm') + " " + std::string(60, 'm'),
                                 .time_ns = s.now_ns};
    });
    window->refresh();
    window->tell_screen_lost(QString(80, 'W'), ScreenLoss::force_stopped);
    child<QPushButton>(*window, "skip").click();
    QTest::qWait(0);
    EXPECT_EQ(window->size(), size);
    EXPECT_TRUE(window->rect().contains(child<QPushButton>(*window, "emergency_stop").geometry()));
    session.requests.go_on();
  }
  EXPECT_LE(window->minimumWidth(), 683);
  EXPECT_LE(window->minimumHeight(), 700);
}

TEST(SessionWindow, BringsTheParticipantsWindowBackByButtonAndKeyWhereThereIsOne) {
  FilledMonitor session{};
  session.answer_up_to(4);
  const auto window = session.window();
  auto& button = child<QPushButton>(*window, "their_window");
  EXPECT_FALSE(button.isVisible()) << "a virtual participant has none";
  window->set_participant_window(true);
  for (const int width : {1366, 960, 683}) {
    window->resize(width, 700);
    ASSERT_TRUE(button.isVisible());
    QSignalSpy wanted(window.get(), &SessionWindow::participant_window_wanted);
    QTest::mouseClick(&button, Qt::LeftButton);
    QTest::keyClick(window.get(), Qt::Key_F9);
    EXPECT_EQ(wanted.count(), 2) << width;
    EXPECT_EQ(button.focusPolicy(), Qt::TabFocus);
  }
}

TEST(SessionWindow, SaysTheWholeOfALineInItsToolTipWhereItIsCut) {
  FittedLabel label{};
  label.show_state(State::look, "Stopping after this trial");
  label.show();
  label.resize(label.sizeHint());
  EXPECT_FALSE(label.is_cut());
  EXPECT_EQ(label.toolTip(), "");
  label.resize(label.width() - 2, label.height());
  EXPECT_TRUE(label.is_cut());
  EXPECT_EQ(label.toolTip(), "Stopping after this trial");
  label.set_smaller_font(text_font(TextSize::small));
  EXPECT_FALSE(label.is_cut());
  EXPECT_EQ(label.minimumSizeHint().width(), 0);
}

TEST(SessionWindow, SaysWhatWasDoneForALostScreenAndTakesTheWindowBack) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  auto& news = child<Banner>(*window, "news");
  window->tell_screen_lost("HDMI-1", ScreenLoss::force_stopped);
  EXPECT_TRUE(news.text().contains("“HDMI-1” was disconnected")) << news.text().toStdString();
  EXPECT_TRUE(news.text().contains("the force is zero"));
  window->tell_screen_lost("HDMI-1", ScreenLoss::pausing);
  EXPECT_TRUE(news.text().contains("the session pauses"));
  const auto buttons = news.findChildren<QPushButton*>();
  const auto back = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Restore window";
  });
  ASSERT_NE(back, buttons.end());
  QSignalSpy wanted(window.get(), &SessionWindow::participant_screen_back);
  QTest::mouseClick(*back, Qt::LeftButton);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted.first().first().toString(), "HDMI-1");
}

TEST(SessionWindow, SaysThatAScreenWasUnpluggedAndOffersAPause) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  auto& banner = child<QWidget>(*window, "news");
  ASSERT_TRUE(banner.isVisible());
  const auto buttons = banner.findChildren<QPushButton*>();
  const auto pause = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Pause";
  });
  ASSERT_NE(pause, buttons.end());
  (*pause)->click();
  EXPECT_TRUE(session.requests.pending().pause);
}

TEST(SessionWindow, MovesItselfToAScreenThatIsThere) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  window->move(20000, 20000);
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  EXPECT_TRUE(eventually(
      [&] { return QGuiApplication::screenAt(window->frameGeometry().center()) != nullptr; }));
}

TEST(SessionWindow, ShowsTheMirrorThatItIsGiven) {
  FilledMonitor session{};
  const auto window = session.window();
  auto* mirror = new QLabel("what the participant sees");
  window->set_mirror(mirror);
  EXPECT_TRUE(window->isAncestorOf(mirror));
  EXPECT_TRUE(eventually([&] { return mirror->isVisible(); }));
}

TEST(SessionWindow, FitsTheSmallestScreenWithoutScrollingWhateverIsOpen) {
  FilledMonitor session("chapter_matching", SessionMode::pilot);
  session.answer_up_to(1);
  session.set_phase(SessionPhase::contact);
  session.monitor.update([](SessionSnapshot& s) {
    s.trouble = SessionTrouble{.what = "The disk is nearly full.", .time_ns = s.now_ns};
  });
  const auto window = session.window();
  child<QPushButton>(*window, "skip").click();
  QTest::qWait(1);
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  std::cout << "smallest size: " << window->minimumSizeHint().width() << " × "
            << window->minimumSizeHint().height() << '\n';
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
