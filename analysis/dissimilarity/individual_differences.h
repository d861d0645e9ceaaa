// How much each rater weighs the dimensions of a common configuration: the INDSCAL model.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "analysis/dissimilarity/dissimilarity.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// INDSCAL [Carroll 1970]: every rater s judges by the distances of the same configuration X, whose axes are stretched by
/// the rater's own weights: d_ij,s² = Σ_a w_sa·(x_ia − x_ja)². Double centring turns that into scalar products,
///
///     B_s = −½·J·D_s²·J ≈ X·W_s·Xᵀ,   W_s = diag(w_s1, …, w_sR),
///
/// scaled to Σ b² = 1 for every rater, so that raters who use more of the scale do not count more. The least squares over all
/// raters are found by alternating regressions (CANDECOMP): with Y = X on the right side, each of X, Y and the weights is linear
/// given the other two. B_s is symmetric, and so is the solution.
///
/// Unlike those of other configurations, the axes are unique and may be interpreted: a rotation could not be undone by
/// weights. Weights are estimated by least squares and can be below 0 where a rater's judgements have no relation to an
/// axis.
///
/// [Carroll 1970] Carroll, Chang: Analysis of individual differences in multidimensional scaling via an N-way generalization of
/// “Eckart–Young” decomposition.
struct IndividualDifferences {
  Eigen::MatrixXd
      points{};  ///< m × R, columns with mean 0 and a sum of squares of 1, by descending Σ_s w²
  Eigen::MatrixXd weights{};  ///< raters × R
  Eigen::VectorXd fit{};  ///< per rater: 1 − |B_s − X·W_s·Xᵀ|², of the rater's scalar products
  double total_fit = 0.0;  ///< the mean of `fit`
  bool converged = true;
};

/// Nothing where a rater's dissimilarities are all 0. Throws std::invalid_argument for fewer than two raters, for
/// different numbers of items, for impossible dissimilarities, and for dimensions that are not below the number of items.
std::optional<IndividualDifferences> individual_differences(
    std::span<const Dissimilarities> raters, Eigen::Index dimensions,
    const Random& random = Random(kSeedOfTests));

}  // namespace asperity
