// Standard errors and confidence intervals of a fitted psychometric function.

#pragma once

#include <optional>

#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

class PsychometricLikelihood;
struct CurveSolution;

struct PsychometricQuestion {
  PsychometricModel model{};
  double performance = 0.5;  ///< of the threshold
  double confidence = 0.95;
};

struct PsychometricPrecision {
  double alpha_se = 0.0;
  double beta_se = 0.0;
  double threshold_se = 0.0;
  /// threshold ± limit·threshold_se; of a Weibull function, whose levels are above 0, truncated at 0
  ConfidenceInterval threshold{};
};

/// From the observed information I = −∂²ln L/∂θ∂θᵀ of the parameters that are not at a bound: the
/// covariance is I⁻¹, and the variance of a function g of the parameters ∇gᵀ·I⁻¹·∇g (delta method). The
/// limit is that of the normal distribution. Empty where I is not positive definite.
std::optional<PsychometricPrecision> delta_method_precision(const PsychometricLikelihood& data,
                                                            const CurveSolution& solution,
                                                            const PsychometricQuestion& question);

/// The variation of hits relative to the binomial distribution: φ = X²/df.
struct Dispersion {
  double value = 1.0;
  double df = 1.0;  ///< of X²
};

/// `binomial` for hits that vary more than the binomial distribution: standard errors times √max(1, φ),
/// and Student's limit with the degrees of freedom of φ [Finney 1971]. Empty for df ≤ 0.
///
/// [Finney 1971] Finney: Probit Analysis.
std::optional<PsychometricPrecision> overdispersed_precision(const PsychometricPrecision& binomial,
                                                             const PsychometricFunction& f,
                                                             const PsychometricQuestion& question,
                                                             const Dispersion& dispersion);

/// The values of α that a likelihood ratio test does not reject at 1 − confidence, with the other
/// parameters fitted again within their bounds: 2·(max ln L − max ln L(α)) < z², z² being the quantile of
/// χ² with one degree of freedom.
///
/// An end is empty where it does not exist: as α → ±∞ (0 for a weibull) and β → 0 the function
/// approaches constants, and one of them is not rejected either.
struct ProfileInterval {
  std::optional<double> low{};
  std::optional<double> high{};
};
ProfileInterval profile_interval(const PsychometricLikelihood& data, const CurveSolution& solution,
                                 const PsychometricPrecision& precision, double confidence);

}  // namespace asperity
