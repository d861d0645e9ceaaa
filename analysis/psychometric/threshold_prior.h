// What is assumed of a threshold before the first response, and what the responses make of it.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

/// `count` values from the lowest to the highest one.
struct ValueRange {
  double lowest = 0.0;
  double highest = 0.0;
  std::size_t count = 0;

  bool operator==(const ValueRange&) const = default;
};

/// The parameters of a Weibull function that can be nuisances when its threshold is estimated.
enum class NuisanceParameter { slope, lapse };

/// A grid of Weibull functions of forced choice with the guess rate γ, all equally probable: every combination of a threshold, the x at which `performance` of the responses are correct, a slope β and a lapse rate λ. Thresholds and slopes
/// are in steps of equal ratio, so that they are uniform on a logarithmic scale; lapse rates are in equal steps.
///
/// A threshold at a stated proportion correct includes the lapses, as thresholds of a study do: α = θ/t(λ)^{1/β}, with
/// t(λ) = −ln(1 − (performance − γ)/(1 − γ − λ)).
struct ThresholdPrior {
  double performance = 0.75;
  ValueRange thresholds{};
  ValueRange slopes{.lowest = 1.0, .highest = 8.0, .count = 8};
  ValueRange lapses{.lowest = 0.0, .highest = 0.06, .count = 4};
  double guess_rate = 0.5;  ///< γ, of the task and not of the participant

  bool operator==(const ThresholdPrior&) const = default;
};

/// The number of functions with each combination of the other parameters.
std::size_t functions_of_group(const ThresholdPrior& prior,
                               std::span<const NuisanceParameter> nuisances);
/// The functions in groups that differ in the nuisance parameters alone, for `FunctionTable`. By threshold first.
///
/// Errors: std::invalid_argument for ranges that are empty or do not begin above 0 (lapse rates: at 0 or above), and a
/// performance that is not between γ and 1 − λ for every λ.
std::vector<PsychometricFunction> functions_of(const ThresholdPrior& prior,
                                               std::span<const NuisanceParameter> nuisances);

/// The probabilities of the functions after all responses. Errors: std::invalid_argument for counts that `answered_blocks`
/// rejects, and where no function can give the responses.
std::vector<double> posterior_of(std::span<const PsychometricFunction> functions,
                                 std::span<const PsychometricBlock> blocks);

struct CredibleThreshold {
  double value = 0.0;             ///< the geometric mean of the posterior distribution
  ConfidenceInterval interval{};  ///< between its quantiles of equal tails
  /// The probability that the threshold is at the lowest or the highest one of the prior: where it is large, the range of
  /// the prior determines the interval.
  double at_ends = 0.0;
};

struct CredibleQuestion {
  double performance = 0.75;
  double confidence = 0.95;
};

/// The threshold at any performance from the probabilities of `functions`. The probability of a function is distributed
/// evenly over the step of thresholds about its own, on the logarithmic scale: quantiles are therefore between the steps.
CredibleThreshold credible_threshold(const ThresholdPrior& prior,
                                     std::span<const PsychometricFunction> functions,
                                     std::span<const double> weights,
                                     const CredibleQuestion& question);

}  // namespace asperity
