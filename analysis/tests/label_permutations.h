// Exchanges the group labels of participants, as a randomisation could have assigned them.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "analysis/numbers/random.h"

namespace asperity {

/// How many participants of one block an exact permutation is run for: 2 704 156 ways to split 24 evenly.
inline constexpr std::size_t kMostPermuted = 24;

/// And how many of the ways stand for all of them where there are more numbers.
inline constexpr std::size_t kRandomSplits = 10000;

struct SplitTest {
  double p = 1.0;  ///< two-sided
  bool exact = true;
};

/// Two groups of participants, those of the first group first.
struct TwoGroups {
  std::size_t first = 0;   ///< participants
  std::size_t second = 0;  ///< participants
  /// The block of each participant, in which the groups were assigned: labels are exchanged only within a block, so that every
  /// block keeps its number of participants of either group. Empty: all are in one.
  std::vector<std::size_t> blocks{};

  std::size_t size() const noexcept { return first + second; }
};

/// The number of ways to exchange the labels.
double label_permutations(const TwoGroups& groups);

/// The smallest p that a permutation of the labels can have, apart from ties: one way in all, or two where exchanging the groups
/// is another way; of random permutations the observed one. 1 for an empty group.
double smallest_p_of_groups(const TwoGroups& groups);

/// p: the proportion of the ways to exchange the labels for which `is_as_far` is true. All ways for up to kMostPermuted
/// participants and wherever blocks leave no more ways than these have at most; otherwise (b + 1)/(B + 1) of B = kRandomSplits
/// random ones, the observed one among them [Davison 1997]. `numbers`: of each participant, all of the same length; `is_as_far`
/// takes their sums over the first group. Errors: std::invalid_argument for an empty group, and for a number of participants or
/// blocks that differs from that of the groups.
///
/// [Davison 1997] Davison, Hinkley: Bootstrap Methods and their Application.
using IsAsFar = std::function<bool(std::span<const double> sums_of_first)>;
SplitTest permute_labels(const TwoGroups& groups, std::span<const std::vector<double>> numbers,
                         const IsAsFar& is_as_far, Random random);

}  // namespace asperity
