// What a device can sense, do and survive.

#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "device/device_trait.h"

namespace asperity {

/// Who owns the loop: a device that we poll, or one whose vendor's thread calls us.
enum class Pacing { ours, theirs };

/// The fastest motion of a hand on a device. No manufacturer states one; this is several times the speed of a free stroke, up
/// to some 1 m/s.
inline constexpr double kFastestHand_m_per_s = 5.0;

/// A device's own description of itself; protocols and checks are compared with it before a
/// session.
struct DeviceCapability {
  std::string name{};  ///< the driver's name, e.g. "simulated"
  std::string model{};
  std::string serial{};
  int sensed_degrees_of_freedom = 3;
  int actuated_degrees_of_freedom = 3;
  glm::dvec3 workspace_minimum_m{-0.1};
  glm::dvec3 workspace_maximum_m{0.1};
  double peak_force_N = 0.0;           ///< positive for a device with motors
  double continuous_force_N = 0.0;     ///< 0 where it is not known
  double position_resolution_m = 0.0;  ///< 0 where it is not known
  double maximum_rate_Hz = 1000.0;
  /// The fastest motion of the hand that a reading may imply (reading_check.h). Infinite for a hand that may jump: one
  /// that plays a recording, or a pointer, which can be set down elsewhere; neither has motors.
  double maximum_speed_m_per_s = kFastestHand_m_per_s;
  int buttons = 0;  ///< that a participant can press; bits of ProbeState::buttons
  Pacing pacing = Pacing::ours;
  /// The hand is computed, and rests where it rests to the last bit: a pose that stays the same is no
  /// fault (pose_watch.h).
  bool may_rest_exactly = false;
  /// Sentences about what shapes what is felt and read: filters of the maker's software, how velocity is
  /// estimated, which of these numbers are not the maker's own.
  std::string remarks{};
  /// Of a simulated device that stands for a real one (simulated_models.h): what is not known of the real one. Measured
  /// here it would be ideal, or the virtual hand's. Empty of all others.
  std::vector<DeviceTrait> not_known{};
};

}  // namespace asperity
