// A grid of starts, BOBYQA from the best of them, and the information by central differences.

#include "analysis/psychometric/detection_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Cholesky>
#include <nlopt.hpp>

#include "analysis/choices/decision_rules.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

/// ln α, ln β, k.
using DetectionParameters = Eigen::Vector3d;

constexpr double kMostCriterion = 8.0;
constexpr double kBeyondDifferences = 100.0;  // α may lie so many times beyond the differences

struct YesCount {
  double x = 0.0;
  double trials = 0.0;
  double yes = 0.0;
};

std::vector<YesCount> counts_by_difference(std::span<const PsychometricBlock> blocks) {
  std::map<double, YesCount> by_x{};
  for (const PsychometricBlock& block : blocks) {
    if (block.hits > block.trials || !std::isfinite(block.x) || block.x < 0.0) {
      throw std::invalid_argument(
          "a block must have at most as many hits as trials, and a finite difference of at least "
          "0");
    }
    if (block.trials == 0) continue;
    YesCount& count = by_x[block.x];
    count.x = block.x;
    count.trials += static_cast<double>(block.trials);
    count.yes += static_cast<double>(block.hits);
  }
  std::vector<YesCount> counts{};
  for (const auto& [x, count] : by_x) counts.push_back(count);
  return counts;
}

/// Differences ascend. A step fits perfectly where no "yes" precedes a "no".
std::optional<ConfidenceInterval> step_between(const std::vector<YesCount>& counts) {
  for (std::size_t i = 1; i < counts.size(); ++i) {
    const bool is_below =
        std::all_of(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(i),
                    [](const YesCount& each) { return each.yes == 0.0; });
    const bool is_above = std::all_of(counts.begin() + static_cast<std::ptrdiff_t>(i), counts.end(),
                                      [](const YesCount& each) { return each.yes == each.trials; });
    if (is_below && is_above)
      return ConfidenceInterval{.low = counts[i - 1].x, .high = counts[i].x};
  }
  return std::nullopt;
}

class DetectionLikelihood final {
 public:
  DetectionLikelihood(std::vector<YesCount> counts, const DetectionModel& model)
      : counts_(std::move(counts)), model_(model) {
    for (const YesCount& count : counts_) coefficients_ += log_choose(count.trials, count.yes);
  }

  const std::vector<YesCount>& counts() const noexcept { return counts_; }
  double lambda() const noexcept { return model_.lambda; }
  DetectionTask task() const noexcept { return model_.task; }
  double coefficients() const noexcept { return coefficients_; }

  DetectionFunction function(const DetectionParameters& at) const {
    return {.task = model_.task,
            .alpha = std::exp(at(0)),
            .beta = std::exp(at(1)),
            .criterion = at(2),
            .lambda = model_.lambda};
  }
  double value(const DetectionParameters& at) const {
    const DetectionFunction f = function(at);
    double sum = 0.0;
    for (const YesCount& count : counts_) sum += of_probability(count, f.value(count.x));
    return sum;
  }
  double saturated() const {
    double sum = 0.0;
    for (const YesCount& count : counts_) sum += of_probability(count, count.yes / count.trials);
    return sum;
  }
  /// The limit of α → ∞: the same probability with and without a difference.
  double constant() const {
    double yes = 0.0;
    double trials = 0.0;
    for (const YesCount& count : counts_) {
      yes += count.yes;
      trials += count.trials;
    }
    double sum = 0.0;
    for (const YesCount& count : counts_) sum += of_probability(count, yes / trials);
    return sum;
  }

 private:
  static double of_probability(const YesCount& count, double p) {
    // 0·ln 0 is 0.
    const double of_yes = count.yes > 0.0 ? count.yes * std::log(p) : 0.0;
    const double no = count.trials - count.yes;
    return of_yes + (no > 0.0 ? no * std::log1p(-p) : 0.0);
  }

  std::vector<YesCount> counts_{};
  DetectionModel model_{};
  double coefficients_ = 0.0;
};

struct DetectionBounds {
  DetectionParameters low{};
  DetectionParameters high{};
};

DetectionBounds bounds_of(const DetectionLikelihood& data) {
  const double smallest = data.counts()[data.counts().front().x == 0.0 ? 1 : 0].x;
  const double largest = data.counts().back().x;
  // A criterion of same–different below 0 would be a probability above 1.
  const double least_criterion = data.task() == DetectionTask::yes_no ? -kMostCriterion : 0.0;
  return {.low = {std::log(smallest / kBeyondDifferences), std::log(kLeastTransducerSlope),
                  least_criterion},
          .high = {std::log(largest * kBeyondDifferences), std::log(kGreatestTransducerSlope),
                   kMostCriterion}};
}

/// The criterion of a proportion of false alarms that is neither 0 nor 1.
double criterion_of(DetectionTask task, double false_alarm) {
  return task == DetectionTask::yes_no ? -normal_quantile(false_alarm)
                                       : same_different_criterion(false_alarm);
}

DetectionParameters start_of(const DetectionLikelihood& data, const DetectionBounds& bounds) {
  const YesCount& noise = data.counts().front();
  const double criterion = criterion_of(data.task(), (noise.yes + 0.5) / (noise.trials + 1.0));
  const double first = std::log(data.counts()[1].x) - 1.0;
  const double last = std::log(data.counts().back().x) + 1.0;
  constexpr int kPositions = 25;
  DetectionParameters best = DetectionParameters::Zero();
  double best_value = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPositions; ++i) {
    for (const double beta : {0.5, 1.0, 2.0, 4.0}) {
      for (const double shift : {-0.3, 0.0, 0.3}) {
        DetectionParameters at{std::lerp(first, last, static_cast<double>(i) / (kPositions - 1)),
                               std::log(beta), criterion + shift};
        at = at.cwiseMax(bounds.low).cwiseMin(bounds.high);
        const double value = data.value(at);
        if (value > best_value) {
          best_value = value;
          best = at;
        }
      }
    }
  }
  return best;
}

DetectionParameters climbed(const DetectionLikelihood& data, const DetectionBounds& bounds) {
  const DetectionParameters start = start_of(data, bounds);
  std::vector<double> point(start.data(), start.data() + start.size());
  nlopt::opt optimizer(nlopt::LN_BOBYQA, static_cast<unsigned>(point.size()));
  optimizer.set_lower_bounds({bounds.low(0), bounds.low(1), bounds.low(2)});
  optimizer.set_upper_bounds({bounds.high(0), bounds.high(1), bounds.high(2)});
  optimizer.set_initial_step({0.1, 0.2, 0.1});
  optimizer.set_max_objective(
      [](const std::vector<double>& x, std::vector<double>&, void* of) {
        return static_cast<const DetectionLikelihood*>(of)->value({x[0], x[1], x[2]});
      },
      const_cast<DetectionLikelihood*>(&data));
  optimizer.set_xtol_abs(1e-9);
  optimizer.set_ftol_abs(1e-11);
  optimizer.set_maxeval(4000);
  double value = 0.0;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::roundoff_limited&) {
    // The point that it reached is as good as the arithmetic permits.
  }
  return {point[0], point[1], point[2]};
}

/// The negative Hessian by central differences.
Eigen::Matrix3d information_at(const DetectionLikelihood& data, const DetectionParameters& at) {
  constexpr double kStep = 1e-3;
  Eigen::Matrix3d information{};
  const auto moved = [&](int i, double by_i, int j, double by_j) {
    DetectionParameters to = at;
    to(i) += by_i * kStep;
    to(j) += by_j * kStep;
    return data.value(to);
  };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      const double second = (moved(i, 1.0, j, 1.0) - moved(i, 1.0, j, -1.0) -
                             moved(i, -1.0, j, 1.0) + moved(i, -1.0, j, -1.0)) /
                            (4.0 * kStep * kStep);
      information(i, j) = information(j, i) = -second;
    }
  }
  return information;
}

DetectionStatus status_of(const std::vector<YesCount>& counts) {
  if (counts.size() < 2 || counts.front().x != 0.0) return DetectionStatus::no_data;
  const auto all = [&counts](const auto& holds) {
    return std::all_of(counts.begin(), counts.end(), holds);
  };
  if (all([](const YesCount& each) { return each.yes == each.trials; })) {
    return DetectionStatus::all_yes;
  }
  if (all([](const YesCount& each) { return each.yes == 0.0; })) return DetectionStatus::all_no;
  if (step_between(counts)) return DetectionStatus::separated;
  return counts.size() < 3 ? DetectionStatus::one_difference : DetectionStatus::ok;
}

}  // namespace

double probability_of_yes(DetectionTask task, double dprime, double criterion) {
  if (task == DetectionTask::yes_no) return normal_below(dprime - criterion);
  return normal_below((dprime - criterion) / std::numbers::sqrt2) +
         normal_below((-dprime - criterion) / std::numbers::sqrt2);
}

double DetectionFunction::dprime(double x) const { return std::pow(x / alpha, beta); }

double DetectionFunction::value(double x) const {
  return lambda + (1.0 - 2.0 * lambda) * probability_of_yes(task, dprime(x), criterion);
}

DetectionFit fit_detection(std::span<const PsychometricBlock> blocks, const DetectionModel& model) {
  if (!(model.lambda >= 0.0 && model.lambda < 0.5)) {
    throw std::invalid_argument("lambda must be at least 0 and below 1/2");
  }
  std::vector<YesCount> counts = counts_by_difference(blocks);
  DetectionFit fit{.status = status_of(counts)};
  if (fit.status == DetectionStatus::separated) fit.bracket = step_between(counts);
  if (fit.status != DetectionStatus::ok) return fit;
  const DetectionLikelihood data(std::move(counts), model);
  const DetectionBounds bounds = bounds_of(data);
  const DetectionParameters at = climbed(data, bounds);
  const double value = data.value(at);
  constexpr double kLeastGain = 1e-6;  // in the log likelihood
  if (value < data.constant() + kLeastGain) {
    fit.status = DetectionStatus::not_increasing;
    return fit;
  }
  fit.function = data.function(at);
  constexpr double kNearBound = 1e-4;
  fit.beta_at_bound = at(1) < bounds.low(1) + kNearBound || at(1) > bounds.high(1) - kNearBound;
  fit.log_likelihood = value + data.coefficients();
  fit.deviance = 2.0 * (data.saturated() - value);
  fit.deviance_df = static_cast<double>(data.counts().size()) - (fit.beta_at_bound ? 2.0 : 3.0);
  if (fit.beta_at_bound) return fit;
  const Eigen::LLT<Eigen::Matrix3d> factors(information_at(data, at));
  if (factors.info() != Eigen::Success) return fit;
  const double error = std::sqrt(factors.solve(Eigen::Matrix3d::Identity())(0, 0));
  const double factor = std::exp(normal_limit(model.confidence) * error);
  if (std::isfinite(factor)) {
    fit.alpha =
        ConfidenceInterval{.low = fit.function.alpha / factor, .high = fit.function.alpha * factor};
  }
  return fit;
}

}  // namespace asperity
