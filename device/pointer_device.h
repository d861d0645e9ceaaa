// A mouse or a tablet's pen as a probe: moves, presses, and has no motors.

#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/drivers.h"
#include "device/haptic_device.h"
#include "device/latest_value.h"

namespace asperity {

struct PointerSettings {
  double half_width_m = 0.1;   ///< of the workspace, x
  double half_length_m = 0.1;  ///< y
  double deepest_m = 0.002;    ///< below the surface at full pressure
  double held_pressure = 0.5;  ///< what the held button of a mouse counts as
  double lift_m = 0.005;       ///< how far above the surface it waits
};

/// A window's pointer, followed as by a hand at 1 kHz although its events come with the frames of a
/// screen:
///
///   x″ = ω² (aim − x) − 2ω x′,   ω = 80 rad/s, critically damped
///
/// in all three axes, where the aim is the last sample's place, −deepest · pressure below the surface,
/// or lift above it where nothing presses. Each step is the equation's exact solution, so that the
/// path depends on the aims and their times alone. A pointer at constant speed v is trailed by 2v/ω,
/// 25 ms of its way. The velocity is the path's own, without lag or noise of its own.
///
/// The window feeds it through a mailbox: a sample counts from the reading on that finds it; samples
/// that come closer than readings are lost but for the last. No sample is no fault: a mouse at rest is
/// silent. The window has to lift it when the pointer leaves. Samples outside the workspace are
/// taken at its edge; what is not finite is no sample.
///
/// Frame: x to the right, y away, z up; z = 0 is the surface. Forces are limited and go nowhere.
///
/// Errors: the constructor throws std::invalid_argument naming the setting that is not positive.
///
/// Threads: the mailbox's writer is the window's thread, its reader the one that reads the device.
///
/// Real-time: reading and sending do not allocate, lock or throw.
class PointerDevice final : public HapticDevice {
 public:
  /// `samples` must outlive the device.
  explicit PointerDevice(LatestValue<PointerSample>& samples, const PointerSettings& settings = {});

  void zero_force_from_outside() noexcept override {}

 private:
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench&) noexcept override { return true; }

  void take_aim() noexcept;

  LatestValue<PointerSample>& samples_;
  PointerSettings settings_{};
  glm::dvec3 aim_m_{0.0};
  glm::dvec3 at_m_{0.0};
  glm::dvec3 velocity_m_per_s_{0.0};
  std::int64_t last_ns_ = 0;
  bool has_read_ = false;
  bool has_aimed_ = false;
};

/// "mouse": the pointer of the window that gives its mailbox.
Driver pointer_driver();

}  // namespace asperity
