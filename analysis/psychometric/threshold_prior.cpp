// Grid of Weibull functions with nuisances varying fastest; quantiles by bisection of probabilities spread over steps.

#include "analysis/psychometric/threshold_prior.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

bool is_nuisance(std::span<const NuisanceParameter> nuisances, NuisanceParameter parameter) {
  return std::find(nuisances.begin(), nuisances.end(), parameter) != nuisances.end();
}

void refuse_range(const ValueRange& range, const std::string& name, bool may_be_0) {
  const bool is_ascending = range.count == 1 ? range.lowest == range.highest
                                             : range.count > 1 && range.lowest < range.highest;
  if (is_ascending && (may_be_0 ? range.lowest >= 0.0 : range.lowest > 0.0)) return;
  throw std::invalid_argument(name + ": " + std::to_string(range.count) + " values from " +
                              number_text(range.lowest) + " to " + number_text(range.highest) +
                              "; state an ascending range that begins " +
                              (may_be_0 ? "at 0 or above" : "above 0"));
}

double part_of(const ValueRange& range, std::size_t index) {
  return range.count == 1 ? 0.0 : static_cast<double>(index) / static_cast<double>(range.count - 1);
}

double in_ratios(const ValueRange& range, std::size_t index) {
  return range.lowest * std::pow(range.highest / range.lowest, part_of(range, index));
}

double in_steps(const ValueRange& range, std::size_t index) {
  return std::lerp(range.lowest, range.highest, part_of(range, index));
}

/// ln of the ratio of neighbouring thresholds; 0 for a single one.
double step_of_thresholds(const ThresholdPrior& prior) {
  const ValueRange& range = prior.thresholds;
  return range.count == 1
             ? 0.0
             : std::log(range.highest / range.lowest) / static_cast<double>(range.count - 1);
}

PsychometricFunction function_with(double threshold, double slope, double lapse,
                                   const ThresholdPrior& prior) {
  PsychometricFunction f{.shape = PsychometricShape::weibull,
                         .alpha = 1.0,
                         .beta = slope,
                         .gamma = prior.guess_rate,
                         .lambda = lapse};
  f.alpha = threshold / f.inverse(prior.performance);
  return f;
}

/// Probabilities at points of a line, each spread evenly over a step about its point.
class SpreadPoints final {
 public:
  SpreadPoints(Eigen::ArrayXd points, const Eigen::ArrayXd& weights, double step)
      : points_(std::move(points)), weights_(weights), step_(step) {}

  /// By bisection: the distribution function increases.
  double quantile(double probability) const {
    double low = points_.minCoeff() - 0.5 * step_;
    double high = points_.maxCoeff() + 0.5 * step_;
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (below(middle) < probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

 private:
  double below(double at) const {
    if (step_ == 0.0) return (points_ <= at).select(weights_, 0.0).sum();
    return (weights_ * ((at - points_) / step_ + 0.5).max(0.0).min(1.0)).sum();
  }

  Eigen::ArrayXd points_{};
  const Eigen::ArrayXd& weights_;
  double step_ = 0.0;
};

}  // namespace

std::size_t functions_of_group(const ThresholdPrior& prior,
                               std::span<const NuisanceParameter> nuisances) {
  return (is_nuisance(nuisances, NuisanceParameter::slope) ? prior.slopes.count : 1) *
         (is_nuisance(nuisances, NuisanceParameter::lapse) ? prior.lapses.count : 1);
}

std::vector<PsychometricFunction> functions_of(const ThresholdPrior& prior,
                                               std::span<const NuisanceParameter> nuisances) {
  refuse_range(prior.thresholds, "thresholds", false);
  refuse_range(prior.slopes, "slopes", false);
  refuse_range(prior.lapses, "lapses", true);
  if (!(prior.performance > prior.guess_rate && prior.performance < 1.0 - prior.lapses.highest)) {
    throw std::invalid_argument(
        "performance is " + number_text(prior.performance) + "; it must be above the guess rate, " +
        number_text(prior.guess_rate) + ", and below 1 minus the highest lapse rate");
  }
  // Nuisances vary fastest. Of slope and lapse rate, the slope is outside unless it alone is a nuisance.
  const bool slope_is_inside = is_nuisance(nuisances, NuisanceParameter::slope) &&
                               !is_nuisance(nuisances, NuisanceParameter::lapse);
  std::vector<PsychometricFunction> functions{};
  functions.reserve(prior.thresholds.count * prior.slopes.count * prior.lapses.count);
  const std::size_t outer = slope_is_inside ? prior.lapses.count : prior.slopes.count;
  const std::size_t inner = slope_is_inside ? prior.slopes.count : prior.lapses.count;
  for (std::size_t i = 0; i < prior.thresholds.count; ++i) {
    for (std::size_t j = 0; j < outer; ++j) {
      for (std::size_t k = 0; k < inner; ++k) {
        functions.push_back(function_with(in_ratios(prior.thresholds, i),
                                          in_ratios(prior.slopes, slope_is_inside ? k : j),
                                          in_steps(prior.lapses, slope_is_inside ? j : k), prior));
      }
    }
  }
  return functions;
}

std::vector<double> posterior_of(std::span<const PsychometricFunction> functions,
                                 std::span<const PsychometricBlock> blocks) {
  Eigen::ArrayXd logarithms = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(functions.size()));
  const auto answered = answered_blocks(
      blocks, {.shape = functions.front().shape, .gamma = functions.front().gamma, .lambda = 0.0});
  for (Eigen::Index i = 0; i < logarithms.size(); ++i) {
    const PsychometricFunction& f = functions[static_cast<std::size_t>(i)];
    for (const PsychometricBlock& block : answered) {
      const double hit = f.value(block.x);
      const double hits = hits_of(block);
      const double misses = misses_of(block);
      if (hits > 0.0) logarithms[i] += hits * std::log(hit);
      if (misses > 0.0) logarithms[i] += misses * std::log(1.0 - hit);
    }
  }
  const double greatest = logarithms.maxCoeff();
  if (!std::isfinite(greatest)) {
    throw std::invalid_argument(
        "no function can give these responses; add functions with a lapse rate above 0");
  }
  const Eigen::ArrayXd likelihoods = (logarithms - greatest).exp();
  std::vector<double> weights(functions.size());
  Eigen::Map<Eigen::ArrayXd>(weights.data(), likelihoods.size()) = likelihoods / likelihoods.sum();
  return weights;
}

CredibleThreshold credible_threshold(const ThresholdPrior& prior,
                                     std::span<const PsychometricFunction> functions,
                                     std::span<const double> of_functions,
                                     const CredibleQuestion& question) {
  const Eigen::ArrayXd weights = Eigen::Map<const Eigen::ArrayXd>(
      of_functions.data(), static_cast<Eigen::Index>(of_functions.size()));
  // The functions of a threshold follow each other.
  const auto thresholds = static_cast<Eigen::Index>(prior.thresholds.count);
  const Eigen::Index of_threshold = weights.size() / thresholds;
  const Eigen::ArrayXd by_threshold =
      Eigen::Map<const Eigen::ArrayXXd>(weights.data(), of_threshold, thresholds).colwise().sum();
  // At the performance of the prior, the functions of a threshold agree.
  const bool is_of_prior = question.performance == prior.performance;
  const Eigen::ArrayXd& probabilities = is_of_prior ? by_threshold : weights;
  Eigen::ArrayXd places(probabilities.size());
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const auto function = static_cast<std::size_t>(is_of_prior ? i * of_threshold : i);
    places[i] = std::log(functions[function].inverse(question.performance));
  }
  const SpreadPoints posterior(places, probabilities, step_of_thresholds(prior));
  const double tail = 0.5 * (1.0 - question.confidence);
  return {.value = std::exp((probabilities * places).sum()),
          .interval = {.low = std::exp(posterior.quantile(tail)),
                       .high = std::exp(posterior.quantile(1.0 - tail))},
          .at_ends = by_threshold[0] + by_threshold[thresholds - 1]};
}

}  // namespace asperity
