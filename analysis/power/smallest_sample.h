// The smallest sample with a wanted power, from the significant ones of simulated studies of several sizes.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The simulated studies of one size.
struct StudiesOfSize {
  int participants = 0;
  HitCount significant{};  ///< of the studies
};

/// Power at one size: the proportion of significant studies, and the same under the assumption that power does not decrease
/// with the size.
struct PowerOfSize {
  int participants = 0;
  double power = 0.0;
  ConfidenceInterval interval{};         ///< `clopper_pearson_interval`: the Monte-Carlo error
  double fitted = 0.0;                   ///< monotone
  ConfidenceInterval fitted_interval{};  ///< both limits monotone
};

/// The monotone fit. `fitted` is `isotonic_regression` of the proportions, weighted by the numbers of studies: the maximum of the
/// binomial likelihood over all nondecreasing powers [Barlow 1972]. It assumes no form of the curve, so that it also holds for a
/// test whose studies give a status instead of a p at some rate (its power does not approach 1), and for the tests of a
/// corrected family.
///
/// The limits are the isotonic regressions of the limits at each size. This operator preserves order (x ≤ y in every place gives
/// x̂ ≤ ŷ) and leaves monotone numbers unchanged. Wherever every interval contains its power, the fitted ones contain it as
/// well, and they always contain the fit. Studies of different sizes need not be independent.
///
/// `studies` by ascending size. Throws std::invalid_argument where they are not, for no size, and for a size without studies.
std::vector<PowerOfSize> monotone_power(std::span<const StudiesOfSize> studies,
                                        double confidence = 0.95);

/// Whether a curve reaches a power within its sizes.
enum class PowerReached {
  within,        ///< between the smallest size and the largest
  at_first,      ///< the smallest size has it already: a smaller one may have it too
  beyond_sizes,  ///< no size has it
};

/// Where the curve reaches the power, as a number of participants that need not be whole.
struct SmallestSample {
  PowerReached reached = PowerReached::beyond_sizes;
  std::optional<double>
      participants{};  ///< none with `beyond_sizes`; the smallest size with `at_first`
  /// Where the upper fitted limit reaches the power, and where the lower one does. An interval without `low` begins at or below
  /// the smallest size; without `high` it ends beyond the largest.
  std::optional<double> low{};
  std::optional<double> high{};
};

/// Between two neighbouring sizes the fit and its limits are linear. The power of a test whose statistic has the mean δ·√n and the
/// standard deviation 1 is Φ(u) with u = δ·√n − z; its second derivative in n, −φ(u)·(δ/(4·n))·(u·δ + 1/√n), is negative for
/// u > −1/(δ·√n): power is concave from about a third on. There the line lies below the curve, by at most h²/8 times the
/// greatest second derivative between sizes at the distance h, so that the sample is not stated too small: for δ = 0.6, h = 5 and a
/// power of 80 % (n = 22) it is stated too large by at most 0.24 participants.
///
/// A limit at one size errs on its side with half of 1 − confidence; between two sizes the limits of both would have to err, so that
/// the interval covers at least the confidence. Of simulated curves of a t test (δ = 0.6, sizes 10, 15, …, 40 of 500 studies each)
/// the 95 % intervals for a power of 80 % contained the true number in 99 % of 4000 where the studies of all sizes were independent,
/// and in 97 % of 1500 where each study contained the participants of the smaller ones.
///
/// `curve`: of `monotone_power`. Throws std::invalid_argument for an empty one and for a power outside (0, 1).
SmallestSample smallest_sample(std::span<const PowerOfSize> curve, double power);

}  // namespace asperity
