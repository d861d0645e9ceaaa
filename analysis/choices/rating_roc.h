// The receiver operating characteristic (ROC) of confidence ratings: its area, and the normal model by maximum likelihood.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The trials with one rating. Ratings are in ascending order of the confidence that there was a signal.
struct RatingCount {
  std::uint64_t noise = 0;
  std::uint64_t signal = 0;
};

/// One point of the ROC: the proportions of ratings from a category upwards.
struct RocPoint {
  double false_alarm = 0.0;
  double hit = 0.0;
};

/// For each rating but the lowest. Errors, as of all functions here: std::invalid_argument without a trial of both kinds.
std::vector<RocPoint> roc_points(std::span<const RatingCount> ratings);

/// The area under the straight lines through the points, the proportion of pairs of a trial with and one without a signal in
/// which the former has the higher rating, ties half (Mann and Whitney's statistic). It assumes no distribution.
struct RocArea {
  double area = 0.5;
  /// From the variances of each trial's mean over the trials of the other kind [DeLong 1988]; nothing with one trial of a
  /// kind.
  std::optional<double> standard_error{};
  double hanley_error =
      0.0;  ///< from the area alone, for ratings from exponential distributions [Hanley 1982]
};
/// [DeLong 1988] DeLong, DeLong, Clarke-Pearson: Comparing the areas under two or more correlated receiver operating
/// characteristic curves: a nonparametric approach.
/// [Hanley 1982] Hanley, McNeil: The meaning and use of the area under a receiver operating characteristic (ROC) curve.
RocArea roc_area(std::span<const RatingCount> ratings);

/// Impressions are normal: without a signal with mean 0 and standard deviation 1, with a signal with mean μ and standard
/// deviation σ. Rating j is given where the impression is between the criteria c_j and c_{j+1}, so that
///
///   P(rating ≥ j | noise) = Φ(−c_j),  P(rating ≥ j | signal) = Φ((μ − c_j)/σ)
///
/// and the ROC on normal axes is a line of slope 1/σ [Dorfman 1969]. Maximum likelihood; standard errors from the observed
/// information of all parameters, that of σ by σ·SE(ln σ).
///
/// [Dorfman 1969] Dorfman, Alf: Maximum-likelihood estimation of parameters of signal-detection theory and determination of
/// confidence intervals.
struct NormalRoc {
  double mean = 0.0;               ///< μ; d′ where σ = 1
  double deviation = 1.0;          ///< σ, the ratio of the standard deviations
  std::vector<double> criteria{};  ///< c of every rating but the lowest
  double mean_error = 0.0;
  double deviation_error = 0.0;  ///< 0 where σ is fixed
  double log_likelihood = 0.0;   ///< without multinomial coefficients

  /// μ/√(½·(1 + σ²)), the sensitivity in units of the root mean square of both deviations [Simpson 1973].
  ///
  /// [Simpson 1973] Simpson, Fitter: What is the best index of detectability?
  double d_a() const;
  /// Φ(d_a/√2), the area under the fitted ROC.
  double area() const;
};

enum class RocVariance { equal, free };  ///< σ = 1, or fitted

/// Nothing where the likelihood has no finite maximum: trials of both kinds share too few ratings, or σ is free with fewer
/// than three ratings in use. Ratings without any trial may occur; their criterion equals that of the next rating.
std::optional<NormalRoc> fit_roc(std::span<const RatingCount> ratings, RocVariance variance);

/// The greatest log likelihood of any proportions of ratings, without multinomial coefficients.
double saturated_roc(std::span<const RatingCount> ratings);

}  // namespace asperity
