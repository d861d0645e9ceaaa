// Exact null distributions of whole numbers, and the tests that count them out.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// The probabilities of consecutive whole numbers, beginning with `lowest`. Sums of independent
/// numbers are convolutions in nonnegative terms, so that tails keep their digits.
struct IntegerDistribution {
  std::int64_t lowest = 0;
  std::vector<double> probability{1.0};

  double mean() const;
  double variance() const;
  double at(std::int64_t value) const;          ///< P(X = value)
  double upper_tail(std::int64_t value) const;  ///< P(X ≥ value)
  double lower_tail(std::int64_t value) const;  ///< P(X ≤ value)
  /// P(X = the largest value): no one-sided test of these data can give a smaller p.
  double smallest_upper_tail() const { return probability.back(); }
};
/// What at either end is less probable than 10⁻³⁰⁰ is left out; in sums of more than some ten
/// thousand values, where that would take long, what is less probable than 10⁻⁴⁰.
IntegerDistribution sum_of(const IntegerDistribution& a, const IntegerDistribution& b);
/// Of so many numbers with the same distribution.
IntegerDistribution repeated_sum(const IntegerDistribution& one, std::uint64_t times);
/// Of independent numbers, many of which have the same distribution.
IntegerDistribution sum_of_all(std::span<const IntegerDistribution> numbers);

/// Σ s_i·d_i with every pattern of signs s_i = ±1 equally likely: what differences of one unit each
/// (a participant's count of A minus the count of B) amount to when both labels mean the same.
/// Holds whatever dependence there is within a unit. Differences of 0 say nothing and drop out;
/// without any other, both p are 1.
///
/// Exact as long as it takes less than about a second, else the share of random patterns that are as
/// extreme, the observed one among them.
struct SignFlipTest {
  double two_sided = 1.0;  ///< P(|Σ s_i·d_i| ≥ |Σ d_i|)
  double upper = 1.0;      ///< P(Σ s_i·d_i ≥ Σ d_i)
  double smallest =
      1.0;  ///< two-sided p if all differences had one sign: 2/2^k of k that are not 0
  bool exact = true;
  std::size_t drawn = 0;  ///< random patterns, where it is not exact
};
SignFlipTest sign_flip_test(std::span<const std::int64_t> differences,
                            Random random = Random(kSeedOfTests));

/// A row per unit, a column per label; nonnegative.
using CountMatrix = Eigen::Matrix<std::int64_t, Eigen::Dynamic, Eigen::Dynamic>;

/// P(Σ_j T_j² ≥ the observed one), T_j the total of label j, when within each unit every assignment
/// of its counts to the labels is equally likely. For totals of a fixed sum this is the order of
/// Pearson's X² against equal shares; for rows of zeros and ones that of Cochran's Q.
///
/// Exact as long as it takes less than about a second, else the share of random relabellings that
/// are as extreme, the observed one among them. Throws std::invalid_argument for no label and for a
/// negative count.
struct RelabellingTest {
  double p = 1.0;
  double smallest = 1.0;  ///< p if all units had ordered the labels alike
  bool exact = true;
  std::size_t drawn = 0;  ///< random relabellings, where it is not exact
};
RelabellingTest relabelling_test(const CountMatrix& counts, Random random = Random(kSeedOfTests));

/// Counts x_1 … x_K of n independent choices against the same chance for each alternative: the
/// probability of all counts that are not more probable than these (but for one part in 10⁷), and of
/// all whose Pearson X² is not smaller. The two orders differ; the second is the exact version of
/// the chi-squared test. `counted` is false, and both are 1, where there are more than some
/// million kinds of counts.
struct MultinomialTest {
  double by_probability = 1.0;
  double by_chi_squared = 1.0;
  bool counted = true;
};
MultinomialTest uniform_multinomial_test(std::span<const std::uint64_t> counts);

}  // namespace asperity
