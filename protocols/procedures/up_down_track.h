// A track of levels on a grid that an up-down rule moves: the common part of the up-down procedures.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/psychometric/up_down.h"
#include "protocols/procedures/level_answer.h"
#include "protocols/procedures/level_grid.h"

namespace asperity {

/// When a track ends: at the first rule that applies. `trials` is required as the upper limit, because a track that
/// stays at a bound never reverses.
struct StopRules {
  std::size_t trials = 0;                  ///< answers; 0 is a problem
  std::optional<std::size_t> reversals{};  ///< as in `UpDownRun`
  /// Moves in succession that a bound of the grid shortened or prevented: the threshold is then beyond the grid. Where
  /// absent, the track stays at the bound until a move leads away from it.
  std::optional<std::size_t> clipped_moves{};

  bool operator==(const StopRules&) const = default;
};

/// The steps of one direction, in the unit of the grid's scale, by the number of reversals (`UpDownRun`); the last one
/// continues. Each is a whole number of grid steps, so that the track visits levels of the grid alone.
using StepList = std::vector<double>;

struct UpDownTrack {
  LevelGrid grid{};
  double start = 0.0;  ///< a level of the grid
  UpDownRule rule{};
  StepList steps_up{};
  StepList steps_down{};
  StopRules stop{};
  /// Of the moves up after `LevelOutcome::unsure`, as many as `steps_up`; empty where a choice is forced.
  StepList steps_unsure{};

  bool operator==(const UpDownTrack&) const = default;
};

/// Reports the problems of a track under the settings `up`, `down`, `stop.…`, `grid.…`, `start`, `steps_up` and
/// `steps_down`.
void check_track(const UpDownTrack& track, ProcedureProblems& problems);

/// The next level: the level of the grid that is nearest to the last *delivered* level, moved by the rule and its step,
/// and at a bound no further than the bound. A delivered level that is half a grid step or more away from the proposed
/// one therefore moves the track with it. Where there are no unsure steps, an unsure answer counts as an incorrect one.
NextStep next_of(const UpDownTrack& track, std::span<const LevelAnswer> answers);

/// `balanced_performance` with the last steps of both lists.
double target_of(const UpDownTrack& track);

/// Whether a track ends by its number of trials alone.
bool has_fixed_length(const StopRules& stop) noexcept;

}  // namespace asperity
