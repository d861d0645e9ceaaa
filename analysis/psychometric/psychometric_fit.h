// Fits psychometric functions to counts by maximum likelihood: thresholds and the goodness of fit.

#pragma once

#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"
#include "analysis/psychometric/psychometric_precision.h"

namespace asperity {

/// Whether the maximum of the likelihood exists, or why not. The first reason that applies is reported.
enum class PsychometricStatus {
  ok,
  no_data,
  all_correct,
  all_wrong,
  one_level,        ///< of a weibull, above 0
  too_few_levels,   ///< fewer than free parameters
  separated,        ///< γ = λ = 0, all incorrect below and all correct above: no finite β
  quasi_separated,  ///< the same except for one level with both
  not_increasing    ///< no increasing function has a greater likelihood than every constant
};

struct PsychometricJudgement {
  PsychometricStatus status = PsychometricStatus::ok;
  /// Of (quasi-)separated data: the levels between which the threshold lies.
  std::optional<ConfidenceInterval> bracket{};
};

/// Errors, as of all functions here: std::invalid_argument for more hits than trials, levels that are not
/// finite (or negative for a weibull), and rates outside [0, 1).
PsychometricJudgement judge(std::span<const PsychometricBlock> blocks,
                            const PsychometricModel& model);

struct PsychometricFit {
  PsychometricFunction function{};
  double log_likelihood = 0.0;
  double deviance = 0.0;  ///< 2·(ln L of the saturated model − ln L)
  double deviance_df = 0.0;
  std::optional<double> pearson{};     ///< X²; absent where a fitted probability is 0 or 1
  std::optional<double> deviance_p{};  ///< of χ²; indicative only if trials per level are few
  bool beta_at_bound = false;
  bool lambda_at_bound = false;
  bool gamma_at_bound = false;

  double threshold = 0.0;                            ///< x at the performance of the question
  std::optional<PsychometricPrecision> precision{};  ///< absent if β is at its bound
  /// φ = X²/df, near 1 if hits vary as the binomial distribution predicts; absent where X² or its
  /// degrees of freedom are.
  std::optional<double> dispersion{};
  std::optional<PsychometricPrecision> overdispersed{};  ///< `precision` corrected for φ
  /// If λ is fixed: the fit with λ free between 0 and `greatest_lambda`. An incorrect λ biases α and
  /// the threshold, which no interval here includes.
  struct FreeLapses {
    double lambda = 0.0;
    double alpha = 0.0;
    double threshold = 0.0;
    double likelihood_ratio = 0.0;  ///< 2·(ln L − ln L of the fixed λ)
  };
  std::optional<FreeLapses> free_lapses{};
  std::optional<double> profile_low{};  ///< of α, see `ProfileInterval`; only with `precision`
  std::optional<double> profile_high{};
};

/// Empty if the data do not rise with the level (`not_increasing`), which `judge` cannot detect: then no
/// function has the greatest likelihood. Errors: also std::invalid_argument if the status of `judge` is
/// not ok, or if the model limits the slope.
std::optional<PsychometricFit> fit_psychometric(std::span<const PsychometricBlock> blocks,
                                                const PsychometricQuestion& question);

}  // namespace asperity
