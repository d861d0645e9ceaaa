// What the experimenter's window shows and hides while it is blind, and the tracks.

#include <QtCore/QRegularExpression>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/session/live_plots.h"
#include "app/gui/session/plan_table.h"
#include "app/gui/session/track_panel.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/session/session_window_text.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

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

}  // namespace
}  // namespace asperity
