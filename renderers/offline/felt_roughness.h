// How rough a stroke is that is felt now: how its force would shake a held tool.

#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <glm/vec3.hpp>

#include "analysis/roughness.h"
#include "renderers/offline/held_tool.h"

namespace asperity {

/// The tool and the hand of the offline experiment (drag.h), with a force that comes from a record or
/// from a hand's own stroke instead of one that is computed where the tool is:
///
///   m·ẍ = F_x − k_h·x − b_h·ẋ,  y likewise       the tool against the hand, which moves along
///   m·z̈ = F_z − P − b_h·ż                       P the normal force of the first sample
///
/// The acceleration is judged as there, over all three directions: less its mean, over the last
/// `window_s`, the beginning (beginning_s) left out. That the tool gives way changes no force here, so
/// its numbers are not those of a drag: they compare models and strokes with each other.
///
/// Errors: std::invalid_argument as HeldTool and beginning_s have them, and for a rate that is not
/// positive.
class FeltRoughness final {
 public:
  struct Judging {
    HandModel hand{};
    double rate_Hz = 1000.0;
    double window_s = 1.0;
    double shortest_s = 0.25;  ///< of what is judged; before, there is no answer
  };
  explicit FeltRoughness(const Judging& judging);

  /// The force on the hand, in newtons, of the next sample.
  void add(const glm::dvec3& force_N);
  std::optional<HeldToolRoughness> roughness() const;
  /// How many samples it is of.
  std::size_t judged() const noexcept { return accelerations_m_per_s2_.size(); }

 private:
  Judging judging_{};
  std::optional<HeldTool> along_{};  ///< x and z, from the first sample on
  HeldTool beside_;                  ///< y, as the other's x
  std::size_t dropped_ = 0;          ///< samples of the beginning that are still to come
  std::deque<glm::dvec3> accelerations_m_per_s2_{};
};

}  // namespace asperity
