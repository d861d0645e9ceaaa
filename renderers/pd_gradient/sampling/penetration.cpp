// Implements the steps of the differences and the force of a penetration depth.

#include "renderers/pd_gradient/sampling/penetration.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "device/refusal.h"

namespace asperity {

void require_sound(const MaximumLaw& law) {
  if (const auto* hard = std::get_if<HardMaximum>(&law)) {
    require_positive("HardMaximum: step_m", hard->step_m);
    return;
  }
  require_positive("SmoothMaximum: tau_m", std::get<SmoothMaximum>(law).tau_m);
}

DifferenceSteps difference_steps(const SamplingGrid& grid, double step_m) noexcept {
  return {.along_m = step_m,
          .tilt_rad = 2.0 * step_m / grid.width_m,
          .turn_rad = 2.0 * step_m / grid.width_m};
}

double spread_of(double here_m, double forth_m, double back_m, double tilt_rad) noexcept {
  return (forth_m + back_m - 2.0 * here_m) / tilt_rad;
}

Penetration flattened(double part, const Penetration& found) noexcept {
  Penetration result = found;
  result.slope = part * found.slope;
  // At a single position the lever is −r × (−h_u, −h_v, 1); the remainder, from the differences, is scaled too.
  const glm::dvec3 rest_m =
      found.lever_m + glm::cross(found.deepest_m, glm::dvec3{-found.slope, 1.0});
  result.lever_m = part * rest_m - glm::cross(found.deepest_m, glm::dvec3{-result.slope, 1.0});
  return result;
}

Penetration pressed_to(double depth_m, const Penetration& found) noexcept {
  Penetration result = flattened(depth_m / found.depth_m, found);
  result.depth_m = depth_m;
  return result;
}

Wrench contact_wrench(const Penetration& penetration, const ContactFrame& frame,
                      double stiffness_N_per_m) noexcept {
  const double force_N = stiffness_N_per_m * std::max(0.0, penetration.depth_m);
  const glm::dvec3 gradient{penetration.slope, -1.0};
  return {.force_N = frame.to_world(-force_N * gradient),
          .torque_N_m = frame.to_world(-force_N * penetration.lever_m)};
}

}  // namespace asperity
