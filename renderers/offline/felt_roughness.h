// Declares the roughness of an ongoing stroke: the vibration of a held tool under its force.

#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <glm/vec3.hpp>

#include "analysis/signals/roughness.h"
#include "renderers/offline/held_tool.h"

namespace asperity {

/// Simulates the tool and the hand of the offline experiment (drag.h) with a given force, from a record or from a
/// hand's own stroke, instead of a force that is computed at the tool's position:
///
///   m·ẍ = F_x − k_h·x − b_h·ẋ,  the same for y  the tool relative to the moving hand
///   m·z̈ = F_z − P − b_h·ż                       P the normal force of the first sample
///
/// The acceleration is evaluated as in drag.h, over all three directions: minus its mean, over the last `window_s`,
/// without the beginning (beginning_s). The motion of the tool does not change the force, so the results differ from
/// those of a drag; they are suitable for comparing models and strokes with each other.
///
/// Errors: std::invalid_argument in the cases of HeldTool and beginning_s, and for a rate that is not positive.
class FeltRoughness final {
 public:
  struct Judging {
    HandModel hand{};
    double rate_Hz = 1000.0;
    double window_s = 1.0;
    double shortest_s = 0.25;  ///< minimum evaluated duration; shorter: no result
  };
  explicit FeltRoughness(const Judging& judging);

  /// Adds the force on the hand, in newtons, of the next sample.
  void add(const glm::dvec3& force_N);
  std::optional<HeldToolRoughness> roughness() const;
  /// Only that of `roughness`, without the spectra.
  std::optional<double> rms_accel_m_per_s2() const;
  /// The number of evaluated samples.
  std::size_t judged() const noexcept { return accelerations_m_per_s2_.size(); }

 private:
  std::optional<HeldToolRecord> record() const;

  Judging judging_{};
  std::optional<HeldTool> along_{};  ///< x and z, from the first sample on
  HeldTool beside_;                  ///< y, as the x of a second tool
  std::size_t dropped_ = 0;          ///< remaining samples of the beginning
  std::deque<glm::dvec3> accelerations_m_per_s2_{};
};

}  // namespace asperity
