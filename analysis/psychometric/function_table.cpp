// Bayes' rule over a table of function values; with nuisances, the entropy is that of sums over groups of functions.

#include "analysis/psychometric/function_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity {
namespace {

constexpr double kRoundingOfEntropy = 1e-10;

/// x·ln x, in which 0·ln 0 is 0.
Eigen::ArrayXXd times_logarithm(const Eigen::ArrayXXd& values) {
  return values * values.max(std::numeric_limits<double>::min()).log();
}

/// Σ x·ln x.
double sum_of_logarithms(const Eigen::ArrayXd& values) {
  return (values * values.max(std::numeric_limits<double>::min()).log()).sum();
}

void normalise(Eigen::ArrayXd& weights) {
  const double sum = weights.sum();
  if (!(sum > 0.0)) {
    throw std::invalid_argument(
        "no function of the table can give this response; add functions with a lapse rate or a "
        "guess rate above 0");
  }
  weights *= 1.0 / sum;
}

/// −p·ln p − (1 − p)·ln(1 − p).
double binary_entropy(double p) {
  return -sum_of_logarithms(Eigen::Array2d(p, std::max(1.0 - p, 0.0)));
}

}  // namespace

FunctionTable::FunctionTable(std::vector<PsychometricFunction> functions, std::size_t of_group,
                             std::vector<double> levels)
    : functions_(std::move(functions)),
      of_group_(static_cast<Eigen::Index>(of_group)),
      levels_(std::move(levels)) {
  if (functions_.empty() || levels_.empty()) {
    throw std::invalid_argument("functions and levels must not be empty; add at least one of each");
  }
  if (of_group == 0 || functions_.size() % of_group != 0) {
    throw std::invalid_argument("of_group is " + std::to_string(of_group) + ", but " +
                                std::to_string(functions_.size()) +
                                " functions must form whole groups; correct one of the numbers");
  }
  values_.resize(static_cast<Eigen::Index>(functions_.size()),
                 static_cast<Eigen::Index>(levels_.size()));
  for (Eigen::Index level = 0; level < values_.cols(); ++level) {
    const double x = levels_[static_cast<std::size_t>(level)];
    for (Eigen::Index i = 0; i < values_.rows(); ++i) {
      values_(i, level) = functions_[static_cast<std::size_t>(i)].value(x);
    }
  }
  if (of_group_ == 1) own_entropy_ = -times_logarithm(values_) - times_logarithm(1.0 - values_);
}

Eigen::ArrayXd FunctionTable::uniform() const {
  const auto count = static_cast<Eigen::Index>(functions_.size());
  return Eigen::ArrayXd::Constant(count, 1.0 / static_cast<double>(count));
}

void FunctionTable::respond(Eigen::ArrayXd& weights, std::size_t level, bool is_hit) const {
  const auto values = values_.col(static_cast<Eigen::Index>(level));
  if (is_hit) {
    weights *= values;
  } else {
    weights *= 1.0 - values;
  }
  normalise(weights);
}

void FunctionTable::respond_at(Eigen::ArrayXd& weights, double x, bool is_hit) const {
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double hit = functions_[static_cast<std::size_t>(i)].value(x);
    weights[i] *= is_hit ? hit : 1.0 - hit;
  }
  normalise(weights);
}

void FunctionTable::guess(Eigen::ArrayXd& weights, std::size_t level, double chance) const {
  const auto values = values_.col(static_cast<Eigen::Index>(level));
  weights *= values.pow(chance) * (1.0 - values).max(0.0).pow(1.0 - chance);
  normalise(weights);
}

void FunctionTable::guess_at(Eigen::ArrayXd& weights, double x, double chance) const {
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double hit = functions_[static_cast<std::size_t>(i)].value(x);
    weights[i] *= std::pow(hit, chance) * std::pow(std::max(1.0 - hit, 0.0), 1.0 - chance);
  }
  normalise(weights);
}

Eigen::ArrayXd FunctionTable::marginal(const Eigen::ArrayXd& weights) const {
  return Eigen::Map<const Eigen::ArrayXXd>(weights.data(), of_group_, weights.size() / of_group_)
      .colwise()
      .sum();
}

double FunctionTable::entropy(const Eigen::ArrayXd& weights) const {
  return -sum_of_logarithms(marginal(weights));
}

double FunctionTable::expected_by_groups(const Eigen::ArrayXd& weights,
                                         const Eigen::ArrayXd& marginal, Eigen::Index level) const {
  const Eigen::Index groups = weights.size() / of_group_;
  const Eigen::Map<const Eigen::MatrixXd> of_functions(weights.data(), of_group_, groups);
  const Eigen::Map<const Eigen::MatrixXd> values(values_.col(level).data(), of_group_, groups);
  const Eigen::ArrayXd hits = of_functions.cwiseProduct(values).colwise().sum().transpose().array();
  const Eigen::ArrayXd misses = (marginal - hits).max(0.0);
  return -binary_entropy(hits.sum()) - sum_of_logarithms(hits) - sum_of_logarithms(misses);
}

double FunctionTable::expected_by_functions(const Eigen::ArrayXd& weights, double entropy,
                                            Eigen::Index level) const {
  const double hit = weights.matrix().dot(values_.col(level).matrix());
  return entropy - binary_entropy(hit) + weights.matrix().dot(own_entropy_.col(level).matrix());
}

std::vector<double> FunctionTable::expected_entropies(const Eigen::ArrayXd& weights) const {
  std::vector<double> entropies(levels_.size());
  const Eigen::ArrayXd of_groups = marginal(weights);
  const double now = -sum_of_logarithms(of_groups);
  for (std::size_t i = 0; i < entropies.size(); ++i) {
    const auto level = static_cast<Eigen::Index>(i);
    entropies[i] = of_group_ == 1 ? expected_by_functions(weights, now, level)
                                  : expected_by_groups(weights, of_groups, level);
  }
  return entropies;
}

std::size_t place_of_least(std::span<const double> values) {
  const double least = *std::min_element(values.begin(), values.end());
  const auto first = std::find_if(values.begin(), values.end(), [least](double value) {
    return value <= least + kRoundingOfEntropy;
  });
  return static_cast<std::size_t>(first - values.begin());
}

}  // namespace asperity
