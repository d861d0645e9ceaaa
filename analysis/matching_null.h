// What matching by chance gives: fixed points of random permutations.

#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Somebody who feels nothing assigns m items to m places: every permutation is equally likely, the
/// items that come to stand right are its fixed points.
///
///   P(k of m right) = C(m, k)·D(m−k) / m!,  D(j) = permutations of j without a fixed point.
///
/// For m = 4 these are 9, 8, 6, 0 and 1 of 24: the mean is 1 whatever m, the variance 1 for m ≥ 2,
/// and m − 1 cannot be. So items are not independent, and a binomial with 1/m is the wrong null for
/// their sum.
///
/// Errors: every function throws std::invalid_argument for an m outside 1 to 12 (12! is still exact
/// in a double).

/// 1/m: the chance of one item to be right, and so the expected fraction of items.
double item_chance(std::size_t items);

/// 1/m!: the chance of a whole assignment to be right.
double whole_chance(std::size_t items);

/// P(k) for k = 0 … m, each an exact ratio of integers rounded once.
std::vector<double> fixed_point_distribution(std::size_t items);

/// Counts k with low ≤ k ≤ high.
struct CountInterval {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// The number of items right in all of n independent random assignments of m items: the n-fold
/// convolution of the distribution above, in nonnegative sums, so that tails keep their digits.
class MatchingNull final {
 public:
  struct Design {
    std::size_t items = 0;
    std::size_t assignments = 0;  ///< n, at least 1
  };
  explicit MatchingNull(const Design& design);

  /// P(k) for k = 0 … n·m.
  const std::vector<double>& distribution() const noexcept { return probability_; }

  /// P(at least `right` items right): the one-sided p.
  double upper_tail(std::size_t right) const noexcept;

  /// The narrowest counts that leave at most (1 − confidence)/2 outside on each side. Throws
  /// std::invalid_argument unless 0 < confidence < 1.
  CountInterval central_interval(double confidence) const;

 private:
  std::vector<double> probability_{};
};

}  // namespace asperity
