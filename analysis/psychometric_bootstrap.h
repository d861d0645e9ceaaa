// Thresholds of psychometric functions fitted to resampled counts: given ones, and drawn ones.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/psychometric_fit.h"

namespace asperity {

/// Thresholds of resampled hits. `resamples`: rows with the hits of each block in their order. A
/// resample that `judge` does not find ok, or that is not increasing, has none.
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

/// Counts drawn from the binomial distributions of a fitted function, always the same ones
/// (`kSeedOfTests`), and fitted again. Their thresholds show the sampling of the threshold where the
/// delta method fails: near bounds, and with few trials. `deviance_p` is the proportion of all
/// draws and the data whose deviance is at least that of the data: a test of the fit that does not
/// rest on many trials per level. Both take the hits of a level as binomial.
struct ParametricBootstrap {
  ThresholdBootstrap thresholds{};
  double deviance_p = 1.0;
};
ParametricBootstrap parametric_bootstrap(std::span<const PsychometricBlock> blocks,
                                         const PsychometricFit& fit,
                                         const PsychometricQuestion& question, std::size_t draws);

}  // namespace asperity
