// Likelihoods of a grid of functions; each repetition draws its observer in proportion to the likelihood of the data.

#include "analysis/psychometric/procedure_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

namespace asperity {
namespace {

constexpr std::size_t kThresholds = 101;
constexpr std::size_t kSlopes = 31;
constexpr std::size_t kLapses = 4;
constexpr std::size_t kMostRows = 2000;  // 80 MB
constexpr float kLeastProbabilityOfRow = 1e-30F;
constexpr double kNotMoreLikely = 1e-3;  // sums of floats

std::vector<double> steps_between(double low, double high, std::size_t count, bool in_ratios) {
  if (!(low <= high) || (in_ratios && !(low > 0.0))) {
    throw std::invalid_argument(
        "family: a range is empty, or steps of equal ratio do not begin above 0; every range must "
        "be ascending, and one in equal ratios must begin above 0");
  }
  if (low == high) return {low};
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    values[i] = in_ratios ? low * std::pow(high / low, part) : std::lerp(low, high, part);
  }
  return values;
}

/// What one data set says about the family.
struct FamilyFit {
  double greatest = -std::numeric_limits<double>::infinity();
  std::size_t best = 0;                ///< the most likely function
  std::vector<double> of_threshold{};  ///< the greatest log likelihood with each threshold
  std::vector<double> of_slope{};
};

/// The log likelihoods of all functions of a family, without the binomial coefficients. A row per level and response has
/// ln ψ or ln(1 − ψ) of every function; a data set is a weighted sum of rows.
class FamilyLikelihood final {
 public:
  explicit FamilyLikelihood(const CurveFamily& family)
      : family_(family),
        thresholds_(steps_between(family.thresholds.low, family.thresholds.high, kThresholds,
                                  is_weibull(family.shape))),
        slopes_(steps_between(family.slopes.least, family.slopes.greatest, kSlopes, true)),
        lapses_(steps_between(family.lambda.low, family.lambda.high, kLapses, false)) {
    for (const double threshold : thresholds_) {
      for (const double slope : slopes_) {
        for (const double lapse : lapses_) functions_.push_back(made(threshold, slope, lapse));
      }
    }
    sums_.resize(static_cast<Eigen::Index>(functions_.size()));
  }

  const std::vector<double>& thresholds() const { return thresholds_; }
  const std::vector<double>& slopes() const { return slopes_; }
  const PsychometricFunction& function(std::size_t index) const { return functions_[index]; }
  std::size_t threshold_of(std::size_t index) const {
    return index / (slopes_.size() * lapses_.size());
  }
  std::size_t slope_of(std::size_t index) const { return index / lapses_.size() % slopes_.size(); }

  FamilyFit fit(std::span<const PsychometricBlock> blocks) {
    add_up(blocks);
    FamilyFit fit{};
    fit.of_threshold.assign(thresholds_.size(), fit.greatest);
    fit.of_slope.assign(slopes_.size(), fit.greatest);
    std::size_t index = 0;
    for (double& of_threshold : fit.of_threshold) {
      for (double& of_slope : fit.of_slope) {
        for (std::size_t lapse = 0; lapse < lapses_.size(); ++lapse, ++index) {
          const double value = sums_[static_cast<Eigen::Index>(index)];
          of_threshold = std::max(of_threshold, value);
          of_slope = std::max(of_slope, value);
          if (value <= fit.greatest) continue;
          fit.greatest = value;
          fit.best = index;
        }
      }
    }
    return fit;
  }

  /// The sums of the likelihoods up to each function, relative to the greatest one.
  std::vector<double> cumulated(std::span<const PsychometricBlock> blocks) {
    add_up(blocks);
    const float greatest = sums_.maxCoeff();
    std::vector<double> sums(functions_.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sum += std::exp(static_cast<double>(sums_[static_cast<Eigen::Index>(i)] - greatest));
      sums[i] = sum;
    }
    return sums;
  }

  /// The greatest log likelihood of a constant that a function of the family can have.
  double of_constant(std::span<const PsychometricBlock> blocks) const {
    double trials = 0.0;
    double hits = 0.0;
    for (const PsychometricBlock& block : blocks) {
      trials += static_cast<double>(block.trials);
      hits += hits_of(block);
    }
    const double share = std::clamp(hits / trials, family_.gamma.value_or(family_.lambda.low),
                                    1.0 - family_.lambda.low);
    return (hits > 0.0 ? hits * std::log(share) : 0.0) +
           (hits < trials ? (trials - hits) * std::log(1.0 - share) : 0.0);
  }

 private:
  struct RowOfLevel {
    Eigen::ArrayXf hit{};
    Eigen::ArrayXf miss{};
  };

  PsychometricFunction made(double threshold, double slope, double lapse) const {
    PsychometricFunction f{.shape = family_.shape,
                           .alpha = is_weibull(family_.shape) ? 1.0 : 0.0,
                           .beta = slope,
                           .gamma = family_.gamma.value_or(lapse),
                           .lambda = lapse};
    const double at = f.inverse(family_.performance);
    f.alpha = is_weibull(family_.shape) ? threshold / at : threshold - at;
    return f;
  }

  const RowOfLevel& row(double x) {
    const auto known = rows_.find(x);
    if (known != rows_.end()) return known->second;
    if (rows_.size() >= kMostRows) rows_.clear();
    RowOfLevel made{.hit = Eigen::ArrayXf(sums_.size()), .miss = Eigen::ArrayXf(sums_.size())};
    for (Eigen::Index i = 0; i < sums_.size(); ++i) {
      const double p = functions_[static_cast<std::size_t>(i)].value(x);
      made.hit[i] = std::log(std::max(static_cast<float>(p), kLeastProbabilityOfRow));
      made.miss[i] = std::log(std::max(static_cast<float>(1.0 - p), kLeastProbabilityOfRow));
    }
    return rows_.emplace(x, std::move(made)).first->second;
  }

  void add_up(std::span<const PsychometricBlock> blocks) {
    sums_.setZero();
    for (const PsychometricBlock& block : blocks) {
      const RowOfLevel& of_level = row(block.x);
      if (hits_of(block) > 0.0) sums_ += static_cast<float>(hits_of(block)) * of_level.hit;
      if (misses_of(block) > 0.0) sums_ += static_cast<float>(misses_of(block)) * of_level.miss;
    }
  }

  CurveFamily family_{};
  std::vector<double> thresholds_{};
  std::vector<double> slopes_{};
  std::vector<double> lapses_{};
  std::vector<PsychometricFunction> functions_{};
  std::map<double, RowOfLevel> rows_{};
  Eigen::ArrayXf sums_{};
};

/// Whether a data set has a threshold, as a fit would have one.
bool has_threshold(const FamilyLikelihood& likelihood, const FamilyFit& fit,
                   std::span<const PsychometricBlock> blocks) {
  const double threshold = likelihood.thresholds()[likelihood.threshold_of(fit.best)];
  const auto is_lower = [](const PsychometricBlock& one, const PsychometricBlock& other) {
    return one.x < other.x;
  };
  const auto [low, high] = std::minmax_element(blocks.begin(), blocks.end(), is_lower);
  return fit.greatest > likelihood.of_constant(blocks) + kNotMoreLikely && threshold >= low->x &&
         threshold <= high->x;
}

double critical_value(std::vector<double> statistics, double confidence) {
  std::sort(statistics.begin(), statistics.end());
  const double place = std::ceil(confidence * static_cast<double>(statistics.size() + 1));
  return statistics[std::min(statistics.size(), static_cast<std::size_t>(place)) - 1];
}

/// The outermost values whose statistic is not above the critical one, between the steps by linear interpolation.
ConfidenceInterval interval_not_rejected(const std::vector<double>& values,
                                         const std::vector<double>& log_likelihoods,
                                         double greatest, double critical) {
  const auto statistic = [&](std::size_t i) { return 2.0 * (greatest - log_likelihoods[i]); };
  const auto between = [&](std::size_t inside, std::size_t outside) {
    const double part = (critical - statistic(inside)) / (statistic(outside) - statistic(inside));
    return std::lerp(values[inside], values[outside], part);
  };
  std::size_t first = 0;
  while (statistic(first) > critical) ++first;
  std::size_t last = values.size() - 1;
  while (statistic(last) > critical) --last;
  return {.low = first == 0 ? values.front() : between(first, first - 1),
          .high = last + 1 == values.size() ? values.back() : between(last, last + 1)};
}

}  // namespace

ProcedureBootstrap bootstrap_procedure(std::span<const PsychometricBlock> all,
                                       const ProcedureBootstrapQuestion& question,
                                       const ProcedureRun& run, const Random& of_bootstrap) {
  const CurveFamily& family = question.family;
  const std::vector<PsychometricBlock> blocks = answered_blocks(
      all, {.shape = family.shape, .gamma = family.gamma, .lambda = family.lambda.low});
  if (distinct_levels(blocks, family.shape).size() < 2) {
    throw std::invalid_argument(
        "blocks has fewer than two levels with trials; a threshold needs at least two");
  }
  FamilyLikelihood likelihood(family);
  const FamilyFit own = likelihood.fit(blocks);
  const std::vector<double> cumulated = likelihood.cumulated(blocks);
  ProcedureBootstrap answer{.repetitions = question.repetitions};
  std::vector<double> of_threshold{};
  std::vector<double> of_slope{};
  for (std::size_t i = 0; i < question.repetitions; ++i) {
    const Random of_run = of_bootstrap.split(static_cast<std::uint64_t>(i));
    const double drawn = of_run.split("observer").uniform() * cumulated.back();
    const auto index = static_cast<std::size_t>(
        std::upper_bound(cumulated.begin(), cumulated.end() - 1, drawn) - cumulated.begin());
    const std::vector<PsychometricBlock> repeated = run(likelihood.function(index), of_run);
    if (distinct_levels(repeated, family.shape).size() < 2) {
      ++answer.without;
      continue;
    }
    const FamilyFit fit = likelihood.fit(repeated);
    if (!has_threshold(likelihood, fit, repeated)) {
      ++answer.without;
      continue;
    }
    of_threshold.push_back(2.0 * (fit.greatest - fit.of_threshold[likelihood.threshold_of(index)]));
    of_slope.push_back(2.0 * (fit.greatest - fit.of_slope[likelihood.slope_of(index)]));
  }
  if (of_threshold.empty() || 2 * answer.without > answer.repetitions) return answer;
  answer.threshold = interval_not_rejected(likelihood.thresholds(), own.of_threshold, own.greatest,
                                           critical_value(of_threshold, question.confidence));
  answer.slope = interval_not_rejected(likelihood.slopes(), own.of_slope, own.greatest,
                                       critical_value(of_slope, question.confidence));
  return answer;
}

}  // namespace asperity
