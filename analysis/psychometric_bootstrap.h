// Thresholds of psychometric functions fitted to resampled counts.

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

}  // namespace asperity
