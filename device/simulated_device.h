// A device without hardware: a probe held by a hand.

#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "device/haptic_device.h"
#include "device/imperfect_sensor.h"
#include "device/virtual_hand.h"

namespace asperity {

/// The mechanics of the hand that holds the probe.
struct HandMechanics {
  double mass_kg = 0.050;
  double damping_N_s_per_m = 5.0;    ///< along the surface
  double stiffness_N_per_m = 300.0;  ///< of the hand's hold, along the surface and while lifted
  /// Across the surface: critical for the mass on a surface of 500 N/m, so that contact settles.
  double normal_damping_N_s_per_m = 10.0;
  double reach_m = 0.020;  ///< how far below the surface the hand follows before its hold stops it
};

/// A fault that happens at a time after the first read, for tests of what follows.
struct ScriptedFault {
  enum class Kind {
    lost,   ///< the device does not answer any more, and its motors are at zero
    nan,    ///< it answers with a position that is not a number
    stall,  ///< it takes `duration_s` to answer (real time: sleeps; stepped: nothing)
  };
  Kind kind = Kind::lost;
  double at_s = 0.0;
  double duration_s = 0.0;  ///< how long it lasts; lost and nan for ever when 0
};

struct SimulatedDeviceSettings {
  HandMechanics hand{};
  std::vector<ScriptedFault> faults{};
  int substeps = 4;            ///< integration steps per read
  double peak_force_N = 10.0;  ///< of its motors
  /// What the motors really give at most, where that is less than their peak (warm, a weak supply);
  /// 0: their peak. A stronger force keeps its direction and is reported as limited.
  double saturation_force_N = 0.0;
  double friction_N = 0.0;  ///< of the device's joints, as a force on the probe
  SensorSettings sensor{};
  /// Gives model, workspace, continuous force, rate and remarks of a device that this one stands for
  /// (simulated_models.h). Its name stays "simulated", and what it senses and gives its own.
  std::optional<DeviceCapability> stands_for{};
  /// How a scripted stall lets time pass, in real time: sleeps. Left empty when stepped. Must not
  /// throw.
  std::function<void(double duration_s)> sleep{};
};

/// The probe as a mass on the spring and damper of a VirtualHand, pushed by the rendered force:
///
///   m a = k (x_hand − x) + b (v_hand − v) − press·ẑ + F − friction
///
/// in x and y always; in z the spring holds while the hand is lifted and gives way to `press` in
/// contact, so that the hand presses with a force rather than to a depth, with the damping b_z. A
/// hand that meets nothing sinks at press / b_z until `reach` below the surface, where its spring
/// holds again. Without a push and with the hand at rest, the energy m v²/2 + k (x_hand − x)²/2
/// only falls. Within 1 nm of a resting hand in the air and slower than 0.1 µm/s the probe rests exactly with it.
///
/// The friction of the device's joints is f against the velocity, and up to f whatever keeps a resting
/// probe at rest: a force below f moves no resting hand, and a moving one has its probe f/k behind. It
/// is one force, the same in all directions, so that a probe that slides along the surface gives way
/// across it to the smallest force.
///
/// Integrated between reads with the force of the last `push`, in `substeps` steps or more so that
/// none is longer than 1 ms: the spring's and the damper's force are taken at the end of the step
/// (linearly implicit Euler), so no step can make the hand unstable. The surface is explicit, as on
/// any device: b_z > K·T/2 + |B| for a surface of stiffness K and damping B is passive [Colgate 1997], with the defaults
/// and no damper up to 10 kN/m at 500 Hz. In a gap beyond kLongestGap_ns the motion stands still.
///
/// What is read is what the `sensor` makes of it (imperfect_sensor.h). The defaults have neither
/// friction nor saturation nor an imperfect sensor: recordings made without them replay bit for bit.
///
/// Works at any rate up to 10 kHz, in real time or stepped: it depends only on the times at which it is read.
///
/// Frame: the hand's. Torques are taken and have no effect.
///
/// Errors: std::invalid_argument naming the setting that is not positive or finite.
///
/// Real-time: reading and sending do not allocate, lock or throw (a scripted stall sleeps).
///
/// [Colgate 1997] Colgate, Schenkel: Passivity of a class of sampled-data systems.
class SimulatedDevice final : public HapticDevice {
 public:
  /// `hand` must outlive the device.
  SimulatedDevice(VirtualHand& hand, const SimulatedDeviceSettings& settings);
  ~SimulatedDevice() override;

  void zero_force_from_outside() noexcept override { is_zeroed_.store(true); }

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  void move_until(std::int64_t now_ns) noexcept;

  VirtualHand& hand_;
  SimulatedDeviceSettings settings_{};
  HandIntent intent_{};
  ProbeState probe_{};
  ImperfectSensor sensor_;
  Wrench pushed_{};
  std::atomic<bool> is_zeroed_{false};  ///< from outside, since the last push
  std::int64_t first_ns_ = 0;
  bool started_ = false;
  bool lost_ = false;
};

}  // namespace asperity
