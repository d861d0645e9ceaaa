// d′ and the criterion by z transforms, standard errors by the delta method, log-linear rates (k + ½)/(n + 1).

#include "analysis/choices/signal_detection.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

bool is_extreme(double proportion) { return !(proportion > 0.0 && proportion < 1.0); }

/// The variance of z(p) of p in n trials.
double variance_of_z(double p, double n) {
  const double density = normal_density(normal_quantile(p));
  return p * (1.0 - p) / (n * density * density);
}

void refuse_no_count(const HitCount& count) {
  if (count.trials > 0 && count.hits <= count.trials) return;
  throw std::invalid_argument(
      "a rate needs at least one trial, and at most as many hits as trials");
}

double added(const HitCount& count) {
  refuse_no_count(count);
  return (static_cast<double>(count.hits) + 0.5) / (static_cast<double>(count.trials) + 1.0);
}

}  // namespace

DetectionRates observed_rates(const DetectionCounts& counts) {
  return {.hit = proportion(counts.signal),
          .false_alarm = proportion(counts.noise),
          .signal_trials = static_cast<double>(counts.signal.trials),
          .noise_trials = static_cast<double>(counts.noise.trials)};
}

DetectionRates loglinear_rates(const DetectionCounts& counts) {
  return {.hit = added(counts.signal),
          .false_alarm = added(counts.noise),
          .signal_trials = static_cast<double>(counts.signal.trials) + 1.0,
          .noise_trials = static_cast<double>(counts.noise.trials) + 1.0};
}

std::optional<Sensitivity> yes_no_sensitivity(const DetectionRates& rates) {
  if (is_extreme(rates.hit) || is_extreme(rates.false_alarm)) return std::nullopt;
  const double z_hit = normal_quantile(rates.hit);
  const double z_false = normal_quantile(rates.false_alarm);
  return Sensitivity{
      .dprime = z_hit - z_false,
      .criterion = -0.5 * (z_hit + z_false),
      .standard_error = std::sqrt(variance_of_z(rates.hit, rates.signal_trials) +
                                  variance_of_z(rates.false_alarm, rates.noise_trials))};
}

std::optional<Sensitivity> two_alternative_sensitivity(const DetectionRates& rates) {
  std::optional<Sensitivity> found = yes_no_sensitivity(rates);
  if (!found) return found;
  found->dprime /= std::numbers::sqrt2;
  found->standard_error /= std::numbers::sqrt2;
  return found;
}

}  // namespace asperity
