// A device without hardware: a probe held by a hand.

#include "device/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

constexpr std::int64_t kLongestStep_ns = 1'000'000;
// Nearer to a resting hand than this and slower, the probe rests with it.
constexpr double kResting_m = 1e-9;
constexpr double kResting_m_per_s = 1e-7;

DeviceCapability simulated_capability(const SimulatedDeviceSettings& settings) {
  DeviceCapability capability =
      settings.stands_for.value_or(DeviceCapability{.model = "mass, spring and damper",
                                                    .continuous_force_N = settings.peak_force_N,
                                                    .maximum_rate_Hz = 10'000.0});
  capability.name = "simulated";
  capability.serial.clear();
  capability.sensed_degrees_of_freedom = 3;
  capability.actuated_degrees_of_freedom = 3;
  capability.peak_force_N = settings.peak_force_N;
  capability.position_resolution_m = settings.sensor.position_step_m;
  capability.buttons = VirtualHand::kButtons;
  capability.pacing = Pacing::ours;
  capability.may_rest_exactly = true;
  return capability;
}

void check_simulation(const SimulatedDeviceSettings& settings) {
  const HandMechanics& hand = settings.hand;
  require_positive("mass_kg of the simulated hand", hand.mass_kg);
  require_positive("damping_N_s_per_m of the simulated hand", hand.damping_N_s_per_m);
  require_positive("stiffness_N_per_m of the simulated hand", hand.stiffness_N_per_m);
  require_positive("normal_damping_N_s_per_m of the simulated hand", hand.normal_damping_N_s_per_m);
  require_positive("reach_m of the simulated hand", hand.reach_m);
  if (settings.substeps < 1 || settings.substeps > 1000) {
    refuse("substeps of the simulated device", settings.substeps, "from 1 to 1000");
  }
  require_not_negative("saturation_force_N of the simulated device", settings.saturation_force_N);
  require_not_negative("friction_N of the simulated device", settings.friction_N);
  for (const ScriptedFault& fault : settings.faults) {
    require_not_negative("at_s of a scripted fault", fault.at_s);
    require_not_negative("duration_s of a scripted fault", fault.duration_s);
  }
}

std::int64_t nanoseconds(double duration_s) noexcept { return std::llround(1e9 * duration_s); }

bool is_active(const ScriptedFault& fault, std::int64_t since_start_ns) noexcept {
  const std::int64_t since_fault_ns = since_start_ns - nanoseconds(fault.at_s);
  return since_fault_ns >= 0 &&
         (fault.duration_s == 0.0 || since_fault_ns < nanoseconds(fault.duration_s));
}

// What friction of at most `friction_N` leaves of `momentum`, what the mass would go on with: the
// velocity v of
//
//   drag v + friction · v/|v| = momentum,   or 0 where |momentum| ≤ friction.
//
// With s = |v|, v = momentum s/(drag s + friction), so s is where w = momentum/(drag s + friction) has
// length 1. Newton's method on 1/|w|, which is a straight line where the drag is the same in all
// directions, comes from below: it starts where the largest drag in every direction would put s.
glm::dvec3 velocity_against(double friction_N, const glm::dvec3& drag_N_s_per_m,
                            const glm::dvec3& momentum_N) noexcept {
  const double strength_N = glm::length(momentum_N);
  if (strength_N <= friction_N) return glm::dvec3(0.0);
  constexpr int kSteps = 5;
  const glm::dvec3& a = drag_N_s_per_m;
  double s = (strength_N - friction_N) / std::max({a.x, a.y, a.z});
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 w = momentum_N / (a * s + friction_N);
    const double p = glm::dot(w, w);
    const double slope = glm::dot(w * w, a / (a * s + friction_N));
    s += p * (std::sqrt(p) - 1.0) / slope;
  }
  return momentum_N * s / (a * s + friction_N);
}

}  // namespace

SimulatedDevice::SimulatedDevice(VirtualHand& hand, const SimulatedDeviceSettings& settings)
    : HapticDevice(simulated_capability(settings), ForceLimits{}),
      hand_(hand),
      settings_(settings),
      sensor_(settings.sensor) {
  check_simulation(settings_);
}

SimulatedDevice::~SimulatedDevice() { zero_force(); }

bool SimulatedDevice::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  const bool first = !started_;
  if (first) {
    started_ = true;
    first_ns_ = now_ns;
    intent_ = hand_.intent(now_ns);
    probe_.time_ns = now_ns;
    probe_.position_m = intent_.position_m;
  }

  const std::int64_t last_ns = first ? -1 : probe_.time_ns - first_ns_;
  const std::int64_t since_start_ns = now_ns - first_ns_;
  bool not_a_number = false;
  lost_ = false;
  for (const ScriptedFault& fault : settings_.faults) {
    switch (fault.kind) {
      case ScriptedFault::Kind::lost:
        lost_ = lost_ || is_active(fault, since_start_ns);
        break;
      case ScriptedFault::Kind::nan:
        not_a_number = not_a_number || is_active(fault, since_start_ns);
        break;
      case ScriptedFault::Kind::stall: {
        const std::int64_t at_ns = nanoseconds(fault.at_s);
        if (settings_.sleep && last_ns < at_ns && at_ns <= since_start_ns) {
          settings_.sleep(fault.duration_s);
        }
        break;
      }
    }
  }
  if (lost_ || is_zeroed_.load(std::memory_order_relaxed)) {
    pushed_ = Wrench{};
  }
  move_until(now_ns);

  probe_.buttons = hand_.take_buttons();
  state = sensor_.read(probe_);
  if (not_a_number) {
    state.position_m = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  }
  return !lost_;
}

bool SimulatedDevice::do_send(const Wrench& limited) noexcept {
  if (lost_) {
    return false;
  }
  pushed_ = limited;
  is_zeroed_.store(false, std::memory_order_relaxed);
  const double strength_N = glm::length(limited.force_N);
  if (settings_.saturation_force_N > 0.0 && strength_N > settings_.saturation_force_N) {
    pushed_.force_N *= settings_.saturation_force_N / strength_N;
    gave_only(pushed_);
  }
  return true;
}

void SimulatedDevice::move_until(std::int64_t now_ns) noexcept {
  const std::int64_t gap_ns = std::clamp(now_ns - probe_.time_ns, std::int64_t{0}, kLongestGap_ns);
  const HandIntent before = intent_;
  intent_ = hand_.intent(now_ns);
  probe_.time_ns = std::max(probe_.time_ns, now_ns);

  const std::int64_t fewest = (gap_ns + kLongestStep_ns - 1) / kLongestStep_ns;
  const int steps = static_cast<int>(std::max<std::int64_t>(settings_.substeps, fewest));
  const double step_s = 1e-9 * static_cast<double>(gap_ns) / steps;
  const HandMechanics& hand = settings_.hand;
  const glm::dvec3 damping(hand.damping_N_s_per_m, hand.damping_N_s_per_m,
                           hand.normal_damping_N_s_per_m);
  const glm::dvec3 pushing_N = pushed_.force_N - glm::dvec3(0.0, 0.0, intent_.press_N);

  glm::dvec3& x = probe_.position_m;
  glm::dvec3& v = probe_.velocity_m_per_s;
  const bool hand_rests = intent_.lifted && intent_.position_m == before.position_m &&
                          intent_.velocity_m_per_s == glm::dvec3(0.0);
  // As in every tick of a break: the steps would end at the same place.
  if (hand_rests && x == intent_.position_m && v == glm::dvec3(0.0) &&
      pushing_N == glm::dvec3(0.0)) {
    return;
  }
  for (int step = 1; step <= steps; ++step) {
    const double part = static_cast<double>(step) / steps;
    glm::dvec3 hold = glm::mix(before.position_m, intent_.position_m, part);
    const glm::dvec3 hold_velocity =
        glm::mix(before.velocity_m_per_s, intent_.velocity_m_per_s, part);
    glm::dvec3 stiffness(hand.stiffness_N_per_m);
    if (!intent_.lifted) {
      hold.z -= hand.reach_m;
      stiffness.z = x.z < hold.z ? hand.stiffness_N_per_m : 0.0;
    }
    // m (v' − v)/h = pushing + k (hold − x − h v') + b (v_hold − v'), solved for v'.
    const glm::dvec3 force = pushing_N + stiffness * (hold - x) + damping * hold_velocity;
    v = (v + step_s / hand.mass_kg * force) /
        (1.0 + step_s / hand.mass_kg * (damping + step_s * stiffness));
    if (settings_.friction_N > 0.0 && step_s > 0.0) {
      const glm::dvec3 drag = hand.mass_kg / step_s + damping + step_s * stiffness;
      v = velocity_against(settings_.friction_N, drag, drag * v);
    }
    x += step_s * v;
  }
  // Without this the probe would come ever closer to a resting hand, and every contact would begin a little differently.
  if (hand_rests && glm::distance(x, intent_.position_m) < kResting_m &&
      glm::length(v) < kResting_m_per_s) {
    x = intent_.position_m;
    v = glm::dvec3(0.0);
  }
}

}  // namespace asperity
