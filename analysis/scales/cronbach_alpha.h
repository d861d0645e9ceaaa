// Internal consistency of a questionnaire: Cronbach's alpha.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// Cronbach's alpha of k items that n respondents answered, from the variances s_j² of the items and
/// s_T² of the respondents' sums:
///
///   α = k/(k − 1)·(1 − Σ_j s_j²/s_T²) = 1 − MSE/MSB
///
/// with the mean squares of the respondents (MSB) and of the rest (MSE) of the two-way table: the
/// variances of the items add up to MSB + (k − 1)·MSE, and s_T² = k·MSB. It is ICC3k of
/// `intraclass.h` with the respondents as targets and the items as raters. Dimensionless, at most 1,
/// negative where the items contradict each other; the items have one direction, reverse-keyed ones
/// having been recoded.
///
/// The interval is exact for normal scores with equal variances and covariances of the items:
/// (1 − α_true)/(1 − α) has the distribution F with n − 1 and (n − 1)(k − 1) degrees of freedom
/// (L. S. Feldt: The approximate sampling distribution of Kuder–Richardson reliability coefficient
/// twenty. Psychometrika 30(3), 357–370, 1965), so that the limits are 1 − (1 − α)·F_q with its
/// quantiles q = ½ ± ½·confidence.
struct CronbachAlpha {
  std::size_t items = 0;        ///< k
  std::size_t respondents = 0;  ///< n: those with a score for every item
  std::size_t left_out = 0;     ///< respondents with a missing score
  /// Nothing with fewer than two complete respondents, and where all of their sums are equal.
  std::optional<double> value{};
  std::optional<ConfidenceInterval> interval{};  ///< nothing without a value, and where it is 1
};

/// `scores`: a row of k scores per respondent, nothing where one is missing; respondents with a
/// missing score are left out and counted. Throws std::invalid_argument for rows of different
/// lengths, for fewer than two items and for a score that is not finite.
CronbachAlpha cronbach_alpha(std::span<const std::vector<std::optional<double>>> scores,
                             double confidence = 0.95);

/// The percentile interval (quantiles of type 7) of alpha from clusters drawn with replacement, where rows of scores are
/// not independent: participants who rated several textures each. `cluster`: that of each row, numbered from 0. Nothing with
/// fewer than two clusters, and where alpha is defined in less than nine tenths of the draws. Throws
/// std::invalid_argument for a cluster per row too many or too few, and as `cronbach_alpha` does.
struct ClusterResampling {
  std::size_t draws = 2000;
  double confidence = 0.95;
};
std::optional<ConfidenceInterval> cronbach_alpha_interval(
    std::span<const std::vector<std::optional<double>>> scores,
    std::span<const std::size_t> cluster, const ClusterResampling& resampling = {},
    const Random& random = Random(kSeedOfTests));

}  // namespace asperity
