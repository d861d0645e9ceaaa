// How often each of several alternatives was chosen, against the same chance for each.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// Asymptotic tests of equal shares for n independent choices among K ≥ 2 alternatives. NaN without
/// any choice.
struct UniformTest {
  double pearson = 0.0;  ///< X² = Σ(x_j − n/K)²/(n/K)
  double pearson_p = 1.0;
  double likelihood_ratio = 0.0;  ///< G = 2·Σ x_j·ln(x_j·K/n), an x_j of 0 adding nothing
  double likelihood_ratio_p = 1.0;
  double df = 0.0;       ///< K − 1
  double cohen_w = 0.0;  ///< √(X²/n)
};
UniformTest uniform_test(std::span<const std::uint64_t> counts);

/// Limits of all shares that hold at the same time [Goodman 1965]: the score interval with the
/// quantile A of chi-squared (1 degree of freedom) at 1 − (1 − confidence)/K,
/// (A + 2x ∓ √(A·(A + 4x(n − x)/n)))/(2(n + A)).
///
/// [Goodman 1965] Goodman: On simultaneous confidence intervals for multinomial proportions.
std::vector<ConfidenceInterval> goodman_intervals(std::span<const std::uint64_t> counts,
                                                  double confidence = 0.95);

}  // namespace asperity
