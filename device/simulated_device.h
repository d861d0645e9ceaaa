// A device without hardware: a probe held by a hand.

#pragma once

#include <cstdint>
#include <vector>

#include "device/haptic_device.h"
#include "device/virtual_hand.h"

namespace asperity {

/// The mechanics of the hand that holds the probe.
struct HandMechanics {
  double mass_kg = 0.050;
  double damping_N_s_per_m = 5.0;
  double stiffness_N_per_m = 300.0;  ///< of the hand's hold, along the surface and while lifted
};

/// A fault that happens at a time after the first read, for tests of what follows.
struct ScriptedFault {
  enum class Kind {
    lost,   ///< the device does not answer any more
    nan,    ///< it answers with a position that is not a number
    stall,  ///< it takes `duration_s` to answer (real time: sleeps; stepped: nothing)
  };
  Kind kind = Kind::lost;
  double at_s = 0.0;
  double duration_s = 0.0;  ///< how long it lasts; lost for ever when 0
};

struct SimulatedDeviceSettings {
  HandMechanics hand{};
  std::vector<ScriptedFault> faults{};
  int substeps = 4;  ///< integration steps per read
};

/// The probe as a mass on the spring and damper of a VirtualHand, pushed by the rendered force:
///
///   m a = k (x_hand − x) + b (v_hand − v) − press·ẑ + F
///
/// in x and y always; in z the spring holds while the hand is lifted and gives way to `press` in
/// contact, so that the hand presses with a force rather than to a depth. Integrated between reads
/// with the force of the last `push`, semi-implicitly, in `substeps` steps.
///
/// Works at any rate up to 10 kHz, in real time or stepped: it knows only the times it is read at.
///
/// Real-time: reading and sending do not allocate, lock or throw (a scripted stall sleeps).
class SimulatedDevice final : public HapticDevice {
 public:
  /// `hand` must outlive the device.
  SimulatedDevice(VirtualHand& hand, const SimulatedDeviceSettings& settings);
  ~SimulatedDevice() override;

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  VirtualHand& hand_;
  SimulatedDeviceSettings settings_{};
  ProbeState probe_{};
  Wrench pushed_{};
  std::int64_t first_ns_ = 0;
  bool started_ = false;
};

}  // namespace asperity
