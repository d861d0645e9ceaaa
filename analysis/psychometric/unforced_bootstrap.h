// Bootstrap intervals of psychometric functions of unforced choices.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

/// Responses at one level to a choice between alternatives with the option "cannot tell".
struct UnforcedBlock {
  double x = 0.0;
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
  std::uint64_t unsure = 0;  ///< "cannot tell"
};

/// The block in which each of these responses counts as the mean of a guess, 1/alternatives of a hit.
PsychometricBlock split_block(const UnforcedBlock& block, std::size_t alternatives);

/// What is resampled of a function: its thresholds at several proportions of hits, and its slope.
struct UnforcedQuestion {
  PsychometricModel model{};
  std::vector<double> performances{};
  double confidence = 0.95;
};

struct UnforcedBootstrap {
  std::size_t draws = 0;
  std::size_t valid = 0;  ///< draws with all thresholds
  /// Percentile intervals over the valid draws; empty for fewer than half of the draws.
  std::vector<std::optional<ConfidenceInterval>> thresholds{};  ///< by performance
  /// Empty also where the slope of more than half of 1 − confidence of these draws is at its bound, which would be the limit.
  std::optional<ConfidenceInterval> beta{};
};

/// Draws the three outcomes of each level from their observed proportions, splits those without a choice and fits the
/// function again. The binomial likelihood of split counts gives intervals that are too wide: a split count varies less than
/// a guess. The seed is constant (`kSeedOfTests`).
///
/// Errors: those of `maximise_psychometric`; std::invalid_argument for 0 alternatives.
UnforcedBootstrap bootstrap_unforced(std::span<const UnforcedBlock> blocks,
                                     std::size_t alternatives, const UnforcedQuestion& question,
                                     std::size_t draws);

}  // namespace asperity
