// Tests of two samples that assume no distribution.

#pragma once

#include <cstddef>
#include <optional>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"
#include "analysis/tests/t_test.h"

namespace asperity {

/// How many participants an exact permutation of them is run for: 2 704 156 ways to split 24 evenly.
inline constexpr std::size_t kMostPermuted = 24;

/// And how many of the ways stand for all of them where there are more numbers.
inline constexpr std::size_t kRandomSplits = 10000;

/// Two-sided p of the difference of means: the share of the ways to split the pooled numbers into
/// samples of these sizes whose means differ by no less than the observed ones (but for rounding).
/// Of all ways for up to kMostPermuted numbers; of more the share (b + 1)/(B + 1) of B random ones,
/// the observed one among them [Davison 1997]. Throws std::invalid_argument for an empty sample.
///
/// [Davison 1997] Davison, Hinkley: Bootstrap Methods and their Application.
struct SplitTest {
  double p = 1.0;  ///< two-sided
  bool exact = true;
};
SplitTest permutation_test(const TwoSamples& samples, Random random = Random(kSeedOfTests));

/// How many numbers the exact distribution of ranks is computed for: its cost grows with the fourth
/// power of them, and is a tenth of a second here.
inline constexpr std::size_t kMostRanked = 120;

/// Mann–Whitney: U counts the pairs in which the first sample's number is the greater, ties half.
/// The exact p is so given the ties: from the distribution of the sum of midranks over all splits,
/// those no nearer to its mean than the observed one. `p_normal` takes that distribution for normal,
/// with its variance n₁n₂/(N(N−1))·Σ(R − R̄)²; absent where all numbers are equal. Throws
/// std::invalid_argument for an empty sample.
struct MannWhitney {
  double U = 0.0;
  std::optional<double> p_exact{};   ///< two-sided; absent above kMostRanked numbers
  std::optional<double> p_normal{};  ///< two-sided
};
MannWhitney mann_whitney(const TwoSamples& samples);

}  // namespace asperity
