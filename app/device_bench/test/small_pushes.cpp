// Pushes along each axis with forces that increase by √2 until the handle moves enough.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

constexpr int kSmallPushes = 6;
constexpr double kSmallPush_s = 0.060;  // and the pause after each
constexpr double kSoftHold_N_per_m = 100.0;

// The mean motion by small pushes in their direction. `blocker` receives why the stage has no result.
std::optional<double> moved_by(DeviceTestRun& run, int axis, double push_N, Phrase& blocker) {
  constexpr double kJudged_s = 0.010;
  const auto pushed_N = [=](double since_s) {
    const double t = (since_s - kSettled_s) / kSmallPush_s;
    const double number = std::floor(t);
    if (t < 0.0 || number >= 2.0 * kSmallPushes || std::fmod(number, 2.0) != 0.0) return 0.0;
    return std::fmod(number, 4.0) == 0.0 ? push_N : -push_N;
  };
  DeviceStage stage{.duration_s = kSettled_s + 2.0 * kSmallPushes * kSmallPush_s};
  Hold hold{.stiffness_N_per_m = kSoftHold_N_per_m};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    glm::dvec3 force_N = hold.force_N(since_s, probe);
    force_N[axis] += pushed_N(since_s);
    return force_N;
  };
  const StageRecord record = run.move(stage);
  blocker = blocker_of(record, stage);
  if (!blocker.empty()) return {};
  ForcedMotion motion{.time_s = record.time_s};
  for (const TickRecord& tick : record.ticks) {
    motion.position_m.push_back(tick.probe.position_m[axis]);
  }
  return mean_motion_m({.first_s = kSettled_s, .length_s = kSmallPush_s, .pushes = kSmallPushes},
                       motion, kJudged_s);
}

}  // namespace

void measure_small_pushes(DeviceTestRun& run, const Sweeps& sweeps, const ByAxis& mass_kg) {
  if (run.is_left_out("force_resolution_N")) return;
  constexpr double kWeakest_N = 0.002;
  constexpr double kMoved = 0.25;  // of the motion without friction: less is creep
  ByAxis found{.text = phrase_of(DeviceRemark::weakest)};
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::small_pushes, "increasingly strong small pushes along ", axis,
                 0.75 + 0.08 * axis);
    Phrase blocker = phrase_of(DeviceRemark::nothing_moves_it).with(fixed(0.8 * run.force_N(), 1));
    for (double push_N = kWeakest_N; push_N <= 0.8 * run.force_N(); push_N *= std::numbers::sqrt2) {
      Phrase stage_blocker{};
      const auto moved_m = moved_by(run, axis, push_N, stage_blocker);
      if (!stage_blocker.empty()) {
        blocker = stage_blocker;
        break;
      }
      const double expected_m = motion_without_friction_m(
          {.force_N = push_N,
           .duration_s = kSmallPush_s,
           .mass_kg = mass_kg.of(axis, 1e-9),
           .stiffness_N_per_m = kSoftHold_N_per_m + sweeps.stiffness_N_per_m(axis)});
      const double noise_m = four_standard_errors_m(sweeps.position_step_m.of(axis, 0.0),
                                                    {.pushes = kSmallPushes, .each = 10});
      if (moved_m && *moved_m > std::max(kMoved * expected_m, noise_m)) {
        found.set(axis, push_N);
        break;
      }
    }
    if (!found.has(axis)) found.miss(axis, blocker);
  }
  run.judge("force_resolution_N", found);
}

}  // namespace asperity
