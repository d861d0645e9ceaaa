#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

// Pushes the handle from rest, alternately forward and backward.
void push(DeviceTestRun& run, const Sweeps& sweeps, int axis, ByAxis& latency, ByAxis& mass) {
  if (!sweeps.resistance(axis)) {
    latency.miss(axis, sweeps.blocker(axis));
    mass.miss(axis, sweeps.blocker(axis));
    return;
  }
  constexpr int kPushes = 12;
  constexpr double kRest_s = 0.25;
  constexpr double kPush_s = 0.030;
  constexpr double kPeriod_s = kRest_s + kPush_s;
  constexpr std::size_t kBefore = 20;  // ticks
  const double push_N = std::min(0.8 * run.force_N(), sweeps.friction_N(axis) + 1.0);
  const auto pushed_N = [=](double since_s) {
    const double t = since_s - kSettled_s;
    const double number = std::floor(t / kPeriod_s);
    if (t < 0.0 || number >= kPushes || t - number * kPeriod_s < kRest_s) return 0.0;
    return std::fmod(number, 2.0) == 0.0 ? push_N : -push_N;
  };
  DeviceStage stage{.duration_s = kSettled_s + kPushes * kPeriod_s + 0.1};
  Hold hold{};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    hold.begin(since_s, probe);
    glm::dvec3 force_N = hold.force_N(probe);
    force_N[axis] += pushed_N(since_s);
    return force_N;
  };
  const StageRecord record = run.move(stage);
  const Phrase blocker = blocker_of(record, stage);
  if (!blocker.empty()) {
    latency.miss(axis, blocker);
    mass.miss(axis, blocker);
    return;
  }
  std::vector<Push> pushes{};
  for (std::size_t i = kBefore; i < record.ticks.size(); ++i) {
    const double force_N = pushed_N(record.time_s[i]);
    if (force_N == 0.0 || pushed_N(record.time_s[i - 1]) != 0.0) continue;
    Push one{.direction = std::copysign(1.0, force_N)};
    // The first tick of a push was read before its force.
    for (std::size_t j = i - kBefore + 1; j <= i; ++j) {
      one.rested_at_m += record.ticks[j].probe.position_m[axis] / kBefore;
    }
    for (std::size_t j = i; j < record.ticks.size() && pushed_N(record.time_s[j]) == force_N; ++j) {
      one.time_s.push_back(record.time_s[j] - record.time_s[i]);
      one.position_m.push_back(record.ticks[j].probe.position_m[axis]);
      one.force_N.push_back(record.ticks[j].sent.force_N[axis]);
    }
    pushes.push_back(std::move(one));
  }
  const auto response = push_response(pushes, *sweeps.resistance(axis));
  if (!response) {
    latency.miss(axis, phrase_of(DeviceRemark::push_did_not_move).with(fixed(push_N, 1)));
    mass.miss(axis, latency.reason(axis));
    return;
  }
  latency.set(axis, response->delay_s);
  mass.set(axis, response->mass_kg);
}

}  // namespace

ByAxis measure_pushes(DeviceTestRun& run, const Sweeps& sweeps) {
  ByAxis latency{.text = phrase_of(DeviceRemark::latency)};
  ByAxis mass{.text = phrase_of(DeviceRemark::mass)};
  ByAxis friction{.text = phrase_of(DeviceRemark::friction)};
  ByAxis damping{.text = phrase_of(DeviceRemark::damping)};
  if (!run.has_motors()) {
    run.leave_out(
        {"friction_N", "damping_N_s_per_m", "position_resolution_m", "latency_s", "moving_mass_kg"},
        phrase_of(DeviceRemark::no_motors));
    return mass;
  }
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::pushes, "sudden pushes along ", axis, 0.36 + 0.04 * axis);
    push(run, sweeps, axis, latency, mass);
    if (!sweeps.resistance(axis)) {
      friction.miss(axis, sweeps.blocker(axis));
      damping.miss(axis, sweeps.blocker(axis));
      continue;
    }
    friction.set(axis, sweeps.resistance(axis)->friction_N);
    damping.set(axis,
                std::max(0.0, sweeps.resistance(axis)->damping_N_s_per_m(latency.of(axis, 0.0))));
  }
  run.judge("friction_N", friction);
  run.judge("damping_N_s_per_m", damping);
  run.judge("position_resolution_m", sweeps.position_step_m);
  run.judge("latency_s", latency);
  run.judge("moving_mass_kg", mass);
  return mass;
}

}  // namespace asperity
