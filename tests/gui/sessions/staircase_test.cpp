// A session in the windows whose levels a procedure chooses: the plan grows trial by trial, and no code reveals a level.

#include <algorithm>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "app/gui/session/session_window.h"
#include "app/session/session_monitor.h"
#include "app/tasks/protocol_files.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

using nlohmann::json;

class StaircaseInWindows : public SessionRoom {
 protected:
  /// Two interleaved staircases of three trials each.
  void add_staircases() {
    add_protocol({.kind = "recognition"});
    const std::filesystem::path file = folder() / "protocols" / "small.json";
    json protocol = json::parse(std::ifstream(file));
    protocol["kind"] = "discrimination";
    protocol.erase("factors");
    protocol.erase("textures");
    protocol.erase("analysis");
    protocol["stimuli"] = json::parse(
        R"({"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}})");
    protocol["blocks"] = json::parse(R"({"tracks": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
      "procedure": {"method": "weighted_up_down", "steps": [10], "stop": {"trials": 3},
                    "tracks": [{"start": 50}, {"start": 30}]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "exploration": "short",
      "question": {"name": "rougher", "prompt": "Which surface is rougher?", "judgement": "performance"}}})");
    protocol["flow"] = json::parse(R"([{"run": "tracks"}])");
    write_file(file, protocol.dump(1), Overwrite::allow);
    load_protocol(file, built_in_models(), folder());
  }
};

TEST_F(StaircaseInWindows, PresentsAndStoresTheLevelsThatTheResponsesDetermine) {
  make_study();
  add_staircases();
  open();
  start("small");
  int pages = 0;
  take_part([&](const Scene& scene) {
    ASSERT_EQ(scene.choices.size(), 2U);
    ++pages;
    const std::shared_ptr<const SessionFacts> facts = monitor().facts();
    ASSERT_EQ(facts->plan->trials.size(), static_cast<std::size_t>(pages)) << "as far as known";
    EXPECT_EQ(BlindCodes(*facts->plan, facts->row.seed).of(facts->plan->trials.back()), "A B");
    EXPECT_EQ(monitor().snapshot().trials, 6) << "expected";
    EXPECT_EQ(monitor().snapshot().trials_are_estimated, true);
    if (pages == 4) take_screenshot(experimenter(), "staircase-session", {1280, 720});
    choose(pages % 2 == 0 ? Qt::Key_A : Qt::Key_B);
  });
  EXPECT_EQ(pages, 6);
  const SessionRow session = stored_session();
  EXPECT_EQ(session.state, SessionState::completed);
  EXPECT_EQ(session.expected_trials, 6);
  EXPECT_FALSE(monitor().snapshot().trials_are_estimated);

  const Study study = Study::open(folder(), Access::read_only);
  const std::vector<AttemptRow> attempts = stored_attempts();
  const std::vector<PlannedTrialRow> plan = study.plan(session.id);
  ASSERT_EQ(plan.size(), attempts.size());
  std::map<int, int> next_percent{{1, 50}, {2, 30}};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    int& percent = next_percent.at(plan[i].track.value());
    const double amplitude_m = json::parse(plan[i].factors_json).at("amplitude_m");
    EXPECT_NEAR(amplitude_m, 5e-5 * (1.0 + 0.01 * percent), 1e-12) << "trial " << i + 1;
    EXPECT_TRUE(attempts[i].valid);
    constexpr int kHighest = 100;
    percent += attempts[i].responses.at(0).correct.value() ? -10 : 30;
    percent = std::min(percent, kHighest);
  }
}

}  // namespace
}  // namespace asperity
