// Least squares in one pass; likelihood by Fisher's scoring.

#include "analysis/choices/thurstone.h"

#include <algorithm>
#include <cmath>

#include "analysis/choices/comparison_graph.h"
#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

template <class Use>
void for_each_pair(const Comparisons& counts, Use use) {
  for (Eigen::Index i = 0; i < counts.wins.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < counts.wins.rows(); ++j) {
      use(i, j, counts.wins(i, j), counts.wins(i, j) + counts.wins(j, i));
    }
  }
}

double log_likelihood(const Comparisons& counts, const Eigen::VectorXd& scale) {
  double sum = 0.0;
  for_each_pair(counts, [&](Eigen::Index i, Eigen::Index j, double won, double trials) {
    const double z = scale(i) - scale(j);
    if (won > 0.0) sum += won * std::log(normal_below(z));
    if (won < trials) sum += (trials - won) * std::log(normal_below(-z));
  });
  return sum;
}

}  // namespace

std::optional<ThurstoneLeastSquares> thurstone_least_squares(const Comparisons& counts) {
  const Eigen::Index items = counts.wins.rows();
  const auto k = static_cast<double>(items);
  ThurstoneLeastSquares result{.scale = Eigen::VectorXd::Zero(items),
                               .df = (k - 1.0) * (k - 2.0) / 2.0};
  bool complete = true;
  for_each_pair(counts, [&](Eigen::Index i, Eigen::Index j, double won, double trials) {
    complete = complete && trials > 0.0;
    if (!complete) return;
    const double end = 1.0 / (2.0 * trials);
    const double p = std::clamp(won / trials, end, 1.0 - end);
    const double z = normal_quantile(p);
    result.scale(i) += z / k;
    result.scale(j) -= z / k;
    result.clipped += won == 0.0 || won == trials ? 1 : 0;
  });
  if (!complete) return std::nullopt;
  for_each_pair(counts, [&](Eigen::Index i, Eigen::Index j, double won, double trials) {
    const double fitted = normal_below(result.scale(i) - result.scale(j));
    const double apart =
        2.0 * std::asin(std::sqrt(won / trials)) - 2.0 * std::asin(std::sqrt(fitted));
    result.chi_squared += trials * apart * apart;
  });
  return result;
}

std::optional<ThurstoneLikelihood> thurstone_likelihood(const Comparisons& counts) {
  const Eigen::Index items = counts.wins.rows();
  if (items < 2 || !strongly_connected(counts.wins)) return std::nullopt;
  constexpr int kMostSteps = 500;
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(items);
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::VectorXd score = Eigen::VectorXd::Zero(items);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(items, items);
    for_each_pair(counts, [&](Eigen::Index i, Eigen::Index j, double won, double trials) {
      const double z = scale(i) - scale(j);
      const double steepness = normal_density(z) / (normal_below(z) * normal_below(-z));
      const double more = steepness * (won - trials * normal_below(z));
      const double weight = trials * normal_density(z) * steepness;
      score(i) += more;
      score(j) -= more;
      information(i, i) += weight;
      information(j, j) += weight;
      information(i, j) -= weight;
      information(j, i) -= weight;
    });
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(items, items);
    covariance.bottomRightCorner(items - 1, items - 1) =
        SymmetricFactors(information.bottomRightCorner(items - 1, items - 1)).inverse();
    const Eigen::VectorXd move = covariance * score;
    const double far = move.cwiseAbs().maxCoeff();
    if (!std::isfinite(far)) return std::nullopt;
    if (far < 1e-13 * (1.0 + scale.cwiseAbs().maxCoeff())) {
      double largest = 0.0;
      for_each_pair(counts, [&](Eigen::Index, Eigen::Index, double won, double trials) {
        if (won > 0.0) largest += won * std::log(won / trials);
        if (won < trials) largest += (trials - won) * std::log(1.0 - won / trials);
      });
      return ThurstoneLikelihood{.abilities = {.value = scale, .covariance = covariance},
                                 .deviance = 2.0 * (largest - log_likelihood(counts, scale))};
    }
    const double now = log_likelihood(counts, scale);
    double length = 1.0;
    while (length > 1e-9 && !(log_likelihood(counts, scale + length * move) >=
                              now - 1e-12 * (1.0 + std::abs(now)))) {
      length *= 0.5;
    }
    scale += length * move;
  }
  return std::nullopt;
}

}  // namespace asperity
