// One reading of the hand.

#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// Where the probe is and how it moves, at one instant.
///
/// Frame and units: the device's frame, SI, +z up, away from the surface. Linear and angular
/// velocity are in the same frame; the reference point is the probe's tip.
struct ProbeState {
  std::int64_t time_ns = 0;  ///< monotonic
  glm::dvec3 position_m{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  glm::dvec3 angular_velocity_rad_per_s{0.0};
  std::uint32_t buttons = 0;  ///< bit mask, bit 0 the first button
};

}  // namespace asperity
