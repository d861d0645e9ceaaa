// A track whose levels are those from which the most is expected about a threshold: the common part of psi and QUEST+.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/psychometric/threshold_prior.h"
#include "protocols/procedures/level_answer.h"
#include "protocols/procedures/level_grid.h"

namespace asperity {

/// The end of a track by the precision of its threshold: after the first answer with which all of these hold. The counts
/// prevent an end by chance after a few answers of one kind.
struct IntervalRule {
  /// The upper end of the 95 % credible interval of the threshold is at most this many times the lower end.
  double ratio = 0.0;
  std::size_t minimum_trials = 1;   ///< answers
  std::size_t minimum_of_each = 1;  ///< correct answers, and incorrect ones

  bool operator==(const IntervalRule&) const = default;
};
inline constexpr double kConfidenceOfIntervalRule = 0.95;

/// When a track ends: at the first rule that applies. `trials` is required as the upper limit.
struct PosteriorStop {
  std::size_t trials = 0;  ///< answers; 0 is a problem
  std::optional<IntervalRule> interval{};

  bool operator==(const PosteriorStop&) const = default;
};

/// The functions of the prior are functions of x = |level − origin|, the difference from the standard in the unit of the
/// levels, and so are its thresholds.
struct PosteriorTrack {
  LevelGrid grid{};
  double origin = 0.0;  ///< the level of the standard
  ThresholdPrior prior{};
  PosteriorStop stop{};

  bool operator==(const PosteriorTrack&) const = default;
};

/// Of `Procedure::simulated_tracks`: a track of 60 trials takes some 10 ms.
inline constexpr std::size_t kSimulatedPosteriorTracks = 40;

/// The thresholds where none are stated: from the smallest difference above 0 to the greatest one of the grid.
ValueRange thresholds_within(const LevelGrid& grid, double origin);

/// Reports the problems of a track under the settings `stop.…`, `grid.…`, `prior.threshold`, `prior.slope`, `prior.lapse` and
/// `target`.
void check_posterior_track(const PosteriorTrack& track, ProcedureProblems& problems);

/// The level with the least expected entropy (`FunctionTable`) after the answers at the levels that were *delivered*: a
/// delivered level that is not one of the grid has its own likelihood. The first level is that of the prior.
///
/// An unsure answer has the mean log likelihood of a guess, which is correct with the probability γ, the guess rate of the
/// prior (`FunctionTable::guess`): the answer is split as in the fits of psychometric functions. The expected entropy
/// takes the next answer to be correct or incorrect.
///
/// The rule owns the table of likelihoods, which its copies share.
LevelRule posterior_rule(const PosteriorTrack& track, std::span<const NuisanceParameter> nuisances);

}  // namespace asperity
