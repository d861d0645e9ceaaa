// Reads the hand and pushes it; nothing reaches the motors past the limiter.

#include "device/haptic_device.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

ForceLimits within(const DeviceCapability& capability, ForceLimits limits) {
  if (capability.actuated_degrees_of_freedom == 0) {
    return limits;  // it has no motors to spare
  }
  require_positive("peak_force_N of the device " + capability.name, capability.peak_force_N);
  limits.force_N = std::min(limits.force_N, capability.peak_force_N);
  return limits;
}

constexpr int kForceAndTorque = 6;

// What is not there cannot be limited: a force in the record would tell of a push that nobody felt.
Wrench as_actuated(const DeviceCapability& capability, Wrench wanted) noexcept {
  if (capability.actuated_degrees_of_freedom == 0) return {};
  if (capability.actuated_degrees_of_freedom < kForceAndTorque) wanted.torque_N_m = glm::dvec3(0.0);
  return wanted;
}

}  // namespace

HapticDevice::HapticDevice(DeviceCapability capability, const ForceLimits& limits)
    : capability_(std::move(capability)), limiter_(within(capability_, limits)) {}

void HapticDevice::set_limits(const ForceLimits& limits) {
  limiter_ = ForceLimiter(within(capability_, limits));
}

std::optional<ProbeState> HapticDevice::read(std::int64_t now_ns) noexcept {
  ProbeState state{.time_ns = now_ns};
  is_read_again_ = false;
  forget_silence(now_ns);
  if (!do_read(now_ns, state)) {
    return std::nullopt;
  }
  if (!capability_.may_rest_exactly && !is_read_again_) {
    pose_.take(state, std::min(weakest_N_, pushed_N_));
    weakest_N_ = std::numeric_limits<double>::infinity();
    is_frozen_.store(pose_.is_frozen(), std::memory_order_relaxed);
  }
  if (pose_.is_frozen()) return std::nullopt;
  return state;
}

// Another silence may be noted meanwhile: then it is that one which is not over yet.
void HapticDevice::forget_silence(std::int64_t now_ns) noexcept {
  Silence silence = silence_.load(std::memory_order_relaxed);
  if (silence == Silence::silent) {
    silence_over_ns_ = now_ns;
    silence_.compare_exchange_strong(silence, Silence::just_over, std::memory_order_relaxed);
  } else if (silence == Silence::just_over && now_ns - silence_over_ns_ >= kToForgetSilence_ns) {
    silence_.compare_exchange_strong(silence, Silence::none, std::memory_order_relaxed);
  }
}

std::optional<LimitedWrench> HapticDevice::push(const Wrench& wanted, double elapsed_s) noexcept {
  if (pose_.is_frozen()) {
    zero_force();
    return std::nullopt;
  }
  LimitedWrench limited = limiter_.limit(as_actuated(capability_, wanted), elapsed_s);
  given_.reset();
  gave_less_ = false;
  if (!do_send(limited.wrench)) {
    // Its motors are at zero, or unknown; whatever comes next rises from zero.
    limiter_.reset();
    note_push(0.0);
    return std::nullopt;
  }
  if (given_) limited.wrench = *given_;
  if (given_ || gave_less_) limited.reasons |= static_cast<std::uint8_t>(LimitReason::force);
  note_push(glm::length(limited.wrench.force_N));
  return limited;
}

void HapticDevice::zero_force() noexcept {
  limiter_.reset();
  note_push(0.0);
  do_send(Wrench{});
}

void HapticDevice::note_push(double force_N) noexcept {
  pushed_N_ = force_N;
  weakest_N_ = std::min(weakest_N_, force_N);
}

std::string HapticDevice::complaint() const {
  std::string told = trouble();
  if (!is_frozen_.load(std::memory_order_relaxed)) return told;
  return capability_.model + (capability_.serial.empty() ? "" : " " + capability_.serial) +
         " reports the same position repeatedly although a force acts on it or it reports a "
         "velocity; its positions are not used. Move its handle; if that does not help, check its "
         "cable, and open it again." +
         (told.empty() ? "" : " ") + told;
}

void HapticDevice::start_calls(const TickCall&) {
  throw std::logic_error("the device " + capability_.name +
                         " does not run the loop itself; run it in the program");
}

}  // namespace asperity
