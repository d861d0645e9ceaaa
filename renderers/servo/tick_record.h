// Declares the record of one tick of the servo loop.

#pragma once

#include <cstdint>

#include "device/probe_state.h"
#include "device/wrench.h"

namespace asperity {

/// Bits of TickRecord::flags. The first four are those of LimitReason.
enum class TickFlag : std::uint32_t {
  limited_not_finite = 1,
  limited_force = 2,
  limited_torque = 4,
  limited_slew = 8,
  missed_deadline = 16,  ///< the tick began more than one period late
  device_lost = 32,
  fault_latched = 64,
  heartbeat_lost = 128,         ///< the surface fades because heartbeats are missing
  presenting = 256,             ///< a renderer was called
  first_of_presentation = 512,  ///< the renderer was reset; again after a fault was cleared
  /// The reading was implausible; the last one took its place (device/reading_check.h).
  reading_held = 1024,
  /// More than two periods after the previous tick, in contact (gap_bridge.h).
  gap_in_contact = 2048,
};

/// The recorded values of one tick. The probe is already rounded to the recording's precision
/// (`rounded_for_recording`), so that a recording replays exactly. While the device is lost, it is the last known
/// state.
struct TickRecord {
  ProbeState probe{};
  Wrench rendered{};  ///< by the renderer, before ramp and limits
  Wrench sent{};      ///< to the device
  double penetration_m = 0.0;
  double gain = 0.0;  ///< of the ramp, 0 to 1
  std::uint64_t presentation =
      0;  ///< Presentation::id, or the part that was rendered; 0 in free space
  std::uint32_t flags = 0;
  std::int32_t lateness_ns = 0;   ///< start of the tick minus its deadline, saturating
  std::int32_t execution_ns = 0;  ///< duration of the tick; 0 if stepped
  bool has(TickFlag flag) const noexcept { return (flags & static_cast<std::uint32_t>(flag)) != 0; }
};

/// Converts every component to float and back: the values that are read back from a recording.
ProbeState rounded_for_recording(const ProbeState& probe) noexcept;
glm::dvec3 rounded_for_recording(const glm::dvec3& vector) noexcept;

}  // namespace asperity
