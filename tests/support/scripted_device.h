// A haptic device whose behaviour a test sets.

#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "device/haptic_device.h"

namespace asperity {

/// Answers every reading with `probe`, takes every wrench, and keeps the last one. Where a test sets `at_read`
/// or `at_send`, it is called first, and may change that.
///
/// Without a capability of the test, it limits nothing that a test renders, may rest to the last bit, and may jump.
///
/// It zeroes its force when it is destroyed, as every driver does: what `at_send` refers to lives as long as
/// the device.
class ScriptedDevice final : public HapticDevice {
 public:
  ScriptedDevice()
      : ScriptedDevice({.name = "scripted",
                        .peak_force_N = 100.0,
                        .continuous_force_N = 100.0,
                        .maximum_speed_m_per_s = std::numeric_limits<double>::infinity(),
                        .may_rest_exactly = true},
                       {.force_N = 100.0, .torque_N_m = 10.0, .slew_N = 1e6, .slew_N_m = 1e6}) {}
  explicit ScriptedDevice(DeviceCapability capability, const ForceLimits& limits = {})
      : HapticDevice(std::move(capability), limits) {}
  ~ScriptedDevice() override {
    zero_force();
    if (at_close) at_close();
  }

  ProbeState probe{};  ///< its time is replaced by that of the reading
  bool answers = true;
  bool accepts = true;
  std::string trouble_text{};

  /// In each reading, with `probe` at the time of the reading, which it may change.
  std::function<void(ProbeState&)> at_read{};
  std::function<void(const Wrench&)> at_send{};
  std::function<void()> at_close{};  ///< the force is at zero

  int reads = 0;  ///< the present one included
  int sent = 0;
  Wrench last_sent{};

  std::function<void()> at_zero_from_outside{};  ///< in the thread of the watch

  void zero_force_from_outside() noexcept override {
    if (at_zero_from_outside) at_zero_from_outside();
  }
  std::string trouble() const override { return trouble_text; }
  using HapticDevice::gave_less;
  using HapticDevice::gave_only;
  using HapticDevice::has_fallen_silent;
  using HapticDevice::read_again;

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override {
    ++reads;
    state = probe;
    state.time_ns = now_ns;
    if (at_read) at_read(state);
    return answers;
  }
  bool do_send(const Wrench& limited) noexcept override {
    last_sent = limited;
    ++sent;
    if (at_send) at_send(limited);
    return accepts;
  }
};

}  // namespace asperity
