// Reads the hand and pushes it; nothing reaches the motors past the limiter.

#pragma once

#include <cstdint>
#include <optional>

#include "device/device_capability.h"
#include "device/force_limiter.h"
#include "device/probe_state.h"

namespace asperity {

/// A force-feedback device, real or simulated.
///
/// Every wrench passes the limiter that this class owns; a driver sees only limited ones. A driver
/// implements `do_read`, `do_send` and nothing about safety. The motors are at zero after
/// construction, after `zero_force` and after destruction (each driver's destructor sends zero).
///
/// Errors: the constructor throws std::invalid_argument for a device that has motors and no
/// positive peak force, or for a limit that is not positive and finite.
///
/// Real-time: `read`, `push` and `zero_force` run on the servo thread; they do not allocate, lock,
/// log or throw. Drivers hold themselves to the same.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  const DeviceCapability& capability() const noexcept { return capability_; }

  /// Before the loop starts. Limits above the device's peak force are lowered to it.
  /// Errors: std::invalid_argument for a limit that is not positive and finite.
  void set_limits(const ForceLimits& limits);
  const ForceLimits& limits() const noexcept { return limiter_.limits(); }

  /// The hand at `now_ns`; nothing when the device does not answer (it is lost).
  std::optional<ProbeState> read(std::int64_t now_ns) noexcept;

  /// Limits `wanted` and sends it; returns what was really sent. A device with fewer than six actuated
  /// degrees of freedom gets the force alone. Nothing when the device is lost; when it comes back, its
  /// force rises from zero.
  std::optional<LimitedWrench> push(const Wrench& wanted, double dt_s) noexcept;

  /// Zero force at once, past the slew limit.
  void zero_force() noexcept;

 protected:
  HapticDevice(DeviceCapability capability, const ForceLimits& limits);

 private:
  /// Fills `state`, whose time is already `now_ns`; false when the device does not answer.
  virtual bool do_read(std::int64_t now_ns, ProbeState& state) noexcept = 0;
  /// False when the device does not take it.
  virtual bool do_send(const Wrench& limited) noexcept = 0;

  DeviceCapability capability_{};
  ForceLimiter limiter_;
};

}  // namespace asperity
