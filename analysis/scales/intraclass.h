// Reliability of repeated ratings: intraclass correlations.

#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// One of the six intraclass correlations of n targets that k raters (or repetitions) each rated
/// once [Shrout 1979], of a mean square of the targets MSB, within targets MSW, of the raters MSJ and
/// of the rest MSE:
///
///   ICC1  = (MSB − MSW)/(MSB + (k − 1)·MSW)                      each target has other raters
///   ICC2  = (MSB − MSE)/(MSB + (k − 1)·MSE + k·(MSJ − MSE)/n)    agreement; raters are a sample
///   ICC3  = (MSB − MSE)/(MSB + (k − 1)·MSE)                      consistency; these raters alone
///
/// and of the mean of the k ratings ICC1k = (MSB − MSW)/MSB, ICC2k = (MSB − MSE)/(MSB + (MSJ − MSE)/n),
/// ICC3k = (MSB − MSE)/MSB, which is Cronbach's α. F = MSB/MSW with n − 1 and n(k − 1) degrees of freedom,
/// or MSB/MSE with n − 1 and (n − 1)(k − 1), tests that it is 0. The limits are exact but for those of
/// ICC2 and ICC2k, which rest on Satterthwaite's degrees of freedom. ICC2k and
/// its lower limit are −∞ where the estimated variance of the mean of the ratings is not above 0.
///
/// K. O. McGraw, S. P. Wong: Forming inferences about some intraclass correlation coefficients.
/// Psychological Methods 1(1), 30–46, 1996, write ICC(1), ICC(A,1), ICC(C,1), ICC(k), ICC(A,k) and ICC(C,k)
/// for ICC1, ICC2, ICC3, ICC1k, ICC2k and ICC3k. Their limits of ICC(A,1) are those of ICC2, and with
/// ρ_k = k·ρ/(1 + (k − 1)·ρ) their limits of ICC(A,k) are those of ICC2k: both degrees of freedom
/// depend on k·ρ/(1 − ρ) = ρ_k/(1 − ρ_k) alone.
///
/// [Shrout 1979] Shrout, Fleiss: Intraclass correlations: uses in assessing rater reliability.
struct IntraclassCorrelation {
  std::string_view name{};  ///< "ICC1" … "ICC3k"
  double value = 0.0;
  double F = 0.0;  ///< infinite without any error
  double df1 = 1.0;
  double df2 = 1.0;
  double p = 1.0;
  std::optional<ConfidenceInterval> interval{};  ///< nothing without any error, and where F is 0
};

struct Reliability {
  /// ICC1, ICC2, ICC3, ICC1k, ICC2k, ICC3k.
  std::array<IntraclassCorrelation, 6> correlations{};
  double standard_error_of_measurement = 0.0;  ///< √MSE: of one rating, in the ratings' unit
};

/// `ratings`: targets × raters. Nothing where all targets have the same mean and all ratings of a
/// target are equal: there is nothing to be reliable about. Throws std::invalid_argument for fewer
/// than two targets or raters and for a rating that is not finite.
std::optional<Reliability> reliability_of(const Eigen::MatrixXd& ratings, double confidence = 0.95);

}  // namespace asperity
