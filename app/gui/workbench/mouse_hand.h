// A hand that follows the mouse over a surface.

#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "device/probe_state.h"
#include "renderers/proxy/body_surface.h"

namespace asperity {

/// Mouse positions, which come in steps of pixels and milliseconds, as the smooth path of a probe at
/// 1 kHz, pressed to a constant depth below the plane, or below the body:
///
///     x″ = ω²(target − x) − 2ω x′,   ω = 80 rad/s, critically damped; z = z₀(x, y) − depth
///
/// so that the probe trails the mouse by 25 ms. z₀ is the upper side of the body, 0 without one; where no part of the body
/// lies below, z stays as it was. On a side that is inclined by θ the probe is depth·cos θ inside the body. The path
/// depends on the body, the targets and the times alone.
///
/// Frame and units: that of a HeightField; metres, seconds; time from the beginning of the stroke.
class MouseHand final {
 public:
  explicit MouseHand(double depth_m, std::shared_ptr<const BodySurface> body = nullptr)
      : depth_m_(depth_m), body_(std::move(body)) {}

  /// Touches down at rest.
  void begin(const glm::dvec2& at_m);
  void aim(const glm::dvec2& at_m) { target_m_ = at_m; }
  /// The samples after the last ones until this many nanoseconds from the beginning, 0 included.
  std::vector<ProbeState> advance(std::int64_t until_ns);

 private:
  void follow_body();

  double depth_m_ = 0.0;
  std::shared_ptr<const BodySurface> body_{};
  double level_m_ = 0.0;  ///< of the surface under the probe
  glm::dvec2 target_m_{};
  glm::dvec2 at_m_{};
  glm::dvec2 velocity_m_per_s_{};
  std::int64_t next_ns_ = 0;
};

}  // namespace asperity
