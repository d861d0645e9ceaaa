// Implements coloured noise along the path of a hand.

#include "renderers/force/recursive_noise.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "analysis/signals/autoregression.h"

namespace asperity {

RecursiveNoise::RecursiveNoise(const Settings& settings, const Random& noise)
    : noise_(noise),
      order_(settings.coefficients.size()),
      sd_(settings.sd),
      steps_per_m_(settings.steps_per_m) {
  if (order_ > kMostCoefficients) {
    throw std::invalid_argument(
        "RecursiveNoise::Settings::coefficients has more than 4 entries; give at most 4");
  }
  const std::optional<Predictors> predictors = stationary_predictors(settings.coefficients);
  if (!predictors) {
    throw std::invalid_argument(
        "RecursiveNoise::Settings::coefficients are not those of a stationary process; choose "
        "coefficients whose roots are inside the unit circle");
  }
  std::copy(settings.coefficients.begin(), settings.coefficients.end(), coefficients_.begin());
  gain_ = sd_ * std::sqrt(predictors->error_variance.back());
  for (std::size_t k = 0; k < order_; ++k) {
    std::copy(predictors->coefficients[k].begin(), predictors->coefficients[k].end(),
              predictors_[k].begin());
    predictor_sd_[k] = sd_ * std::sqrt(predictors->error_variance[k]);
  }
}

void RecursiveNoise::reset() noexcept {
  length_m_ = 0.0;
  step_ = 0;
  values_ = {};
  // From y_0 back: a stationary process is the same in both directions.
  Random before = noise_.split("before");
  for (std::size_t k = 0; k < order_; ++k) {
    values_[k] = predictor_sd_[k] * (k == 0 ? noise_.split(0).normal() : before.normal());
    for (std::size_t j = 0; j < k; ++j) values_[k] += predictors_[k][j] * values_[k - 1 - j];
  }
  next_ = node(1);
  low_pass_.reset(0.0);
}

double RecursiveNoise::advance(double length_m) noexcept {
  const auto last = static_cast<std::uint64_t>(length_m * steps_per_m_);
  if (last > step_ + kMostNodesPerTick) step_ = last - kMostNodesPerTick;
  const double way_m = (length_m - length_m_) / ServoLowPass::kStepsPerTick;
  double filtered = 0.0;
  for (int part = 1; part <= ServoLowPass::kStepsPerTick; ++part) {
    filtered = low_pass_.step(at(length_m_ + way_m * part));
  }
  length_m_ = length_m;
  return filtered;
}

double RecursiveNoise::at(double length_m) noexcept {
  const double steps = length_m * steps_per_m_;
  while (static_cast<double>(step_ + 1) <= steps) {
    ++step_;
    for (std::size_t k = kMostCoefficients - 1; k > 0; --k) values_[k] = values_[k - 1];
    values_[0] = next_;
    next_ = node(step_ + 1);
  }
  const double fraction = std::clamp(steps - static_cast<double>(step_), 0.0, 1.0);
  const double from = step_ == 0 ? 0.0 : values_[0];
  return from + fraction * (next_ - from);
}

double RecursiveNoise::node(std::uint64_t j) const noexcept {
  double value = gain_ * noise_.split(j).normal();
  for (std::size_t k = 0; k < order_; ++k) value += coefficients_[k] * values_[k];
  return value;
}

}  // namespace asperity
