// Implements the depth of a dent at a point.

#include "renderers/elastic/surface_dent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

namespace asperity {

double SurfaceDent::depth_at(const glm::dvec2& at_m) const noexcept {
  constexpr double kHalf = from_centre(kCellsAcross - 1);
  const glm::dvec2 from_m = at_m - centre_m;
  const double farther = std::max(std::abs(from_m.x), std::abs(from_m.y)) / cell_m;
  // The point where the line from the centre leaves the window.
  const double inside = farther > kHalf ? kHalf / farther : 1.0;
  const auto cell_and_part = [&](double part_m) {
    const double at = std::clamp(inside * part_m / cell_m + kHalf, 0.0, 2.0 * kHalf);
    const auto cell = std::min(static_cast<std::size_t>(at), kCellsAcross - 2);
    return std::pair(cell, at - static_cast<double>(cell));
  };
  const auto [column, x] = cell_and_part(from_m.x);
  const auto [row, y] = cell_and_part(from_m.y);
  const double* const low = &depth_m[row * kCellsAcross + column];
  const double* const high = low + kCellsAcross;
  const double at_low = low[0] + x * (low[1] - low[0]);
  const double at_high = high[0] + x * (high[1] - high[0]);
  const double near_m = at_low + y * (at_high - at_low);
  if (inside == 1.0) return near_m;
  const double r_m = glm::length(from_m);
  const double at_border_m = near_m - far_m2 / (inside * r_m);
  return far_m2 / r_m + at_border_m * inside * inside * inside;
}

}  // namespace asperity
