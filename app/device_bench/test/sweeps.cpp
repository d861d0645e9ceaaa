// Pulls the handle to and fro at constant speeds, and derives friction and stiffness of each axis.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

// To and fro between ±8 mm at a constant speed, from the middle to one end, `legs` times to the other, and back to the middle.
// Between legs the motion turns beyond the end, with an acceleration of the shape sin²: a step of the speed would make a heavy
// handle swing on the spring that pulls it.
class SweepPath final {
 public:
  SweepPath(double speed_m_per_s, int legs)
      : speed_m_per_s_(speed_m_per_s),
        legs_(legs),
        quarter_s_(kAmplitude_m / speed_m_per_s),
        leg_s_(2.0 * quarter_s_) {}

  double duration_s() const noexcept {
    return 2.0 * quarter_s_ + legs_ * (kTurn_s + leg_s_) + kTurn_s;
  }
  double position_m(double t_s) const noexcept {
    if (t_s <= 0.0 || t_s >= duration_s()) return 0.0;
    if (t_s <= quarter_s_) return speed_m_per_s_ * t_s;
    const double number = std::floor((t_s - quarter_s_) / (kTurn_s + leg_s_));
    const double sign = std::fmod(number, 2.0) == 0.0 ? 1.0 : -1.0;  // of the end that it leaves
    const double in_part_s = t_s - quarter_s_ - number * (kTurn_s + leg_s_);
    if (in_part_s >= kTurn_s) {
      return sign * (kAmplitude_m - speed_m_per_s_ * (in_part_s - kTurn_s));
    }
    // The speed is v·(1 − 2u + sin(2πu)/π) at the part u of the turn.
    const double u = in_part_s / kTurn_s;
    const double beyond_s = kTurn_s * (u - u * u +
                                       (1.0 - std::cos(2.0 * std::numbers::pi * u)) /
                                           (2.0 * std::numbers::pi * std::numbers::pi));
    return sign * (kAmplitude_m + speed_m_per_s_ * beyond_s);
  }
  // The leg and the fraction of it, from 0 to 1; nothing in a turn and outside the legs.
  std::optional<std::pair<std::size_t, double>> leg_at(double t_s) const noexcept {
    const double number = std::floor((t_s - quarter_s_) / (kTurn_s + leg_s_));
    if (number < 0.0 || number >= legs_) return {};
    const double in_leg_s = t_s - quarter_s_ - number * (kTurn_s + leg_s_) - kTurn_s;
    if (in_leg_s < 0.0) return {};
    return std::pair(static_cast<std::size_t>(number), in_leg_s / leg_s_);
  }

 private:
  static constexpr double kAmplitude_m = 0.008;
  static constexpr double kTurn_s = 0.2;
  double speed_m_per_s_ = 0.0;
  int legs_ = 0;
  double quarter_s_ = 0.0;
  double leg_s_ = 0.0;
};

// The legs of a sweep at one speed; `blocker` receives why there are none.
std::vector<ForcedMotion> sweep(DeviceTestRun& run, int axis, double damping_N_s_per_m,
                                double speed_m_per_s, int rounds, Phrase& blocker) {
  constexpr double kPull_N_per_m = 400.0;
  const SweepPath path(speed_m_per_s, 2 * rounds);
  const double duration_s = kSettled_s + path.duration_s();
  DeviceStage stage{.duration_s = duration_s};
  Hold hold{.damping_N_s_per_m = damping_N_s_per_m};
  stage.force_N = [=](double since_s, const ProbeState& probe) mutable {
    glm::dvec3 force_N = hold.force_N(since_s, probe);
    force_N[axis] = kPull_N_per_m * (hold.origin_m[axis] + path.position_m(since_s - kSettled_s) -
                                     probe.position_m[axis]) -
                    hold.damping_N_s_per_m * probe.velocity_m_per_s[axis];
    return force_N;
  };
  const StageRecord record = run.move(stage);
  blocker = blocker_of(record, stage);
  std::vector<ForcedMotion> legs(static_cast<std::size_t>(2 * rounds));
  std::size_t limited = 0;
  std::size_t used = 0;
  for (std::size_t i = 0; i < record.ticks.size(); ++i) {
    const auto at = path.leg_at(record.time_s[i] - kSettled_s);
    if (!at) continue;
    const auto [leg, part] = *at;
    // Not the first half of a leg, in which the pull overcomes friction.
    constexpr double kFrom = 0.5;
    constexpr double kTo = 0.97;
    if (part < kFrom || part > kTo) continue;
    const TickRecord& tick = record.ticks[i];
    ForcedMotion& to = legs[leg];
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

// The sweeps along one axis with one damping of the pull.
struct AxisSweeps {
  Phrase blocker{};
  std::optional<Resistance> resistance{};
  std::vector<ForcedMotion> slow{};
  double unevenness_m = 0.0;
};

AxisSweeps swept(DeviceTestRun& run, int axis, double damping_N_s_per_m) {
  constexpr double kSlow_m_per_s = 0.010;
  constexpr double kFast_m_per_s = 0.040;
  constexpr double kMoved_m_per_s = 0.0005;  // a slower handle sticks
  AxisSweeps found{};
  found.slow = sweep(run, axis, damping_N_s_per_m, kSlow_m_per_s, 1, found.blocker);
  const auto slowly = sweep_response(found.slow);
  if (found.blocker.empty() && (!slowly || slowly->speed_m_per_s < kMoved_m_per_s)) {
    found.blocker = phrase_of(DeviceRemark::did_not_move);
  }
  if (!found.blocker.empty()) return found;
  const std::vector<ForcedMotion> fast =
      sweep(run, axis, damping_N_s_per_m, kFast_m_per_s, 3, found.blocker);
  if (!found.blocker.empty()) return found;
  if (const auto faster = sweep_response(fast)) {
    found.resistance = resistance_of(*slowly, *faster);
    if (found.resistance) found.resistance->held_s = 1.0 / run.options().rate_Hz;
    found.unevenness_m =
        std::max(unevenness_m(found.slow).value_or(0.0), unevenness_m(fast).value_or(0.0));
  }
  if (!found.resistance) found.blocker = phrase_of(DeviceRemark::sweeps_say_nothing);
  return found;
}

// A heavy handle with little damping still swings on the pulling spring when a leg is judged, and its inertia would be taken
// for resistance: 700 N/m (with a hand's 300) · 5 µm are 3.5 mN, 0.12 N s/m between the two speeds. Only a handle that swings
// is pulled with more damping: one on 1.5 N s/m that swings for 0.1 s has at least 0.05 kg, which render 12 N s/m with a
// velocity that is up to 5 ms old (steepest_damper_N_s_per_m).
AxisSweeps evenly_swept(DeviceTestRun& run, int axis) {
  constexpr double kEven_m = 5e-6;
  constexpr double kUneven_m = 200e-6;
  constexpr std::array kDampings_N_s_per_m{Hold{}.damping_N_s_per_m, 6.0, 12.0};
  std::optional<AxisSweeps> best{};
  for (const double damping_N_s_per_m : kDampings_N_s_per_m) {
    AxisSweeps found = swept(run, axis, damping_N_s_per_m);
    const bool is_better =
        !best || (found.blocker.empty() && found.unevenness_m < best->unevenness_m);
    if (!is_better) break;
    best = std::move(found);
    if (!best->blocker.empty()) break;
    // The steps and the noise of the sensor are not a motion; they are known to within a fifth.
    const double error_m = 1.2 * position_error_m(best->slow).value_or(0.0);
    if (best->unevenness_m <= std::hypot(kEven_m, error_m)) break;
  }
  if (best->blocker.empty() && best->unevenness_m > kUneven_m) {
    best->blocker = phrase_of(DeviceRemark::swings_in_sweeps)
                        .with(fixed(1e3 * std::numbers::sqrt2 * best->unevenness_m, 1));
  }
  return *std::move(best);
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
  for (int axis = 0; axis < kTestedAxes; ++axis) {
    run.announce(DeviceTestPart::sweeps, "slow and fast sweeps along ", axis, 0.1 + 0.08 * axis);
    const AxisSweeps found = evenly_swept(run, axis);
    const auto i = static_cast<std::size_t>(axis);
    sweeps.blockers[i] = found.blocker;
    if (!found.blocker.empty()) {
      sweeps.position_step_m.miss(axis, found.blocker);
      continue;
    }
    sweeps.resistances[i] = found.resistance;
    if (const auto error_m = position_error_m(found.slow)) {
      sweeps.position_step_m.set(axis, step_of_rounding_m(*error_m));
    }
  }
  return sweeps;
}

}  // namespace asperity
