// Bootstrap distributions of the threshold of a psychometric function, from given or drawn resamples.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/psychometric/psychometric_fit.h"

namespace asperity {

/// Thresholds of resampled hits. Each row of `resamples` has the hits of the blocks in their order. A
/// resample whose status by `judge` is not ok, or that is not increasing, has no threshold.
struct ThresholdBootstrap {
  std::vector<std::optional<double>> thresholds{};
  std::size_t valid = 0;
  std::size_t slopes_at_bound = 0;                 ///< of the valid ones; they are included
  std::optional<ConfidenceInterval> percentile{};  ///< quantiles of type 7, of one or more
  std::optional<double> standard_error{};          ///< of two or more
};
ThresholdBootstrap bootstrap_threshold(std::span<const PsychometricBlock> blocks,
                                       std::span<const std::vector<std::uint64_t>> resamples,
                                       const PsychometricQuestion& question);

/// Counts drawn from the binomial distributions of a fitted function with a constant seed
/// (`kSeedOfTests`), and fitted again. Their thresholds estimate the sampling distribution where the
/// delta method fails: near bounds, and with few trials. `deviance_p` is the proportion of tables, among
/// the drawn ones and the data, whose deviance is at least that of the data: a test of the fit that
/// does not require many trials per level. Both assume that the hits of a level are binomial.
struct ParametricBootstrap {
  ThresholdBootstrap thresholds{};
  std::optional<double> deviance_p{};  ///< nothing without degrees of freedom of the deviance
};
ParametricBootstrap parametric_bootstrap(std::span<const PsychometricBlock> blocks,
                                         const PsychometricFit& fit,
                                         const PsychometricQuestion& question, std::size_t draws);

}  // namespace asperity
