// Quasi-symmetry by iterative proportional fitting.

#include "analysis/choices/similarity_choice.h"

#include <cmath>
#include <utility>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr int kSweeps = 20000;
constexpr double kStill = 1e-14;  // of all trials
constexpr double kGone = 1e-9;    // of all trials: a cell that the fit empties

double empty_cell_correction(const ConfusionCounts& counts) {
  const Eigen::MatrixXd pairs = counts + counts.transpose();
  return (pairs.array() == 0.0).any() ? 0.5 : 0.0;  // its diagonal is twice that of the counts
}

Eigen::MatrixXd fitted(const Eigen::MatrixXd& counts) {
  const Eigen::ArrayXXd pairs = (counts + counts.transpose()).array();
  const Eigen::ArrayXd rows = counts.rowwise().sum();
  const Eigen::ArrayXd columns = counts.colwise().sum();
  const double still = kStill * counts.sum();
  Eigen::ArrayXXd mu = 0.5 * pairs;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Eigen::ArrayXXd before = mu;
    const Eigen::ArrayXd row_scale = rows / mu.rowwise().sum();
    mu.colwise() *= row_scale;
    const Eigen::ArrayXd column_scale = columns / mu.colwise().sum().transpose();
    mu.rowwise() *= column_scale.transpose();
    mu *= (pairs / (mu + mu.transpose())).eval();
    if ((mu - before).abs().maxCoeff() < still) {
      break;
    }
  }
  return mu.matrix();
}

}  // namespace

SimilarityChoice similarity_choice(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  SimilarityChoice answer{.added = empty_cell_correction(counts)};
  const Eigen::MatrixXd observed = (counts.array() + answer.added).matrix();
  const Eigen::MatrixXd mu = fitted(observed);
  const Eigen::Index m = counts.rows();
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      const double residual = observed(i, j) - mu(i, j);
      answer.X2 += mu(i, j) > 0.0 ? residual * residual / mu(i, j) : 0.0;
      answer.G2 +=
          observed(i, j) > 0.0 ? 2.0 * observed(i, j) * std::log(observed(i, j) / mu(i, j)) : 0.0;
    }
  }
  const auto labels = static_cast<double>(m);
  answer.df = 0.5 * (labels - 1.0) * (labels - 2.0);
  answer.p = upper_tail(ChiSquaredStatistic{.value = answer.G2, .df = answer.df});
  if (mu.minCoeff() < kGone * observed.sum()) {
    return answer;
  }
  SimilarityChoice::Parameters parameters{.similarity = Eigen::MatrixXd::Identity(m, m),
                                          .bias = Eigen::VectorXd::Ones(m)};
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      if (i != j) {
        parameters.similarity(i, j) = std::sqrt(mu(i, j) * mu(j, i) / (mu(i, i) * mu(j, j)));
      }
    }
  }
  // From P(j|i)/P(i|i) = b_j·η_ij/b_i; rows need not be normalised, the row sums cancel.
  for (Eigen::Index j = 1; j < m; ++j) {
    parameters.bias(j) = std::sqrt(mu(0, j) * mu(j, j) / (mu(0, 0) * mu(j, 0)));
  }
  parameters.bias /= parameters.bias.sum();
  answer.parameters = std::move(parameters);
  return answer;
}

}  // namespace asperity
