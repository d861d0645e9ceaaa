// Newton's method on the probabilities of being the largest.

#include "analysis/choices/first_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

struct ChoiceProbabilities {
  Eigen::VectorXd p{};
  Eigen::MatrixXd by_mean{};  ///< ∂p_j/∂μ_k
};

// The integrand is smooth and gone at both ends, so the trapezoidal rule converges faster than any
// power of the step: at 1/16 of a standard deviation to rounding.
ChoiceProbabilities probabilities_at(const Eigen::VectorXd& mean) {
  constexpr double kStep = 0.0625;
  constexpr double kRange = 10.0;  // φ(10) is 10⁻²²
  const Eigen::Index count = mean.size();
  ChoiceProbabilities at{Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, count)};
  Eigen::VectorXd density(count);
  Eigen::VectorXd below(count);
  for (double z = mean.minCoeff() - kRange; z <= mean.maxCoeff() + kRange; z += kStep) {
    for (Eigen::Index j = 0; j < count; ++j) {
      density(j) = normal_density(z - mean(j));
      below(j) = normal_below(z - mean(j));
    }
    for (Eigen::Index j = 0; j < count; ++j) {
      const double here = density(j) * kStep;
      double all_below = 1.0;
      for (Eigen::Index k = 0; k < count; ++k) {
        if (k != j) all_below *= below(k);
      }
      at.p(j) += here * all_below;
      for (Eigen::Index k = 0; k < count; ++k) {
        if (k == j) continue;
        double others = 1.0;
        for (Eigen::Index l = 0; l < count; ++l) {
          if (l != j && l != k) others *= below(l);
        }
        const double slope = here * density(k) * others;
        at.by_mean(j, k) -= slope;
        at.by_mean(j, j) += slope;  // moving all means together changes nothing
      }
    }
  }
  return at;
}

}  // namespace

LuceWorths luce_worths(std::span<const std::uint64_t> counts, std::size_t reference) {
  if (reference >= counts.size()) {
    throw std::invalid_argument("reference is " + std::to_string(reference) +
                                "; it must be less than the number of alternatives, " +
                                std::to_string(counts.size()));
  }
  LuceWorths worths{};
  worths.half_added = std::find(counts.begin(), counts.end(), 0U) != counts.end();
  std::vector<double> x(counts.begin(), counts.end());
  if (worths.half_added) {
    for (double& one : x) one += 0.5;
  }
  const double n = std::accumulate(x.begin(), x.end(), 0.0);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const bool other = j != reference;
    worths.share.push_back(x[j] / n);
    worths.log_worth.push_back(other ? std::log(x[j] / x[reference]) : 0.0);
    worths.standard_error.push_back(other ? std::sqrt(1.0 / x[j] + 1.0 / x[reference]) : 0.0);
  }
  return worths;
}

std::vector<double> first_choice_means(std::span<const double> shares) {
  const auto count = static_cast<Eigen::Index>(shares.size());
  if (count < 2)
    throw std::invalid_argument("the number of proportions is " + std::to_string(count) +
                                "; at least 2 alternatives are needed");
  const Eigen::VectorXd goal = Eigen::Map<const Eigen::VectorXd>(shares.data(), count);
  if (!(goal.minCoeff() > 0.0 && std::abs(goal.sum() - 1.0) < 1e-9)) {
    throw std::invalid_argument("the proportions chosen have a minimum of " +
                                number_text(goal.minCoeff()) + " and a sum of " +
                                number_text(goal.sum()) + "; they must be positive and sum to 1");
  }
  // From Luce's scale, whose unit is about π/√6 of ours.
  Eigen::VectorXd mean = goal.array().log() * std::sqrt(6.0) / std::numbers::pi;
  mean.array() -= mean.mean();
  // The last equation, which follows from the others, is replaced by Σμ = 0.
  ChoiceProbabilities at = probabilities_at(mean);
  for (int step = 0; step < 100; ++step) {
    Eigen::VectorXd missing = goal - at.p;
    Eigen::MatrixXd slope = at.by_mean;
    missing(count - 1) = 0.0;
    slope.row(count - 1).setOnes();
    const Eigen::VectorXd move = solution(slope, missing);
    double length = 1.0;
    for (; length > 1e-6; length *= 0.5) {
      const ChoiceProbabilities next = probabilities_at(mean + length * move);
      if ((goal - next.p).norm() <= (goal - at.p).norm() || move.norm() < 1e-12) {
        mean += length * move;
        at = next;
        break;
      }
    }
    if (length <= 1e-6 || move.cwiseAbs().maxCoeff() < 1e-13) break;
  }
  mean.array() -= mean.mean();
  return {mean.begin(), mean.end()};
}

}  // namespace asperity
