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
/// differ by at most two steps along each axis, so ℓ does not grow at rest. The length of a curved path is that of its chords.
///
/// The limit of 2·Δ has a margin of 60 nm. Readings are rounded to 24 binary digits for the recording (tick_record.h), by at most
/// 2⁻²⁴·|p|: 30 nm at 0.5 m from the origin. The difference of two readings that are two counts apart exceeds 2·Δ by up to twice
/// as much, and the next greater difference is 3·Δ, far above the margin wherever 2·Δ exceeds 20 µm.
///
/// Rounding makes ℓ slightly too long. If the rounding errors at the two ends of a chord of length c were independent and
/// uniform, those across it would have the variance σ² = 2·Δ²/12 together, and E√(c² + e²) ≈ c + σ²/2c: with the shortest
/// chords, of 3·Δ, by Δ²/(12·c²) ≤ 1/108 of the length. Along a straight line they are not independent. At 45°, with x and y
/// out of step, chords of (3, 2) and (2, 3) counts alternate: 2·√13/(5·√2) − 1 = 2.0 %. Along an axis it is 0; nowhere else
/// between 20 and 200 mm/s was it above 2.1 %. If Δ is stated as 0 and a device has a step of 38 µm,
/// every count ends a chord: at 60 mm/s ℓ grows up to 5 % too fast, and at 20 mm/s by up to 41 %.
///
/// Real-time: no allocation, no exceptions.
class PathClock final {
 public:
  explicit PathClock(double device_step_m) noexcept
      : dead_zone_m_(std::max(2.0 * device_step_m + kRounding_m, kLeast_m)) {}

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
  static constexpr double kRounding_m = 60e-9;  // of the difference of two recorded readings
  static constexpr double kLeast_m = 20e-6;     // a hand at rest trembles by about this much
  double dead_zone_m_ = kLeast_m;
  glm::dvec2 last_m_{0.0};
  double length_m_ = 0.0;
};

/// The parameter of every model with a PathClock.
inline constexpr const char* kDeviceStep = "device_step_m";

/// Whether a model with these complete values measures the path of the hand: with `device_step_m`, and with the index
/// `distance` where there is a choice.
inline bool measures_path(const ParameterValues& values) {
  const auto index = values.find("index");
  return values.contains(kDeviceStep) &&
         (index == values.end() || index->second == ParameterValue(std::string("distance")));
}

/// Declares `device_step_m`, the position step of the device, which every model with a PathClock has. `condition`: where the
/// parameter applies, such as "Index distance only"; empty: always.
inline Parameter device_step_parameter(
    const Phrase& meaning = phrase(
        "Models",
        "Position step of the device; motion of up to two steps, and of up to 20 µm, does not "
        "lengthen the path. A session takes a missing value from its device")) {
  return number_parameter(kDeviceStep, "m", 0.0, 1e-3, 0.0, meaning);
}

}  // namespace asperity
