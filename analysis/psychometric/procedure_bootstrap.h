// Intervals of a threshold whose trials a procedure placed by the responses: bootstrap by running the procedure again.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "analysis/numbers/random.h"
#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

/// The functions among which the interval decides: all combinations of values in equal steps of these ranges.
struct CurveFamily {
  PsychometricShape shape = PsychometricShape::weibull;
  std::optional<double> gamma = 0.5;  ///< the guess rate; absent: equal to the lapse rate
  ConfidenceInterval lambda{.low = 0.0, .high = 0.06};
  double performance = 0.75;        ///< at the threshold
  ConfidenceInterval thresholds{};  ///< in steps of equal ratio for a weibull, where low > 0
  SlopeRange slopes{};              ///< of β, in steps of equal ratio
};

/// A data set of an observer: the counts by level after all tracks of the procedure, with their settings and rules for the
/// end. The function draws from streams of `of_run` alone.
using ProcedureRun = std::function<std::vector<PsychometricBlock>(
    const PsychometricFunction& observer, const Random& of_run)>;

struct ProcedureBootstrapQuestion {
  CurveFamily family{};
  double confidence = 0.95;
  std::size_t repetitions = 400;
};

struct ProcedureBootstrap {
  std::size_t repetitions = 0;
  /// Repetitions without a threshold (as a fit has none: no function of the family is more likely than a constant, or the
  /// threshold is outside the presented levels). They do not enter the intervals.
  std::size_t without = 0;
  std::optional<ConfidenceInterval>
      threshold{};  ///< empty where fewer than half of the repetitions have a threshold
  std::optional<ConfidenceInterval> slope{};  ///< of β; the same
};

/// Likelihood-ratio intervals whose critical value is bootstrapped by running the procedure again.
///
/// The interval of the threshold θ contains the values with 2·(max ln L − max ln L(θ)) ≤ c, the other parameters chosen
/// anew for each θ. c is not the quantile of χ², which holds for many trials only: each repetition draws a function from the
/// family with a probability proportional to its likelihood, runs the procedure with an observer of this function, and computes
/// the same statistic at the θ of this function. c is the ⌈confidence·(n + 1)⌉-th of the n statistics in ascending order. The
/// slope in the same way. The placement of the trials by the responses does not change the likelihood, but it makes
/// slopes too steep and thresholds biased; a percentile or delta interval, and observers of the fitted function alone,
/// inherit this bias (docs/procedures.md compares their coverage). An interval ends at the end of the family's
/// range at the latest.
///
/// Deterministic for a stream: repetition i uses `of_bootstrap.split(i)`. Errors: std::invalid_argument for counts that
/// `answered_blocks` rejects, fewer than two levels, and empty ranges.
ProcedureBootstrap bootstrap_procedure(std::span<const PsychometricBlock> blocks,
                                       const ProcedureBootstrapQuestion& question,
                                       const ProcedureRun& run, const Random& of_bootstrap);

}  // namespace asperity
