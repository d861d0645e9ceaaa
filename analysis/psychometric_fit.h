// Psychometric functions: how performance grows with a stimulus, fitted by maximum likelihood.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/proportion.h"

namespace asperity {

/// ψ(x) = γ + (1 − γ − λ)·F(x; α, β), with
///
///   logistic  F = 1/(1 + e^{−β(x−α)})
///   normal    F = Φ(β(x − α))
///   gumbel    F = 1 − exp(−10^{β(x−α)})   for a logarithmic x
///   weibull   F = 1 − exp(−(x/α)^β)       for x ≥ 0, α > 0
enum class PsychometricShape { logistic, normal, gumbel, weibull };

struct PsychometricFunction {
  PsychometricShape shape = PsychometricShape::logistic;
  double alpha = 0.0;
  double beta = 1.0;
  double gamma = 0.0;   ///< share of right answers without any stimulus
  double lambda = 0.0;  ///< lapses: share of wrong ones with the strongest

  double value(double x) const;
  double slope(double x) const;  ///< dψ/dx
  /// The x of a performance; not finite unless γ < performance < 1 − λ.
  double inverse(double performance) const;
};

/// k right of n trials at one level x. Levels without trials are left out; a level may come twice.
struct PsychometricBlock {
  double x = 0.0;
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
};

/// What is fitted besides α and ln β. A rate is fixed at a value, or free: γ in [0, ½], λ in
/// [0, `greatest_lambda`].
struct PsychometricModel {
  PsychometricShape shape = PsychometricShape::logistic;
  std::optional<double> gamma = 0.0;   ///< free where absent
  std::optional<double> lambda = 0.0;  ///< free where absent
  double greatest_lambda = 0.1;
};

/// Why data have a fit or none, in this order.
enum class PsychometricStatus {
  ok,
  no_data,
  all_correct,
  all_wrong,
  one_level,       ///< of a weibull, above 0
  separated,       ///< γ = λ = 0, and all wrong below, all right above: the slope has no maximum
  quasi_separated  ///< the same but for one level with both
};

struct PsychometricJudgement {
  PsychometricStatus status = PsychometricStatus::ok;
  /// Where it is (quasi-)separated: between what the threshold lies.
  std::optional<ConfidenceInterval> bracket{};
};

/// Throws std::invalid_argument, as all of these do, for more hits than trials, levels that are not
/// finite (or negative for a weibull), and rates outside [0, 1).
PsychometricJudgement judge(std::span<const PsychometricBlock> blocks,
                            const PsychometricModel& model);

/// The greatest likelihood over all starts of a grid: BOBYQA from the best of them, then Newton with
/// exact derivatives; a parameter within reach of its bound is set on it where that is as likely.
///
/// The slope has a bound as well, because few levels cannot tell a steep function from a step: F may
/// not rise from 0.01 to 0.99 within less than the smallest gap between neighbouring levels (of ln x
/// for a weibull). The likelihood includes the binomial coefficients.
struct PsychometricFit {
  PsychometricFunction function{};
  double log_likelihood = 0.0;
  double deviance = 0.0;
  double deviance_df = 0.0;
  std::optional<double> pearson{};     ///< absent where a fitted probability is 0 or 1
  std::optional<double> deviance_p{};  ///< of χ²; indicative only, for few trials per level
  bool beta_at_bound = false;
  bool lambda_at_bound = false;
  bool gamma_at_bound = false;

  double threshold = 0.0;  ///< x at the asked performance
  /// From the observed information of the parameters that are not at a bound; absent where β is, or
  /// where the information is singular.
  struct Precision {
    double alpha_se = 0.0;
    double beta_se = 0.0;
    double threshold_se = 0.0;
    ConfidenceInterval threshold{};  ///< ± z standard errors
  };
  std::optional<Precision> precision{};
  /// The α that the likelihood ratio does not reject, the other parameters fitted anew within their
  /// bounds; an end is absent where it lies beyond 12 standard errors. Only with `precision`.
  std::optional<double> profile_low{};
  std::optional<double> profile_high{};
};

struct PsychometricQuestion {
  PsychometricModel model{};
  double performance = 0.5;  ///< of the threshold
  double confidence = 0.95;
};

/// Throws std::invalid_argument where `judge` does not say ok.
PsychometricFit fit_psychometric(std::span<const PsychometricBlock> blocks,
                                 const PsychometricQuestion& question);

/// As far as resampling needs it: the function alone, whatever `judge` says as long as the slope has
/// a bound (at least two levels).
struct PsychometricMaximum {
  PsychometricFunction function{};
  double log_likelihood = 0.0;
  bool beta_at_bound = false;
};
PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model);

/// Thresholds of resampled hits. `resamples`: rows with the hits of each block in their order. A
/// resample that `judge` does not find ok has none.
struct ThresholdBootstrap {
  std::vector<std::optional<double>> thresholds{};
  std::size_t valid = 0;
  std::size_t slopes_at_bound = 0;                 ///< kept
  std::optional<ConfidenceInterval> percentile{};  ///< quantiles of type 7; with a valid one
  std::optional<double> standard_error{};          ///< with two
};
ThresholdBootstrap bootstrap_threshold(std::span<const PsychometricBlock> blocks,
                                       std::span<const std::vector<std::uint64_t>> resamples,
                                       const PsychometricQuestion& question);

}  // namespace asperity
