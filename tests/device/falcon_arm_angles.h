// The way back, for tests: the angles and encoder counts of a Falcon's arms where its grip is.

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/vec3.hpp>

namespace asperity::falcon {

/// θ of each arm with the grip at `p`, leg by leg: with K = d + √(b² − V²), the rods' reach in the
/// leg's plane, (U − a cos θ)² + (W − a sin θ)² = K² becomes U cos θ + W sin θ = (U² + W² + a² − K²)/2a.
/// Not a number where a leg does not reach.
inline std::array<double, 3> arm_angles_rad(const glm::dvec3& p) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double phi = (105.0 - 120.0 * static_cast<double>(i)) * kDegree;
    const double u = p.x * std::cos(phi) + p.y * std::sin(phi) - 0.040 + 0.01443;
    const double v = -p.x * std::sin(phi) + p.y * std::cos(phi) + 0.02309 - 0.025;
    const double w = p.z;
    const double k = 0.0225 + std::sqrt(0.1025 * 0.1025 - v * v);
    const double right = (u * u + w * w + 0.060 * 0.060 - k * k) / (2.0 * 0.060);
    angles[i] = std::atan2(w, u) - std::acos(right / std::hypot(u, w));
  }
  return angles;
}

inline std::array<std::int16_t, 3> counts_at(const glm::dvec3& p) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr double kCount_deg = (0.01425 / 0.110) * 360.0 / 1280.0;
  std::array<std::int16_t, 3> counts{};
  const std::array<double, 3> angles = arm_angles_rad(p);
  for (std::size_t i = 0; i < 3; ++i) {
    counts[i] = static_cast<std::int16_t>(std::lround((angles[i] / kDegree - 35.0) / kCount_deg));
  }
  return counts;
}

}  // namespace asperity::falcon
