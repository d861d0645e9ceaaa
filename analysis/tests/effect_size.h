// Confidence intervals of effect sizes.

#pragma once

#include <optional>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/t_test.h"

namespace asperity {

/// The noncentrality with which a statistic as large as this one would be exceeded, and fallen short
/// of, with probability (1 − confidence)/2 [Steiger 2004]: the confidence interval of the
/// noncentrality. Every effect size below is a monotone function of it. Nothing for a statistic that
/// is not finite, for degrees of freedom that are not positive, and where the distribution cannot be
/// computed (a statistic of many thousands).
///
/// Of F the noncentrality is not negative: a limit is 0 where even λ = 0 makes the statistic too
/// large or too small.
///
/// [Steiger 2004] Steiger: Beyond the F test: effect size confidence intervals and tests of close fit
/// in the analysis of variance and contrast analysis.
std::optional<ConfidenceInterval> noncentrality_interval(const TStatistic& statistic,
                                                         double confidence = 0.95);
std::optional<ConfidenceInterval> noncentrality_interval(const FStatistic& statistic,
                                                         double confidence = 0.95);

/// Of d_z = mean/sd of `n` differences: t = d_z·√n.
std::optional<ConfidenceInterval> standardised_mean_interval(double d, double n,
                                                             double confidence = 0.95);

/// Of d = (mean₁ − mean₂)/pooled sd of the samples: t = d·√(n₁n₂/(n₁ + n₂)), with n₁ + n₂ − 2 degrees of freedom.
/// As d itself it assumes equal variances.
std::optional<ConfidenceInterval> standardised_difference_interval(const WelchT& welch,
                                                                   const TwoSamples& samples,
                                                                   double confidence = 0.95);

/// Limits of g from those of d: g/d = J is the same for both.
std::optional<ConfidenceInterval> bias_corrected(const WelchT& welch,
                                                 const std::optional<ConfidenceInterval>& of_d);

/// Of partial η² = λ/(λ + df₁ + df₂ + 1) [Steiger 2004], λ the noncentrality of F. With degrees of
/// freedom that were corrected for sphericity it is an approximation, as the corrected test is.
std::optional<ConfidenceInterval> partial_eta_interval(const FStatistic& statistic,
                                                       double confidence = 0.95);

/// Generalised η² = SS/(SS + all errors) of the partial one, SS/(SS + own error), where all errors
/// are `errors` times the effect's own [Bakeman 2005]: odds/(odds + errors), odds = η²/(1 − η²).
/// Carries limits of partial η² over, with the ratio of the error strata as observed.
double generalised_eta(double partial_eta, double errors);

/// Of Kendall's W of N rows and K items. The mean rank correlation of two rows, r̄ = (N·W − 1)/(N − 1),
/// is a mean over pairs of rows and unbiased, as W is not (of rows without any agreement it is 1/N on
/// average). The interval is Student's of the jackknife's pseudo-values of artanh r̄, carried over to
/// W = (1 + (N − 1)·r̄)/N, which is not below 0. Nothing for fewer than four rows and where r̄ of all rows,
/// or without one of them, is ±1 or not defined.
std::optional<ConfidenceInterval> concordance_interval(const Eigen::MatrixXd& judgements,
                                                       double confidence = 0.95);

/// The difference of two independent proportions, first minus second, as Cohen's
/// h = 2·asin√p₁ − 2·asin√p₂, whose standard error √(1/n₁ + 1/n₂) does not depend on them
/// [Cohen 1988]. Throws std::invalid_argument as proportion.h does.
///
/// [Cohen 1988] Cohen: Statistical power analysis for the behavioral sciences.
struct ArcsineDifference {
  double h = 0.0;
  ConfidenceInterval interval{};
};
ArcsineDifference cohen_h(const HitCount& first, const HitCount& second, double confidence = 0.95);

}  // namespace asperity
