// The steps of the differences and the force of a penetration depth.

#include "renderers/pd_gradient/penetration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace asperity {
namespace {

void require_positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                "; it has to be positive.");
  }
}

}  // namespace

void require_sound(const MaximumLaw& law) {
  if (const auto* hard = std::get_if<HardMaximum>(&law)) {
    require_positive(hard->step_m, "HardMaximum: step_m");
    return;
  }
  require_positive(std::get<SmoothMaximum>(law).tau_m, "SmoothMaximum: tau_m");
  require_positive(std::get<SmoothMaximum>(law).area_m2, "SmoothMaximum: area_m2");
}

DifferenceSteps difference_steps(const SamplingGrid& grid, double step_m) noexcept {
  return {.along_m = step_m,
          .tilt_rad = 2.0 * step_m / grid.width_m,
          .turn_rad = 2.0 * step_m / grid.width_m};
}

Wrench contact_wrench(const Penetration& penetration, const ContactFrame& frame,
                      double stiffness_N_per_m) noexcept {
  const double force_N = stiffness_N_per_m * std::max(0.0, penetration.depth_m);
  const glm::dvec3 gradient{penetration.slope, -1.0};
  return {.force_N = frame.to_world(-force_N * gradient),
          .torque_N_m = frame.to_world(-force_N * penetration.lever_m)};
}

}  // namespace asperity
