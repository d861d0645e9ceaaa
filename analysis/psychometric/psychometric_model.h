// The counts by level that a psychometric function is fitted to, and the parameters that are fitted.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/psychometric/psychometric_function.h"

namespace asperity {

/// k hits in n trials at one level x. Levels without trials are left out; several blocks may have one level.
struct PsychometricBlock {
  double x = 0.0;
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
  /// The hits that are expected of trials without a choice, if each is a guess; those trials are no `hits`. The likelihood is
  /// then the mean log likelihood of such guesses, whose counts vary less than binomial ones: intervals and tests of the fit
  /// that assume binomial counts do not hold.
  double guessed_hits = 0.0;
};

/// k and n − k with guessed hits.
inline double hits_of(const PsychometricBlock& block) noexcept {
  return static_cast<double>(block.hits) + block.guessed_hits;
}
inline double misses_of(const PsychometricBlock& block) noexcept {
  return static_cast<double>(block.trials - block.hits) - block.guessed_hits;
}

/// Limits of β, for few trials at levels that an adaptive procedure chose: such data hardly determine a slope, and the
/// threshold of a flat function can be anywhere. 0 < least < greatest.
struct SlopeRange {
  double least = 0.0;
  double greatest = 0.0;
};

/// The parameters that are fitted in addition to α and ln β. A rate is fixed at a value, or free: γ in [0, ½], λ in
/// [0, `greatest_lambda`].
struct PsychometricModel {
  PsychometricShape shape = PsychometricShape::logistic;
  std::optional<double> gamma = 0.0;   ///< free where absent
  std::optional<double> lambda = 0.0;  ///< free where absent
  double greatest_lambda = 0.1;
  /// Where absent, the levels limit β (`PsychometricLikelihood`). Only `maximise_psychometric` takes limits.
  std::optional<SlopeRange> slope{};
};

/// Whether the count has the probability 0 under every function of the model: hits at x = 0 of a weibull
/// with γ = 0.
bool is_impossible(const PsychometricBlock& block, const PsychometricModel& model);

/// The blocks with trials. Errors: std::invalid_argument for more hits than trials, levels that are not
/// finite (or negative for a weibull), impossible counts, and rates outside [0, 1).
std::vector<PsychometricBlock> answered_blocks(std::span<const PsychometricBlock> blocks,
                                               const PsychometricModel& model);

/// The distinct levels in ascending order: x, or ln x for a weibull, without x = 0.
std::vector<double> distinct_levels(std::span<const PsychometricBlock> blocks,
                                    PsychometricShape shape);

}  // namespace asperity
