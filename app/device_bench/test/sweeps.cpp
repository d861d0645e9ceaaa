#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

// The legs of a sweep at one speed along a triangle wave; `blocker` receives why there are none.
std::vector<ForcedMotion> sweep(DeviceTestRun& run, int axis, double speed_m_per_s, int rounds,
                                Phrase& blocker) {
  constexpr double kAmplitude_m = 0.008;
  constexpr double kPull_N_per_m = 400.0;
  const double quarter_s = kAmplitude_m / speed_m_per_s;
  // From the middle to one end, to and fro, and back to the middle.
  const double duration_s = kSettled_s + (4.0 * rounds + 2.0) * quarter_s;
  const auto target_m = [=](double since_s) {
    const double t = (since_s - kSettled_s) / quarter_s;
    if (t <= 0.0 || t >= 4.0 * rounds + 2.0) return 0.0;
    if (t <= 1.0) return kAmplitude_m * t;
    if (t >= 4.0 * rounds + 1.0) return kAmplitude_m * (4.0 * rounds + 2.0 - t);
    const double in_round = std::fmod(t - 1.0, 4.0);
    return kAmplitude_m * (in_round < 2.0 ? 1.0 - in_round : in_round - 3.0);
  };
  DeviceStage stage{.duration_s = duration_s};
  Hold hold{};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    hold.begin(since_s, probe);
    glm::dvec3 force_N = hold.force_N(probe);
    force_N[axis] =
        kPull_N_per_m * (hold.origin_m[axis] + target_m(since_s) - probe.position_m[axis]) -
        hold.damping_N_s_per_m * probe.velocity_m_per_s[axis];
    return force_N;
  };
  const StageRecord record = run.move(stage);
  blocker = blocker_of(record, stage);
  std::vector<ForcedMotion> legs(static_cast<std::size_t>(2 * rounds));
  std::size_t limited = 0;
  std::size_t used = 0;
  for (std::size_t i = 0; i < record.ticks.size(); ++i) {
    const double in_legs = ((record.time_s[i] - kSettled_s) / quarter_s - 1.0) / 2.0;
    if (in_legs < 0.0 || in_legs >= 2.0 * rounds) continue;
    const double leg = std::floor(in_legs);
    // Not the first half of a leg, in which the motion reverses and the pull overcomes friction.
    constexpr double kFrom = 0.5;
    constexpr double kTo = 0.97;
    if (in_legs - leg < kFrom || in_legs - leg > kTo) continue;
    const TickRecord& tick = record.ticks[i];
    ForcedMotion& to = legs[static_cast<std::size_t>(leg)];
    to.time_s.push_back(record.time_s[i]);
    to.position_m.push_back(tick.probe.position_m[axis]);
    to.force_N.push_back(tick.sent.force_N[axis]);
    limited += tick.has(TickFlag::limited_force) ? 1 : 0;
    ++used;
  }
  if (blocker.empty() && 20 * limited > used) {
    blocker = phrase_of(DeviceRemark::did_not_follow).with(fixed(run.force_N(), 1));
  }
  return legs;
}

}  // namespace

double Sweeps::friction_N(int axis) const {
  return resistance(axis) ? resistance(axis)->friction_N : 0.0;
}

double Sweeps::stiffness_N_per_m(int axis) const {
  return resistance(axis) ? std::max(0.0, resistance(axis)->stiffness_N_per_m) : 0.0;
}

Sweeps measure_sweeps(DeviceTestRun& run) {
  Sweeps sweeps{.position_step_m = {.text = phrase_of(DeviceRemark::position_step)}};
  if (!run.has_motors()) return sweeps;
  constexpr double kSlow_m_per_s = 0.010;
  constexpr double kFast_m_per_s = 0.040;
  constexpr double kMoved_m_per_s = 0.0005;  // a slower handle sticks
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::sweeps, "slow and faster sweeps along ", axis, 0.1 + 0.08 * axis);
    Phrase blocker{};
    const std::vector<ForcedMotion> slow = sweep(run, axis, kSlow_m_per_s, 1, blocker);
    const auto slowly = sweep_response(slow);
    if (blocker.empty() && (!slowly || slowly->speed_m_per_s < kMoved_m_per_s)) {
      blocker = phrase_of(DeviceRemark::did_not_move);
    }
    if (blocker.empty()) {
      const auto faster = sweep_response(sweep(run, axis, kFast_m_per_s, 3, blocker));
      if (blocker.empty() && faster) {
        sweeps.resistances[static_cast<std::size_t>(axis)] = resistance_of(*slowly, *faster);
      }
    }
    if (blocker.empty() && !sweeps.resistance(axis))
      blocker = phrase_of(DeviceRemark::sweeps_say_nothing);
    sweeps.blockers[static_cast<std::size_t>(axis)] = blocker;
    if (!blocker.empty()) {
      sweeps.resistances[static_cast<std::size_t>(axis)].reset();
      sweeps.position_step_m.miss(axis, blocker);
      continue;
    }
    if (const auto error_m = position_error_m(slow)) {
      sweeps.position_step_m.set(axis, step_of_rounding_m(*error_m));
    }
  }
  return sweeps;
}

}  // namespace asperity
