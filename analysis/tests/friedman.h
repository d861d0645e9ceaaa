// The same items judged by several people: ranks within each of them.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace asperity {

/// The rank of each number, 1 for the smallest; equal numbers share the mean of their ranks.
std::vector<double> midranks(std::span<const double> numbers);

/// Whether K items differ, from the ranks within each of N rows (people, or trials), ties corrected
/// for [Friedman 1937]:
///
///   X² = 12·Σ_j (R_j − N(K + 1)/2)²/(N·K(K + 1) − Σ(t³ − t)/(K − 1)),
///
/// chi-squared with K − 1 degrees of freedom for many rows; R_j is the sum of ranks of item j, t the
/// size of each group of ties. For few rows [Iman 1980] is nearer:
/// F = (N − 1)·X²/(N(K − 1) − X²), with K − 1 and (K − 1)(N − 1) degrees of freedom.
/// W = X²/(N(K − 1)) is Kendall's concordance: 0 for none, 1 for the same order in every row.
///
/// What is not defined is NaN: everything where all rows are tied throughout, and for fewer than two
/// rows, of which none can agree with another. With W = 1, F is infinite.
///
/// [Friedman 1937] Friedman: The use of ranks to avoid the assumption of normality implicit in the
/// analysis of variance. [Iman 1980] Iman, Davenport: Approximations of the critical region of the
/// Friedman statistic.
struct FriedmanTest {
  std::vector<double> mean_rank{};
  double chi_squared = 0.0;
  double df = 0.0;
  double p = 1.0;
  double concordance = 0.0;
  double f = 0.0;
  double f_p = 1.0;
};
/// Throws std::invalid_argument for fewer than two items and for a judgement that is not finite.
FriedmanTest friedman_test(const Eigen::MatrixXd& judgements);

/// Wilcoxon's signed-rank test of paired differences about 0: differences of 0 are dropped,
/// equal sizes share their ranks, and every pattern of signs is equally likely [Wilcoxon 1945]
/// (`sign_flip_test`, with what it says of many).
///
/// [Wilcoxon 1945] Wilcoxon: Individual comparisons by ranking methods.
struct SignedRankTest {
  std::size_t n = 0;           ///< differences that are not 0
  double positive = 0.0;       ///< W⁺, the sum of the ranks of positive differences
  double p = 1.0;              ///< two-sided; 1 without any difference
  bool exact = true;           ///< or of random signs,
  std::size_t drawn = 0;       ///< of so many patterns
  double rank_biserial = 0.0;  ///< (W⁺ − W⁻)/(W⁺ + W⁻); NaN without any difference
};
SignedRankTest signed_rank_test(std::span<const double> differences);

}  // namespace asperity
