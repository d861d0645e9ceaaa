// Implements the closed forms of sampled_loop.h.

#include "renderers/offline/sampled_loop.h"

#include <cmath>
#include <numbers>

namespace asperity {

double passive_damping_N_s_per_m(double stiffness_N_per_m, double damper_N_s_per_m,
                                 double period_s) noexcept {
  return 0.5 * stiffness_N_per_m * period_s + std::abs(damper_N_s_per_m);
}

double steepest_damper_N_s_per_m(double moving_mass_kg, double delay_s, double period_s) noexcept {
  const double delay_ticks = delay_s / period_s;
  return 2.0 * moving_mass_kg / period_s *
         std::sin(0.5 * std::numbers::pi / (2.0 * delay_ticks + 1.0));
}

}  // namespace asperity
