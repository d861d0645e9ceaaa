// The weighted up-down method.

#pragma once

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
/// [Kaernbach 1991] Kaernbach: Simple adaptive testing with the weighted up-down method.
struct WeightedUpDown {
  LevelGrid grid{};
  double start = 0.0;    ///< a level of the grid
  double target = 0.75;  ///< proportion of correct responses
  StepList steps_down{};
  StopRules stop{};

  bool operator==(const WeightedUpDown&) const = default;
};

/// The same staircase as a track with the rule 1-up/1-down. Empty if a step up is not a whole number of grid steps or
/// the target is not a proportion between 0 and 1.
std::optional<UpDownTrack> track_of(const WeightedUpDown& method);

const Procedure& weighted_up_down();

}  // namespace asperity
