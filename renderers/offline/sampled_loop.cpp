// Implements the closed forms of sampled_loop.h.

#include "renderers/offline/sampled_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

double passive_damping_N_s_per_m(double stiffness_N_per_m, double damper_N_s_per_m,
                                 double period_s) noexcept {
  return 0.5 * stiffness_N_per_m * period_s + std::abs(damper_N_s_per_m);
}

double delayed_damping_N_s_per_m(double stiffness_N_per_m, double damper_N_s_per_m, double lag_s,
                                 double period_s) noexcept {
  return passive_damping_N_s_per_m(stiffness_N_per_m, damper_N_s_per_m, period_s) +
         stiffness_N_per_m * lag_s;
}

double equivalent_spring_N_per_m(double stiffness_N_per_m, double damper_N_s_per_m,
                                 double period_s) noexcept {
  return 2.0 * passive_damping_N_s_per_m(stiffness_N_per_m, damper_N_s_per_m, period_s) / period_s;
}

std::optional<double> stiffest_spring_N_per_m(const MeasuredSprings& device,
                                              double rate_Hz) noexcept {
  std::optional<double> stiffest{};
  if (device.damping_N_s_per_m) stiffest = 2.0 * *device.damping_N_s_per_m * rate_Hz;
  const double share = device.held_at_Hz > 0.0 ? std::min(rate_Hz / device.held_at_Hz, 1.0) : 1.0;
  // Within this fraction of it the stiffest spring of the test was held.
  constexpr double kAllTried = 0.99;
  if (device.held_N_per_m &&
      (share < 1.0 || *device.held_N_per_m < kAllTried * device.stiffest_tried_N_per_m)) {
    const double held_N_per_m = *device.held_N_per_m * share;
    stiffest = std::min(stiffest.value_or(held_N_per_m), held_N_per_m);
  }
  return stiffest;
}

double steepest_damper_N_s_per_m(double moving_mass_kg, double delay_s, double period_s) noexcept {
  const double delay_ticks = delay_s / period_s;
  return 2.0 * moving_mass_kg / period_s *
         std::sin(0.5 * std::numbers::pi / (2.0 * delay_ticks + 1.0));
}

}  // namespace asperity
