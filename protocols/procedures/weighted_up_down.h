// The weighted up-down method.

#pragma once

#include <cstddef>
#include <optional>

#include "protocols/procedures/up_down_track.h"

namespace asperity {

struct Procedure;

/// A staircase that moves after every response, down if it is correct and up otherwise, with a larger step up than down
/// [Kaernbach 1991]. The level has no drift at the target p where Δ⁻·p = Δ⁺·(1 − p):
///
///   Δ⁺ = Δ⁻·p/(1 − p),
///
/// 3·Δ⁻ for 75 % correct. Only the steps down are set. The products must be whole numbers of grid steps as well.
///
/// In an unforced choice one of m alternatives is chosen, or the response is "cannot tell" (`LevelOutcome::unsure`). Its step
/// is the mean step of a guess, which is correct with the probability 1/m [Kaernbach 2001]:
///
///   Δ? = (1 − 1/m)·Δ⁺ − Δ⁻/m = Δ⁻·(p − 1/m)/(1 − p),
///
/// upwards: Δ⁻ for 75 % correct and m = 2. The expected step is therefore the same for a participant who guesses and for one
/// who responds "cannot tell", and so is the target: that of the proportion correct in which such a response counts 1/m.
/// p must be above 1/m, and Δ? a whole number of grid steps. A response "cannot tell" is a move up for reversals.
///
/// [Kaernbach 1991] Kaernbach: Simple adaptive testing with the weighted up-down method.
/// [Kaernbach 2001] Kaernbach: Adaptive threshold estimation with unforced-choice tasks.
struct WeightedUpDown {
  LevelGrid grid{};
  double start = 0.0;    ///< a level of the grid
  double target = 0.75;  ///< proportion of correct responses
  StepList steps_down{};
  StopRules stop{};
  /// The number of alternatives m of an unforced choice; absent: a choice is forced.
  std::optional<std::size_t> unforced_alternatives{};

  bool operator==(const WeightedUpDown&) const = default;
};

/// The same staircase as a track with the rule 1-up/1-down. Empty if a step up or an unsure one is not a whole number of grid
/// steps, or the target is not a proportion between 0 (in an unforced choice 1/m) and 1.
std::optional<UpDownTrack> track_of(const WeightedUpDown& method);

const Procedure& weighted_up_down();

}  // namespace asperity
