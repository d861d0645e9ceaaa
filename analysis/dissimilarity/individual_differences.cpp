// Alternating least squares of scalar products.

#include "analysis/dissimilarity/individual_differences.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/dense.h"

namespace asperity {
namespace {

constexpr std::size_t kRandomStarts = 10;

/// Of length 1; nothing where all are 0.
std::optional<Eigen::MatrixXd> scalar_products(const Dissimilarities& d) {
  const Eigen::Index m = d.rows();
  const Eigen::MatrixXd centre = Eigen::MatrixXd::Identity(m, m) -
                                 Eigen::MatrixXd::Constant(m, m, 1.0 / static_cast<double>(m));
  Eigen::MatrixXd b = -0.5 * centre * d.cwiseAbs2() * centre;
  b = (0.5 * (b + b.transpose())).eval();
  const double length = b.norm();
  if (!(length > 0.0)) return std::nullopt;
  return b / length;
}

struct ProductFactors {
  Eigen::MatrixXd left{};     ///< X
  Eigen::MatrixXd right{};    ///< Y, equal to X up to scale in the solution
  Eigen::MatrixXd weights{};  ///< raters × R
};

/// The inverse of a positive semidefinite R × R matrix on the space where it has one.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& gram) {
  return gram.completeOrthogonalDecomposition().pseudoInverse();
}

/// min Σ_s |B_s − L·W_s·Rᵀ|² over L: L = (Σ B_s·R·W_s)·((RᵀR)∘(WᵀW))⁻¹, the normal equations of the regression.
Eigen::MatrixXd regressed_side(std::span<const Eigen::MatrixXd> b, const Eigen::MatrixXd& other,
                               const Eigen::MatrixXd& weights) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(other.rows(), other.cols());
  for (std::size_t s = 0; s < b.size(); ++s) {
    sum += b[s] * other * weights.row(static_cast<Eigen::Index>(s)).asDiagonal();
  }
  const Eigen::MatrixXd gram =
      (other.transpose() * other).cwiseProduct(weights.transpose() * weights);
  return sum * inverse_of(gram);
}

/// min over w_s: ((LᵀL)∘(RᵀR))·w_s = diag(Lᵀ·B_s·R).
Eigen::MatrixXd regressed_weights(std::span<const Eigen::MatrixXd> b, const Eigen::MatrixXd& left,
                                  const Eigen::MatrixXd& right) {
  const Eigen::MatrixXd inverse =
      inverse_of((left.transpose() * left).cwiseProduct(right.transpose() * right));
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(b.size()), left.cols());
  for (std::size_t s = 0; s < b.size(); ++s) {
    const Eigen::VectorXd products = (left.transpose() * b[s] * right).diagonal();
    weights.row(static_cast<Eigen::Index>(s)) = inverse * products;
  }
  return weights;
}

double loss_of(std::span<const Eigen::MatrixXd> b, const ProductFactors& factors) {
  double loss = 0.0;
  for (std::size_t s = 0; s < b.size(); ++s) {
    loss += (b[s] - factors.left * factors.weights.row(static_cast<Eigen::Index>(s)).asDiagonal() *
                        factors.right.transpose())
                .squaredNorm();
  }
  return loss;
}

void normalise_columns(Eigen::MatrixXd& side) {
  for (Eigen::Index axis = 0; axis < side.cols(); ++axis) {
    const double length = side.col(axis).norm();
    if (length > 0.0) side.col(axis) /= length;
  }
}

struct Solution {
  ProductFactors factors{};
  double loss = 0.0;
  bool converged = false;
};

Solution solved_from(std::span<const Eigen::MatrixXd> b, Eigen::MatrixXd start) {
  constexpr std::size_t kSteps = 20'000;
  constexpr double kNoChange = 1e-14;
  normalise_columns(start);
  Solution made{.factors = {.left = start, .right = start}};
  ProductFactors& factors = made.factors;
  factors.weights = regressed_weights(b, factors.left, factors.right);
  made.loss = loss_of(b, factors);
  for (std::size_t step = 0; step < kSteps && !made.converged; ++step) {
    factors.left = regressed_side(b, factors.right, factors.weights);
    normalise_columns(factors.left);
    factors.right = regressed_side(b, factors.left, factors.weights);
    normalise_columns(factors.right);
    factors.weights = regressed_weights(b, factors.left, factors.right);
    const double loss = loss_of(b, factors);
    made.converged = std::abs(made.loss - loss) < kNoChange;
    made.loss = loss;
  }
  factors.right = factors.left;
  factors.weights = regressed_weights(b, factors.left, factors.right);
  made.loss = loss_of(b, factors);
  return made;
}

/// Axes by descending weight, the largest coordinate of each positive.
void arrange(ProductFactors& factors) {
  const Eigen::Index axes = factors.left.cols();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(axes));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const Eigen::RowVectorXd size = factors.weights.colwise().squaredNorm();
  std::stable_sort(order.begin(), order.end(),
                   [&size](Eigen::Index a, Eigen::Index b) { return size(a) > size(b); });
  ProductFactors arranged{.left = factors.left, .right = {}, .weights = factors.weights};
  for (Eigen::Index axis = 0; axis < axes; ++axis) {
    const Eigen::Index from = order[static_cast<std::size_t>(axis)];
    arranged.left.col(axis) = factors.left.col(from);
    arranged.weights.col(axis) = factors.weights.col(from);
    Eigen::Index largest = 0;
    arranged.left.col(axis).cwiseAbs().maxCoeff(&largest);
    if (arranged.left(largest, axis) < 0.0) arranged.left.col(axis) *= -1.0;
  }
  factors = std::move(arranged);
}

}  // namespace

std::optional<IndividualDifferences> individual_differences(std::span<const Dissimilarities> raters,
                                                            Eigen::Index dimensions,
                                                            const Random& random) {
  if (raters.size() < 2) {
    throw std::invalid_argument("raters: the number given is " + std::to_string(raters.size()) +
                                "; at least 2 are needed");
  }
  const Eigen::Index m = raters.front().rows();
  std::vector<Eigen::MatrixXd> b{};
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(m, m);
  for (const Dissimilarities& rater : raters) {
    if (rater.rows() != m)
      throw std::invalid_argument("raters: all must have judged the same items");
    classical_scaling(rater, 1);  // refuses impossible dissimilarities
    std::optional<Eigen::MatrixXd> products = scalar_products(rater);
    if (!products) return std::nullopt;
    mean += *products;
    b.push_back(std::move(*products));
  }
  if (dimensions < 1 || dimensions >= m) {
    throw std::invalid_argument("dimensions is " + std::to_string(dimensions) +
                                "; it must be at least 1 and below the number of items, " +
                                std::to_string(m));
  }
  Solution best = solved_from(b, eigen_axes(mean).vectors.rightCols(dimensions));
  for (std::size_t start = 0; start < kRandomStarts; ++start) {
    Random draws = random.split(static_cast<std::uint64_t>(start));
    Eigen::MatrixXd points(m, dimensions);
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index axis = 0; axis < dimensions; ++axis) points(i, axis) = draws.normal();
    }
    points.rowwise() -= points.colwise().mean().eval();
    Solution made = solved_from(b, std::move(points));
    if (made.loss < best.loss - 1e-10) best = std::move(made);
  }
  arrange(best.factors);
  IndividualDifferences answer{.points = best.factors.left,
                               .weights = best.factors.weights,
                               .fit = Eigen::VectorXd(static_cast<Eigen::Index>(b.size())),
                               .converged = best.converged};
  for (std::size_t s = 0; s < b.size(); ++s) {
    const auto row = static_cast<Eigen::Index>(s);
    answer.fit(row) = 1.0 - (b[s] - answer.points * answer.weights.row(row).asDiagonal() *
                                        answer.points.transpose())
                                .squaredNorm();
  }
  answer.total_fit = answer.fit.mean();
  return answer;
}

}  // namespace asperity
