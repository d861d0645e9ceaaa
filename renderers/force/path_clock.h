// Declares the length of the path of a hand, which does not grow while the hand holds still.

#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "stimuli/properties/parameter.h"

namespace asperity {

/// Measures the length ℓ of a hand's path along a surface.
///
///   ℓ ← ℓ + |p − p_last|,  p_last ← p     if |p_x − p_last,x| or |p_y − p_last,y| exceeds max(2·Δ, 20 µm)
///
/// p the position in the plane [m], Δ the position step of the device [m]. Readings that vary by one step about a place
/// differ by at most two steps along each axis, so ℓ does not grow at rest. The length of a curved path is that of its
/// chords.
///
/// Real-time: no allocation, no exceptions.
class PathClock final {
 public:
  explicit PathClock(double device_step_m) noexcept
      : dead_zone_m_(std::max(2.0 * device_step_m, kLeast_m)) {}

  void reset(const glm::dvec2& at_m) noexcept {
    last_m_ = at_m;
    length_m_ = 0.0;
  }

  /// The length after a motion to `at_m`.
  double advance(const glm::dvec2& at_m) noexcept {
    const glm::dvec2 way_m = at_m - last_m_;
    if (std::max(std::abs(way_m.x), std::abs(way_m.y)) > dead_zone_m_) {
      length_m_ += glm::length(way_m);
      last_m_ = at_m;
    }
    return length_m_;
  }

 private:
  static constexpr double kLeast_m = 20e-6;  // a hand at rest trembles by about this much
  double dead_zone_m_ = kLeast_m;
  glm::dvec2 last_m_{0.0};
  double length_m_ = 0.0;
};

/// Declares `device_step_m`, the position step of the device, which every model with a PathClock has. `condition`: where the
/// parameter applies, such as "Index distance only"; empty: always.
inline Parameter device_step_parameter(const std::string& condition = {}) {
  return {.name = "device_step_m",
          .kind = ParameterKind::number,
          .unit = "m",
          .minimum = 0.0,
          .maximum = 1e-3,
          .choices = {},
          .default_value = 0.0,
          .meaning = (condition.empty() ? "Position" : condition + ": position") +
                     " step of the device; motion of up to two steps, and of up to 20 µm, does "
                     "not lengthen the path"};
}

}  // namespace asperity
