// Declares the result of a renderer for one sample.

#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "device/wrench.h"

namespace asperity {

struct RenderedTick {
  Wrench wrench{};
  /// Depth of the probe in the surface, texture included; 0 exactly if they are not in contact.
  double penetration_m = 0.0;
  /// Of a renderer of several surfaces: the number of the one that the probe is on, from 1; 0 elsewhere and for
  /// others.
  std::uint32_t part = 0;
};

/// Whether a number is finite as it is stored: a recording stores it as float, in which a number beyond the greatest float is
/// infinite. False for NaN.
///
/// Real-time: these functions do not allocate, lock or throw.
inline bool is_finite_as_stored(double number) noexcept {
  return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
}
inline bool is_finite_as_stored(const glm::dvec3& v) noexcept {
  return is_finite_as_stored(v.x) && is_finite_as_stored(v.y) && is_finite_as_stored(v.z);
}
inline bool is_finite_as_stored(const RenderedTick& tick) noexcept {
  return is_finite_as_stored(tick.wrench.force_N) && is_finite_as_stored(tick.wrench.torque_N_m) &&
         is_finite_as_stored(tick.penetration_m);
}

}  // namespace asperity
