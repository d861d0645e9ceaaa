// Implements the gradient from differences of maxima and from weighted means.

#include "renderers/pd_gradient/sampling/found_gradient.h"

#include <algorithm>
#include <numbers>

#include <glm/vec2.hpp>

namespace asperity {

Penetration gradient_of(const ElevenMaxima& found, const DifferenceSteps& steps,
                        const glm::dvec3& deepest_m) noexcept {
  const auto difference = [&found](const float(&moved_m)[2], double step) {
    const double here_m = found.here_m;
    const bool forth = moved_m[0] > kNothing_m;
    const bool back = moved_m[1] > kNothing_m;
    if (forth && back) return (double{moved_m[0]} - double{moved_m[1]}) / (2.0 * step);
    if (forth) return (moved_m[0] - here_m) / step;
    if (back) return (here_m - moved_m[1]) / step;
    return 0.0;
  };
  Penetration result{.depth_m = found.here_m, .deepest_m = deepest_m};
  result.slope = {difference(found.u_m, steps.along_m), difference(found.v_m, steps.along_m)};
  result.lever_m = {difference(found.tilt_u_m, steps.tilt_rad) - deepest_m.z * result.slope.y,
                    difference(found.tilt_v_m, steps.tilt_rad) + deepest_m.z * result.slope.x,
                    difference(found.turn_m, steps.turn_rad)};
  for (const auto& tilted_m : {found.tilt_u_m, found.tilt_v_m}) {
    if (!(std::min(tilted_m[0], tilted_m[1]) > kNothing_m)) continue;
    result.spread_m = std::max(result.spread_m,
                               spread_of(found.here_m, tilted_m[0], tilted_m[1], steps.tilt_rad));
  }
  return result;
}

Penetration gradient_of(const WeightedSums& sums, const SmoothMaximum& law, double cell_m,
                        const glm::dvec3& deepest_m) noexcept {
  const double per_weight = 1.0 / sums.once.weight;
  const double sunk =
      std::numbers::ln2 * sums.by_log2.weight * per_weight;  // (δ − here)/τ, mean of ln w
  const auto mean = [&](double PlaceSums::*of) {
    return per_weight * ((1.0 - sunk) * sums.once.*of + std::numbers::ln2 * sums.by_log2.*of);
  };
  const double per_slope = 1.0 / (kSlope_cells * cell_m);
  Penetration result{.deepest_m = deepest_m};
  result.depth_m = sums.here_m + law.tau_m * sunk;
  result.slope = per_slope * glm::dvec2{mean(&PlaceSums::slope_x_m), mean(&PlaceSums::slope_y_m)};
  result.lever_m = {-cell_m * mean(&PlaceSums::y) - per_slope * mean(&PlaceSums::z_slope_y_m2),
                    cell_m * mean(&PlaceSums::x) + per_slope * mean(&PlaceSums::z_slope_x_m2),
                    mean(&PlaceSums::turn_m) / kSlope_cells};  // both height and distance in cells
  return result;
}

}  // namespace asperity
