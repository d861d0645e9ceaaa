// Increases the stiffness by √2 along each axis until the handle keeps swinging after a small kick.

#include <cmath>
#include <cstddef>
#include <vector>

#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

// Whether the handle keeps swinging on a spring of this stiffness after a small kick. `blocker` receives why the stage
// has no result.
bool swings(DeviceTestRun& run, const Sweeps& sweeps, int axis, double stiffness_N_per_m,
            Phrase& blocker) {
  constexpr double kKick_m = 0.3e-3;
  constexpr double kKicked_s = 0.05;
  constexpr double kEnd_s = 0.45;
  constexpr double kWatched_s = 0.1;
  constexpr double kFar_m = 3e-3;
  DeviceStage stage{.duration_s = kEnd_s, .reach_m = kFar_m};
  Hold hold{};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    glm::dvec3 force_N = hold.force_N(since_s, probe);
    const bool kicked = since_s >= kSettled_s && since_s < kSettled_s + kKicked_s;
    force_N[axis] = stiffness_N_per_m *
                    (hold.origin_m[axis] + (kicked ? kKick_m : 0.0) - probe.position_m[axis]);
    return force_N;
  };
  const StageRecord record = run.move(stage);
  if (record.ran_away) return true;
  blocker = blocker_of(record, stage);
  std::vector<double> watched_m{};
  for (std::size_t i = 0; i < record.ticks.size(); ++i) {
    if (record.time_s[i] < kEnd_s - kWatched_s || record.time_s[i] > kEnd_s) continue;
    watched_m.push_back(record.ticks[i].probe.position_m[axis]);
  }
  return is_swinging(watched_m, sweeps.position_step_m.of(axis, 0.0));
}

}  // namespace

void measure_springs(DeviceTestRun& run, const Sweeps& sweeps) {
  if (run.is_left_out("stiffness_N_per_m")) return;
  constexpr double kSoftest_N_per_m = 250.0;
  constexpr int kLevels = 11;  // in steps of √2, up to 8000 N/m
  ByAxis found{.text = phrase_of(DeviceRemark::stiffest)};
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::springs, "increasingly stiff springs along ", axis,
                 0.63 + 0.04 * axis);
    Phrase blocker{};
    for (int level = 0; level < kLevels && blocker.empty(); ++level) {
      const double stiffness_N_per_m = kSoftest_N_per_m * std::pow(2.0, 0.5 * level);
      if (swings(run, sweeps, axis, stiffness_N_per_m, blocker)) {
        if (level == 0) blocker = phrase_of(DeviceRemark::swings_at_once);
        break;
      }
      if (blocker.empty()) found.set(axis, stiffness_N_per_m);
    }
    if (!found.has(axis)) found.miss(axis, blocker);
  }
  run.judge("stiffness_N_per_m", found);
}

}  // namespace asperity
