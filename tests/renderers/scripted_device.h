// A device that says what a test wants and remembers what it was sent.

#pragma once

#include <limits>

#include "device/haptic_device.h"

namespace asperity {

class ScriptedDevice final : public HapticDevice {
 public:
  ScriptedDevice() : HapticDevice(capability_of(), generous_limits()) {}

  ProbeState probe{};  // its time is replaced by that of the reading
  bool answers = true;
  bool accepts = true;
  Wrench last_sent{};
  int sent = 0;

 private:
  static DeviceCapability capability_of() {
    DeviceCapability capability;
    capability.name = "scripted";
    capability.peak_force_N = 100.0;
    capability.continuous_force_N = 100.0;
    capability.may_rest_exactly = true;
    return capability;
  }
  // So generous that they leave alone whatever these tests render.
  static ForceLimits generous_limits() {
    return {.force_N = 100.0, .torque_N_m = 10.0, .slew_N_per_s = 1e9};
  }

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override {
    state = probe;
    state.time_ns = now_ns;
    return answers;
  }
  bool do_send(const Wrench& limited) noexcept override {
    last_sent = limited;
    ++sent;
    return accepts;
  }
};

}  // namespace asperity
