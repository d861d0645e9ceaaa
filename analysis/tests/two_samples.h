// Tests of two samples that assume no distribution.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"
#include "analysis/tests/label_permutations.h"
#include "analysis/tests/t_test.h"

namespace asperity {

/// Two-sided p of the difference of means by `permute_labels`: of the ways to split the pooled numbers into samples of these
/// sizes those whose means differ by no less than the observed ones (but for rounding). `blocks`: TwoGroups::blocks. Throws
/// std::invalid_argument for an empty sample.
SplitTest permutation_test(const TwoSamples& samples, std::span<const std::size_t> blocks = {},
                           Random random = Random(kSeedOfTests));

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
