// Declares the interface of a tip with a size that touches a body, where several charts of the texture meet.

#pragma once

#include <cstddef>
#include <span>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace asperity {

/// One of the charts at a place of a body (point_on_body.h).
struct ChartOfTip {
  glm::dvec2 texture_m{0.0};  ///< the place, in the coordinates of the chart
  glm::dmat2 turn{1.0};       ///< of a vector in the axes of the probe into those of the chart
  double weight = 1.0;        ///< the weights of all charts have the sum 1
};

/// Implemented by a renderer whose contact extends over an area. It computes one contact for all charts, with the weighted mean
/// of their reliefs as its relief: the state of the contact then does not depend on which charts it lies in.
class TipOnCharts {
 public:
  static constexpr std::size_t kMostCharts = 3;

  virtual ~TipOnCharts() = default;
  TipOnCharts(const TipOnCharts&) = delete;
  TipOnCharts& operator=(const TipOnCharts&) = delete;

  /// The charts of the next `reset` or `tick`, at most kMostCharts; the position of the probe then only gives its motion and its
  /// height. Real-time: no allocation, no exceptions.
  virtual void touch(std::span<const ChartOfTip> charts) noexcept = 0;

 protected:
  TipOnCharts() = default;
};

}  // namespace asperity
