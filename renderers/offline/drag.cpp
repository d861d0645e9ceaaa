// Implements the search for the height, the simulation with decreasing time steps, and the comparison of their
// measures.

#include "renderers/offline/drag.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "device/refusal.h"
#include "renderers/offline/constant_height.h"
#include "renderers/servo/contact.h"

namespace asperity {
namespace {

constexpr double kLongestStep_s = 50e-6;
constexpr int kStepHalvings = 5;
constexpr double kForgotten = 8.0;  // e⁻⁸ of the initial transient remains
constexpr double kShortestRecord_s = 0.5;
constexpr std::size_t kFewestSpacings = 16;
constexpr std::size_t kFewestOnShortPlate = 4;
constexpr std::size_t kDragSamplesPerSpacing = 256;
constexpr double kAccelerationTolerance = 0.01;
constexpr double kPowerTolerance = 0.02;
constexpr double kPowerFloor = 1e-4;
constexpr double kRounding_m_per_s2 = 1e-6;  // rounding errors, far below the detection threshold
constexpr double kCaught = 0.05;
constexpr double kDeeper_m = 10e-6;
constexpr double kYielding = 0.1;
constexpr std::size_t kBetweenStops = 4096;
constexpr std::size_t kFewestPeriods = 4;
constexpr double kFast = 0.5;  // of the greatest speed: where a tool to and fro can be caught

// The length of the record, in spacings (to and fro: in periods) and in time.
struct Length {
  std::size_t spacings = 0;
  double spacing_s = 0.0;
  double dropped_s = 0.0;
};

Length length_of(const Drag& stroke) {
  const bool is_to_and_fro = stroke.swing_m > 0.0;
  Length length{.spacing_s =
                    (is_to_and_fro ? 2.0 * std::numbers::pi * stroke.swing_m : stroke.spacing_m) /
                    stroke.speed_m_per_s};
  length.dropped_s = beginning_s(stroke.hand, stroke.mode == DragMode::constant_force
                                                  ? std::optional<double>(stroke.stiffness_N_per_m)
                                                  : std::nullopt);
  length.spacings = std::bit_ceil(
      std::max(is_to_and_fro ? kFewestPeriods : kFewestSpacings,
               static_cast<std::size_t>(std::ceil(kShortestRecord_s / length.spacing_s))));
  if (stroke.reach_m > 0.0) {
    const auto takes_m = [&] {
      return stroke.speed_m_per_s *
             (length.dropped_s + static_cast<double>(length.spacings) * length.spacing_s);
    };
    while (takes_m() > stroke.reach_m && length.spacings > kFewestOnShortPlate)
      length.spacings /= 2;
    if (takes_m() > stroke.reach_m) {
      throw std::invalid_argument("Drag::reach_m is " + number_text(stroke.reach_m) +
                                  " m; it must be at least the length of the stroke, " +
                                  number_text(takes_m()) + " m");
    }
  }
  return length;
}

// The probe at a place of the guide and a height above it.
ProbeState probe_on(const StrokeGuide& guide, const glm::dvec2& place_m,
                    const glm::dvec2& velocity_m_per_s, std::int64_t time_ns) noexcept {
  const GuidePlace at = guide.at(place_m.x);
  ProbeState probe{};
  probe.time_ns = time_ns;
  probe.position_m = at.origin_m + place_m.y * at.normal;
  probe.velocity_m_per_s = velocity_m_per_s.x * at.along + velocity_m_per_s.y * at.normal;
  probe.orientation = at.orientation;
  probe.angular_velocity_rad_per_s.z = velocity_m_per_s.x * guide.turn_rad_per_m();
  return probe;
}

// Normal forces along the texture at a constant height, without yielding.
class StillHeight {
 public:
  StillHeight(ForceRenderer& renderer, const Drag& stroke, const StrokeGuide& guide)
      : renderer_(renderer), guide_(guide), stroke_(stroke) {
    start_m_ = stroke.swing_m > 0.0 ? -stroke.swing_m : stroke.start_x_m;
    const double length_m = stroke.swing_m > 0.0 ? 2.0 * stroke.swing_m : stroke.repeats_after_m;
    const double spacings = std::max(1.0, std::round(length_m / stroke.spacing_m));
    samples_ = static_cast<std::size_t>(spacings) * kDragSamplesPerSpacing;
    pitch_m_ = length_m / static_cast<double>(samples_);
  }

  const std::vector<double>& normal_N(double height_m) {
    normal_N_.resize(samples_);
    const double dt_s = pitch_m_ / stroke_.speed_m_per_s;
    for (std::size_t i = 0; i < samples_; ++i) {
      const double place_m = start_m_ + static_cast<double>(i) * pitch_m_;
      const ProbeState probe = probe_on(guide_, {place_m, height_m}, {stroke_.speed_m_per_s, 0.0},
                                        std::llround(static_cast<double>(i) * dt_s * 1e9));
      if (i == 0) renderer_.reset(probe);
      normal_N_[i] =
          glm::dot(renderer_.tick(probe, dt_s).wrench.force_N, guide_.at(place_m).normal);
    }
    return normal_N_;
  }

  double mean_normal_N(double height_m) {
    double sum_N = 0.0;
    for (const double one_N : normal_N(height_m)) sum_N += one_N;
    return sum_N / static_cast<double>(samples_);
  }

  bool yields_at(double height_m) {
    const std::vector<double> here_N = normal_N(height_m);
    const std::vector<double>& deeper_N = normal_N(height_m - kDeeper_m);
    for (std::size_t i = 0; i < samples_; ++i) {
      if (here_N[i] > 0.0 &&
          deeper_N[i] - here_N[i] < kYielding * kDeeper_m * stroke_.stiffness_N_per_m) {
        return true;
      }
    }
    return false;
  }

 private:
  ForceRenderer& renderer_;
  const StrokeGuide& guide_;
  const Drag& stroke_;
  double start_m_ = 0.0;
  std::size_t samples_ = 0;
  double pitch_m_ = 0.0;
  std::vector<double> normal_N_{};
};

// The result of a simulation with one time step.
struct Run {
  HeldToolRoughness roughness{};
  std::optional<TurningRoughness> turning{};
  double slowest_m_per_s = 0.0;
  double lowest_m = 0.0;
  double share_without_contact = 0.0;
};

struct Steps {
  std::size_t in_a_spacing = 0;
  double height_m = 0.0;
};

// The motion of the tool without a surface, less that of the hand of HeldTool: to and fro, HeldTool integrates the deviation.
class FreeMotion {
 public:
  explicit FreeMotion(const Drag& stroke) noexcept
      : swing_m_(stroke.swing_m),
        rate_rad_per_s_(swing_m_ > 0.0 ? stroke.speed_m_per_s / swing_m_ : 0.0) {}

  double place_m(double time_s) const noexcept {
    return swing_m_ * std::sin(rate_rad_per_s_ * time_s);
  }
  double speed_m_per_s(double time_s) const noexcept {
    return swing_m_ * rate_rad_per_s_ * std::cos(rate_rad_per_s_ * time_s);
  }

 private:
  double swing_m_ = 0.0;
  double rate_rad_per_s_ = 0.0;
};

// Records of the torque and of the components of the force.
class TurningRecord {
 public:
  void add(double torque_N_m, const glm::dvec3& force_N) {
    torque_N_m_.push_back(torque_N_m);
    for (int axis = 0; axis < 3; ++axis) {
      force_N_[static_cast<std::size_t>(axis)].push_back(force_N[axis]);
    }
  }

  TurningRoughness roughness(double rate_Hz) const {
    const RecordRoughness torque = record_roughness(torque_N_m_, rate_Hz);
    TurningRoughness sum{.rms_torque_N_m = torque.rms,
                         .fa1_torque_N2_m2 = torque.fa1_power,
                         .fa2_torque_N2_m2 = torque.fa2_power};
    double square_N2 = 0.0;
    for (const std::vector<double>& component_N : force_N_) {
      const RecordRoughness force = record_roughness(component_N, rate_Hz);
      square_N2 += force.rms * force.rms;
      sum.fa1_force_N2 += force.fa1_power;
      sum.fa2_force_N2 += force.fa2_power;
    }
    sum.rms_force_N = std::sqrt(square_N2);
    return sum;
  }

 private:
  std::vector<double> torque_N_m_{};
  std::array<std::vector<double>, 3> force_N_{};
};

// The forces along the guide and along its normal.
glm::dvec2 forces_on(const StrokeGuide& guide, const GuidePlace& at,
                     const Wrench& wrench) noexcept {
  return {glm::dot(wrench.force_N, at.along) + wrench.torque_N_m.z * guide.turn_rad_per_m(),
          glm::dot(wrench.force_N, at.normal)};
}

std::optional<Run> simulated(ForceRenderer& renderer, const Drag& stroke, const StrokeGuide& guide,
                             const Length& length, const Steps& steps,
                             const std::stop_token& stop) {
  const double dt_s = length.spacing_s / static_cast<double>(steps.in_a_spacing);
  const auto dropped = static_cast<std::size_t>(std::ceil(length.dropped_s / dt_s));
  const std::size_t kept = length.spacings * steps.in_a_spacing;
  const bool is_to_and_fro = stroke.swing_m > 0.0;
  const FreeMotion free(stroke);
  HeldTool tool(stroke.hand, {.speed_m_per_s = is_to_and_fro ? 0.0 : stroke.speed_m_per_s,
                              .press_N = stroke.mode == DragMode::constant_force
                                             ? std::optional<double>(stroke.force_N)
                                             : std::nullopt,
                              .start_m = {stroke.start_x_m, 0.0, steps.height_m}});
  HeldToolRecord record(1.0 / dt_s);
  record.reserve(kept);
  TurningRecord turning{};
  Run run{.slowest_m_per_s = stroke.speed_m_per_s, .lowest_m = steps.height_m};
  double time_s = 0.0;
  std::size_t in_the_air = 0;
  const auto feel = [&](bool is_first) {
    const double place_m = tool.state().position_m.x + free.place_m(time_s);
    const double speed_m_per_s = tool.state().velocity_m_per_s.x + free.speed_m_per_s(time_s);
    const ProbeState probe =
        probe_on(guide, {place_m, tool.state().position_m.z},
                 {speed_m_per_s, tool.state().velocity_m_per_s.z}, tool.state().time_ns);
    if (is_first) renderer.reset(probe);
    const RenderedTick rendered = renderer.tick(probe, dt_s);
    const glm::dvec2 force_N = forces_on(guide, guide.at(place_m), rendered.wrench);
    tool.feel({force_N.x, 0.0, force_N.y});
    return std::pair{force_N.x, rendered};
  };
  feel(true);
  for (std::size_t i = 0; i < dropped + kept; ++i) {
    if (i % kBetweenStops == 0 && stop.stop_requested()) return std::nullopt;
    time_s = static_cast<double>(i + 1) * dt_s;
    tool.advance(dt_s);
    const auto [along_N, rendered] = feel(false);
    if (i < dropped) continue;
    if (!is_in_contact(rendered)) ++in_the_air;
    record.add(tool.acceleration_m_per_s2().x, tool.acceleration_m_per_s2().y);
    if (guide.turn_rad_per_m() > 0.0)
      turning.add(along_N / guide.turn_rad_per_m(), rendered.wrench.force_N);
    run.lowest_m = std::min(run.lowest_m, tool.state().position_m.z);
    const double free_m_per_s = free.speed_m_per_s(time_s);
    const double forwards_m_per_s =
        tool.state().velocity_m_per_s.x + (is_to_and_fro ? free_m_per_s : 0.0);
    if (!is_to_and_fro) {
      run.slowest_m_per_s = std::min(run.slowest_m_per_s, forwards_m_per_s);
    } else if (std::abs(free_m_per_s) > kFast * stroke.speed_m_per_s) {
      run.slowest_m_per_s =
          std::min(run.slowest_m_per_s, std::copysign(1.0, free_m_per_s) * forwards_m_per_s);
    }
  }
  run.share_without_contact = static_cast<double>(in_the_air) / static_cast<double>(kept);
  run.roughness = record.roughness();
  if (run.roughness.max_accel_m_per_s2 < kRounding_m_per_s2) run.roughness = {};
  if (guide.turn_rad_per_m() > 0.0) run.turning = turning.roughness(1.0 / dt_s);
  return run;
}

bool agree(double a, double b, double tolerance, double floor) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) + floor;
}

bool agree(const HeldToolRoughness& a, const HeldToolRoughness& b) {
  const double floor = kPowerFloor * b.rms_accel_m_per_s2 * b.rms_accel_m_per_s2;
  const auto power_of = [](const HeldToolRoughness& one) {
    return one.pacinian_dB ? std::pow(10.0, 0.1 * *one.pacinian_dB) : 0.0;
  };
  // The floor in units of the weighted power, with the weight of the threshold's own frequency.
  const double weighted_floor =
      floor * power_of(b) / std::max(b.rms_accel_m_per_s2 * b.rms_accel_m_per_s2, 1e-300);
  return agree(a.max_accel_m_per_s2, b.max_accel_m_per_s2, kAccelerationTolerance, 0.0) &&
         agree(a.rms_accel_m_per_s2, b.rms_accel_m_per_s2, kAccelerationTolerance, 0.0) &&
         agree(a.fa1_m2_per_s4, b.fa1_m2_per_s4, kPowerTolerance, floor) &&
         agree(a.fa2_m2_per_s4, b.fa2_m2_per_s4, kPowerTolerance, floor) &&
         agree(power_of(a), power_of(b), kPowerTolerance, weighted_floor);
}

}  // namespace

const char* text_of(DragStatus status) noexcept {
  switch (status) {
    case DragStatus::ok:
      return "ok";
    case DragStatus::stick_slip:
      return "stick_slip";
    case DragStatus::not_converged:
      return "not_converged";
    case DragStatus::lost_contact:
      return "lost_contact";
    case DragStatus::saturated:
      return "saturated";
  }
  return "";
}

const char* text_of(DragMode mode) noexcept {
  switch (mode) {
    case DragMode::constant_height:
      return "constant_height";
    case DragMode::constant_force:
      return "constant_force";
  }
  return "";
}

double beginning_s(const HandModel& hand, std::optional<double> surface_N_per_m) {
  const double decay_per_s = slowest_decay_per_s(hand, surface_N_per_m);
  if (!(decay_per_s > 0.0)) {
    throw std::invalid_argument(
        "the motion of Drag::hand never settles; give it a damping and a stiffness");
  }
  return kForgotten / decay_per_s;
}

std::optional<DragResult> drag(ForceRenderer& renderer, const Drag& stroke,
                               const std::stop_token& stop) {
  require_positive("Drag::speed_m_per_s", stroke.speed_m_per_s);
  require_positive("Drag::force_N", stroke.force_N);
  require_positive("Drag::spacing_m", stroke.spacing_m);
  require_positive("Drag::repeats_after_m", stroke.repeats_after_m);
  require_positive("Drag::stiffness_N_per_m", stroke.stiffness_N_per_m);
  require_not_negative("Drag::swing_m", stroke.swing_m);
  const Length length = length_of(stroke);
  const StraightGuide straight{};
  const StrokeGuide& guide = stroke.guide ? *stroke.guide : straight;
  StillHeight still(renderer, stroke, guide);
  const ConstantHeight found =
      constant_height([&](double height_m) { return still.mean_normal_N(height_m); },
                      {.force_N = stroke.force_N,
                       .stiffness_N_per_m = stroke.stiffness_N_per_m,
                       .tolerance = 1e-3,
                       .height_bits = 24});
  if (!found.height_m) return DragResult{.status = DragStatus::saturated};

  Steps steps{.in_a_spacing = std::bit_ceil(
                  static_cast<std::size_t>(std::ceil(length.spacing_s / kLongestStep_s))),
              .height_m = *found.height_m};
  std::optional<Run> last = simulated(renderer, stroke, guide, length, steps, stop);
  DragResult result{.status = DragStatus::not_converged, .height_m = *found.height_m};
  for (int halving = 0; last && halving < kStepHalvings; ++halving) {
    steps.in_a_spacing *= 2;
    const std::optional<Run> finer = simulated(renderer, stroke, guide, length, steps, stop);
    const bool is_same = finer && agree(last->roughness, finer->roughness);
    last = finer;
    if (is_same) {
      result.status = DragStatus::ok;
      break;
    }
  }
  if (!last) return std::nullopt;
  result.roughness = last->roughness;
  result.turning = last->turning;
  result.time_step_s = length.spacing_s / static_cast<double>(steps.in_a_spacing);
  result.slowest_m_per_s = last->slowest_m_per_s;
  result.share_without_contact = last->share_without_contact;
  if (still.yields_at(last->lowest_m)) {
    result.status = DragStatus::saturated;
  } else if (result.share_without_contact > kMostWithoutContact) {
    result.status = DragStatus::lost_contact;
  } else if (result.status == DragStatus::ok &&
             result.slowest_m_per_s < kCaught * stroke.speed_m_per_s) {
    result.status = DragStatus::stick_slip;
  }
  return result;
}

}  // namespace asperity
