// The answers that a procedure is given, and what it returns.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <variant>

#include "analysis/numbers/random.h"

namespace asperity {

/// No track may have more trials.
inline constexpr std::size_t kMostTrials = 100000;

/// What a response means for the levels. `correct`: the response that leads to a lower level; where no response is correct,
/// the choice that counts as such. `unsure`: the response "cannot tell" of an unforced choice.
enum class LevelOutcome { incorrect, correct, unsure };

constexpr LevelOutcome forced_outcome(bool is_correct) noexcept {
  return is_correct ? LevelOutcome::correct : LevelOutcome::incorrect;
}

/// One answered trial of a track. Attempts that were interrupted, invalidated or excluded are not answers; the caller
/// of a procedure leaves them out.
struct LevelAnswer {
  double level = 0.0;  ///< the level that was delivered, which can differ from the proposed one
  LevelOutcome outcome = LevelOutcome::incorrect;

  bool operator==(const LevelAnswer&) const = default;
};

/// The level that the next trial of a track should have.
struct NextLevel {
  double level = 0.0;

  bool operator==(const NextLevel&) const = default;
};

/// Why a track is finished. The first rule in this order that applies is reported.
/// `program`: as the program of an external procedure states.
enum class TrackEnd { trials, reversals, bound, interval, program };

using NextStep = std::variant<NextLevel, TrackEnd>;

/// The level of the next trial of a track with these answers, or why there is none. Once a track is finished, further
/// answers leave it so. `of_track`: the stream of the track, at its beginning.
using LevelRule =
    std::function<NextStep(std::span<const LevelAnswer> answers, const Random& of_track)>;

}  // namespace asperity
