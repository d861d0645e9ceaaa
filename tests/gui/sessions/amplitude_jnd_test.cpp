// A shortened session of the library's protocol `amplitude_jnd` in the windows: practice with feedback, two tracks, a catch trial.

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <nlohmann/json.hpp>

#include "app/gui/base/study_table.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/session_window.h"
#include "app/session/session_monitor.h"
#include "app/tasks/protocol_files.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

using nlohmann::json;

/// Trials of each of the two tracks.
constexpr int kTrialsOfATrack = 2;
constexpr int kPracticeTrials = 2;

class AmplitudeJndInWindows : public SessionRoom {
 protected:
  /// Under the name "small", with short visits and breaks.
  void add_amplitude_jnd() {
    add_protocol({.kind = "recognition"});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    for (const LibraryProtocol& each : library_protocols()) {
      if (each.name != "amplitude_jnd") continue;
      json protocol = json::parse(each.text);
      protocol["name"] = "small";
      protocol["participants"]["questions"] = json::array();
      protocol["environment"].erase("masking_noise");
      // Real time on a busy machine.
      protocol["device"]["maximum_missed_deadlines"] = 100000;
      protocol["device"]["maximum_gaps_in_contact"] = 100000;
      protocol["device"]["maximum_lost_records"] = 100000;
      protocol["explorations"]["stroking"]["minimum_contact_s"] = 0.3;
      protocol["explorations"]["stroking"]["speed_m_per_s"]["target"] = 0.09;
      json& practice = protocol["blocks"]["practice"];
      practice["repetitions"] = kPracticeTrials / 2;  // of two levels
      practice.erase("until");
      json& main = protocol["blocks"]["comparisons"];
      main["procedure"]["stop"]["trials"] = kTrialsOfATrack;
      main["procedure"]["catch_trials"]["every"] = 3;
      for (json* const block : {&practice, &main}) {
        (*block)["pause_before_trial_s"] = 0;
        (*block)["arrangement"]["interval_s"] = {{"shortest", 0.1}, {"longest", 0.2}};
        (*block)["arrangement"]["exposure"]["strokes"] = 2;
      }
      for (json& step : protocol["flow"]) {
        if (step.contains("break")) step["break"]["minimum_s"] = 1;
        if (step.contains("pause")) step["pause"]["minimum_s"] = 1;
        if (step.contains("break_every_trials")) step["break_every_trials"] = 3;
      }
      write_file(file, protocol.dump(1), Overwrite::allow);
    }
    load_protocol(file, built_in_models(), folder());
  }

  /// Light and dark, once under each name.
  void take_pictures(QWidget& widget, const std::string& name) {
    if (qEnvironmentVariable("ASPERITY_SCREENSHOTS").isEmpty()) return;
    if (!taken_.insert(name).second) return;
    const QString file = QString::fromStdString("amplitude-jnd-" + name);
    take_screenshot(widget, file, {1280, 720});
    apply_theme(*qApp, ThemeChoice::dark);
    take_screenshot(widget, file + "-dark", {1280, 720});
    apply_theme(*qApp, ThemeChoice::light);
  }

  /// Of what is shown now.
  void take_pictures_of(const Scene& scene) {
    const std::map<Scene::Kind, std::string> names{
        {Scene::Kind::text, "text"},         {Scene::Kind::feel, "feel"},
        {Scene::Kind::question, "question"}, {Scene::Kind::feedback, "feedback"},
        {Scene::Kind::rest, "rest"},         {Scene::Kind::form, "form"},
        {Scene::Kind::blank, "blank"}};
    const auto name = names.find(scene.kind);
    if (name == names.end() || desk->participant_window() == nullptr) return;
    std::string of = name->second;
    for (const Scene::Surface& surface : scene.surfaces) {
      if (scene.kind == Scene::Kind::feel && surface.now) of += '-' + surface.code;
    }
    take_pictures(*desk->participant_window(), of);
    take_pictures(experimenter(), "session-" + of);
  }

 private:
  std::set<std::string> taken_{};
};

TEST_F(AmplitudeJndInWindows, PresentsPracticeTracksAndCatchTrials) {
  make_study();
  add_amplitude_jnd();
  open();
  window->show_page("protocols");
  click_row(*window, "protocols_table", "small");
  ASSERT_TRUE(until([&] { return !find<QLabel>(*window, "protocol_facts").text().isEmpty(); }));
  // The number of catch trials is drawn.
  EXPECT_TRUE(find<QLabel>(*window, "protocol_facts").text().contains("about 7 trials"))
      << find<QLabel>(*window, "protocol_facts").text().toStdString();
  start("small");
  int answers = 0;
  std::set<int> trials_with_feedback{};
  std::set<std::string> codes{};
  take_part(
      [&](const Scene& scene) {
        ASSERT_EQ(scene.choices.size(), 2U);
        ++answers;
        const std::shared_ptr<const SessionFacts> facts = monitor().facts();
        const Trial& asked = facts->plan->trials.at(static_cast<std::size_t>(answers - 1));
        if (asked.phase == Phase::main) {
          codes.insert(BlindCodes(*facts->plan, facts->row.seed).of(asked));
        }
        take_pictures_of(scene);
        choose(answers % 2 == 0 ? Qt::Key_A : Qt::Key_B);
      },
      [&] {
        if (!desk->is_running()) return true;
        if (desk->participant_window() == nullptr) return false;
        const Scene scene = view().scene();
        const SessionSnapshot now = monitor().snapshot();
        if (now.phase == SessionPhase::feedback) trials_with_feedback.insert(answers);
        if (scene.kind != Scene::Kind::question) take_pictures_of(scene);
        return false;
      });
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_EQ(trials_with_feedback, (std::set<int>{1, kPracticeTrials})) << "of the practice";
  EXPECT_EQ(codes, std::set<std::string>{"A B"}) << "no code shows a level or a catch trial";

  const Study study = Study::open(folder(), Access::read_only);
  const std::vector<PlannedTrialRow> plan = study.plan(stored_session().id);
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(plan.size(), attempts.size());
  EXPECT_EQ(answers, static_cast<int>(attempts.size()));
  int catch_trials = 0;
  std::map<int, int> of_track{};
  std::map<int, int> next_percent{{1, 50}, {2, 34}};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    SCOPED_TRACE("trial " + std::to_string(i + 1));
    EXPECT_TRUE(attempts[i].valid);
    ASSERT_EQ(attempts[i].presentations.size(), 2U);
    const double amplitude_m = json::parse(plan[i].factors_json).at("amplitude_m");
    const auto expect_percent = [amplitude_m](int percent) {
      EXPECT_NEAR(amplitude_m, 5e-5 * (1.0 + 0.01 * percent), 1e-12);
    };
    for (const PresentationRow& surface : attempts[i].presentations) {
      EXPECT_GE(surface.contact_s, 0.3);
      if (surface.role != "comparison") continue;
      EXPECT_EQ(json::parse(surface.parameters_json).at("amplitude_m"), amplitude_m);
    }
    if (plan[i].phase == "practice") continue;
    if (plan[i].is_catch) {
      ++catch_trials;
      EXPECT_FALSE(plan[i].track);
      expect_percent(150);
      continue;
    }
    const int track = plan[i].track.value();
    ++of_track[track];
    expect_percent(next_percent.at(track));
    if (!attempts[i].responses.at(0).correct.value()) next_percent.at(track) += 16;
  }
  EXPECT_GE(catch_trials, 1);
  EXPECT_EQ(of_track, (std::map<int, int>{{1, kTrialsOfATrack}, {2, kTrialsOfATrack}}));
  take_pictures(experimenter(), "end");
  click(experimenter(), "see_trials");
  auto& trials = find<StudyTable>(*window, "trials_table");
  ASSERT_TRUE(until([&] { return trials.shown_rows() == answers; }));
  EXPECT_TRUE(trials.text_at(0, 3).startsWith("amplitude ")) << trials.text_at(0, 3).toStdString();
  EXPECT_TRUE(trials.text_at(0, 3).endsWith(" µm")) << trials.text_at(0, 3).toStdString();
  constexpr int kTrackColumn = 10;
  EXPECT_FALSE(trials.isColumnHidden(kTrackColumn));
  int first_steps = 0;  // the first trial of the tracks may be a catch trial, without a track
  for (int row = 0; row < trials.shown_rows(); ++row) {
    if (trials.text_at(row, kTrackColumn).endsWith(", step 1")) ++first_steps;
  }
  EXPECT_GT(first_steps, 0);
  take_pictures(*window, "trials");
  int unflagged = 0;
  for (int row = 0; row < trials.shown_rows(); ++row) {
    // Next to other work a trial may miss deadlines; this remark takes a second line.
    const QString remark = trials.text_at(row, kTrackColumn + 1);
    if (remark.contains("flagged") || remark.contains("not valid")) continue;
    ++unflagged;
    EXPECT_LT(trials.rowHeight(row), 2 * QFontMetrics(trials.font()).height())
        << "one line in every row";
  }
  EXPECT_GT(unflagged, 0);
}

}  // namespace
}  // namespace asperity
