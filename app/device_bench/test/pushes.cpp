// Measures latency and mass from the start of twelve pushes along each axis.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

// A push is one from rest if the handle was slower than this fraction of its final speed v: the motion from before, 0.01·v·t,
// is 2 % of that of the push, ½·v·t.
constexpr double kAtRest = 0.01;

// A speed is the difference of the means of so many ticks.
constexpr std::size_t kSpeedTicks = 20;

// Twelve pushes along one axis, alternately forward and backward.
struct PushSeries {
  Phrase blocker{};
  std::vector<Push> pushes{};
  double before_m_per_s = 0.0;  // RMS of the speeds from which the pushes began
  double end_m_per_s = 0.0;     // the mean speed at the end of a push
};

// What brings the handle to rest between pushes.
struct Rest {
  double duration_s = 0.25;
  double damping_N_s_per_m = Hold{}.damping_N_s_per_m;
};

PushSeries pushed(DeviceTestRun& run, int axis, double push_N, const Rest& rest) {
  constexpr int kPushes = 12;
  constexpr double kPush_s = 0.030;
  constexpr std::size_t kBefore = 20;  // ticks of which the mean is the position at rest
  const double period_s = rest.duration_s + kPush_s;
  const auto pushed_N = [=](double since_s) {
    const double t = since_s - kSettled_s;
    const double number = std::floor(t / period_s);
    if (t < 0.0 || number >= kPushes || t - number * period_s < rest.duration_s) return 0.0;
    return std::fmod(number, 2.0) == 0.0 ? push_N : -push_N;
  };
  DeviceStage stage{.duration_s = kSettled_s + kPushes * period_s + 0.1};
  Hold hold{.damping_N_s_per_m = rest.damping_N_s_per_m};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    glm::dvec3 force_N = hold.force_N(since_s, probe);
    force_N[axis] += pushed_N(since_s);
    return force_N;
  };
  const StageRecord record = run.move(stage);
  PushSeries series{.blocker = blocker_of(record, stage)};
  if (!series.blocker.empty()) return series;
  const auto mean_m = [&](std::size_t begin, std::size_t end) {
    double sum_m = 0.0;
    for (std::size_t j = begin; j < end; ++j) sum_m += record.ticks[j].probe.position_m[axis];
    return sum_m / static_cast<double>(end - begin);
  };
  // Between the means of the two halves of so many ticks.
  const auto speed_m_per_s = [&](std::size_t begin, std::size_t end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const double apart_s = record.time_s[middle] - record.time_s[begin];
    return apart_s > 0.0 ? (mean_m(middle, end) - mean_m(begin, middle)) / apart_s : 0.0;
  };
  double squares_m2_per_s2 = 0.0;
  double ends_m_per_s = 0.0;
  for (std::size_t i = kBefore; i < record.ticks.size(); ++i) {
    const double force_N = pushed_N(record.time_s[i]);
    if (force_N == 0.0 || pushed_N(record.time_s[i - 1]) != 0.0) continue;
    // The first tick of a push was read before its force.
    const std::size_t begin = i - kBefore + 1;
    Push one{.direction = std::copysign(1.0, force_N), .rested_at_m = mean_m(begin, i + 1)};
    squares_m2_per_s2 +=
        std::pow(speed_m_per_s(i + 1 - std::min(i + 1, 2 * kSpeedTicks), i + 1), 2);
    std::size_t j = i;
    for (; j < record.ticks.size() && pushed_N(record.time_s[j]) == force_N; ++j) {
      one.time_s.push_back(record.time_s[j] - record.time_s[i]);
      one.position_m.push_back(record.ticks[j].probe.position_m[axis]);
      one.force_N.push_back(record.ticks[j].sent.force_N[axis]);
    }
    ends_m_per_s += one.direction * speed_m_per_s(std::max(i, j - std::min(j, kSpeedTicks / 2)), j);
    series.pushes.push_back(std::move(one));
  }
  if (!series.pushes.empty()) {
    const auto count = static_cast<double>(series.pushes.size());
    series.before_m_per_s = std::sqrt(squares_m2_per_s2 / count);
    series.end_m_per_s = ends_m_per_s / count;
  }
  return series;
}

// Pushes the handle from rest. One with little damping rests longer between pushes.
void push(DeviceTestRun& run, const Sweeps& sweeps, int axis, ByAxis& latency, ByAxis& mass) {
  const auto miss = [&](const Phrase& reason) {
    latency.miss(axis, reason);
    mass.miss(axis, reason);
  };
  if (!sweeps.resistance(axis)) return miss(sweeps.blocker(axis));
  // As for the sweeps: more damping only for a handle that swings.
  constexpr std::array kRests{Rest{}, Rest{0.5, 6.0}, Rest{1.0, 12.0}};
  const double push_N = std::min(0.8 * run.force_N(), sweeps.friction_N(axis) + 1.0);
  // Errors by rounding are not a motion.
  const double rounding_m_per_s = 3.0 * std::sqrt(2.0 / kSpeedTicks) *
                                  rounding_error_m(sweeps.position_step_m.of(axis, 0.0)) *
                                  run.options().rate_Hz / kSpeedTicks;
  PushSeries series{};
  bool is_from_rest = false;
  for (const Rest& rest : kRests) {
    series = pushed(run, axis, push_N, rest);
    if (!series.blocker.empty()) return miss(series.blocker);
    is_from_rest =
        series.before_m_per_s <= std::max(kAtRest * series.end_m_per_s, rounding_m_per_s);
    if (is_from_rest) break;
  }
  const auto response = push_response(series.pushes, *sweeps.resistance(axis));
  if (!response) {
    return miss(phrase_of(DeviceRemark::push_did_not_move).with(fixed(push_N, 1)));
  }
  if (!is_from_rest) {
    return miss(
        phrase_of(DeviceRemark::swings_before_pushes).with(fixed(kRests.back().duration_s, 1)));
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
