// Exact tests of two samples that assume no distribution.

#pragma once

#include <cstddef>
#include <optional>

#include "analysis/t_test.h"

namespace asperity {

/// How many participants an exact permutation of them is run for: 2 704 156 ways to split 24 evenly.
inline constexpr std::size_t kMostPermuted = 24;

/// Two-sided p of the difference of means: the share of all ways to split the pooled numbers into
/// samples of these sizes whose means differ by no less than the observed ones (but for rounding).
/// Nothing for more than kMostPermuted numbers. Throws std::invalid_argument for an empty sample.
std::optional<double> permutation_test(const TwoSamples& samples);

/// Mann–Whitney: U counts the pairs in which the first sample's number is the greater, ties half.
/// The p is exact given the ties: the distribution of the sum of midranks over all splits, those no
/// nearer to its mean than the observed one. Throws std::invalid_argument for an empty sample.
struct MannWhitney {
  double U = 0.0;
  double p = 1.0;  ///< two-sided
};
MannWhitney mann_whitney(const TwoSamples& samples);

}  // namespace asperity
