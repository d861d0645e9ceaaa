// What matching by chance gives: fixed points of random permutations.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/exact_null.h"

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

/// One place of a trial: what was felt, and what was assigned to it; nothing where it was left blank.
struct MatchedItem {
  std::size_t felt = 0;
  std::optional<std::size_t> chosen{};
};
using MatchingTrial = std::span<const MatchedItem>;

std::size_t fixed_points(MatchingTrial trial) noexcept;

/// Whether everything felt differs and each of it was assigned once, so that chance is the
/// distribution above.
bool is_permutation(MatchingTrial trial);

/// The number of right items when the answers of this very trial, blanks and repetitions included,
/// are dealt to its places in random order. With f_s places of the felt item s and c_s answers of
/// it, by inclusion and exclusion over marked right places,
///
///   P(k of m) = Σ_{j≥k} (−1)^(j−k)·C(j, k)·N_j·(m − j)!/m!,  Σ_j N_j·x^j = Π_s Σ_i C(f_s, i)·C(c_s, i)·i!·x^i,
///
/// in whole numbers. For a permutation it is `fixed_point_distribution`.
IntegerDistribution chance_matches(MatchingTrial trial);

/// Counts k with low ≤ k ≤ high.
struct CountInterval {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// The narrowest counts that leave at most (1 − confidence)/2 outside on each side. Throws
/// std::invalid_argument unless 0 < confidence < 1.
CountInterval central_interval(const IntegerDistribution& distribution, double confidence);

/// The number of items right in all of n independent random assignments of m items: the n-fold
/// convolution of `fixed_point_distribution`.
class MatchingNull final {
 public:
  struct Design {
    std::size_t items = 0;
    std::size_t assignments = 0;  ///< n, at least 1
  };
  explicit MatchingNull(const Design& design);

  const IntegerDistribution& distribution() const noexcept { return sum_; }

  /// P(at least `right` items right): the one-sided p.
  double upper_tail(std::size_t right) const;

  /// Of the distribution; see the function.
  CountInterval central_interval(double confidence) const;

 private:
  IntegerDistribution sum_{};
};

}  // namespace asperity
