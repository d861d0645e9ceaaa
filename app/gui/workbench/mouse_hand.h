// A hand that follows the mouse over a surface.

#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "device/probe_state.h"

namespace asperity {

/// Mouse positions, which come in steps of pixels and milliseconds, as the smooth path of a probe at
/// 1 kHz, pressed to a constant depth below the plane:
///
///     x″ = ω²(target − x) − 2ω x′,   ω = 80 rad/s, critically damped; z = −depth
///
/// so that the probe trails the mouse by 25 ms. The path depends on the targets and times alone.
///
/// Frame and units: that of a HeightField; metres, seconds; time from the beginning of the stroke.
class MouseHand final {
 public:
  explicit MouseHand(double depth_m) : depth_m_(depth_m) {}

  /// Touches down at rest.
  void begin(const glm::dvec2& at_m);
  void aim(const glm::dvec2& at_m) { target_m_ = at_m; }
  /// The samples after the last ones until this many nanoseconds from the beginning, 0 included.
  std::vector<ProbeState> advance(std::int64_t until_ns);

 private:
  double depth_m_ = 0.0;
  glm::dvec2 target_m_{};
  glm::dvec2 at_m_{};
  glm::dvec2 velocity_m_per_s_{};
  std::int64_t next_ns_ = 0;
};

}  // namespace asperity
