// The transformed up-down method.

#pragma once

#include "protocols/procedures/up_down_track.h"

namespace asperity {

struct Procedure;

/// A staircase of any n-down/m-up rule [Levitt 1971]: the level moves down after n correct responses in succession and
/// up after m incorrect ones. It approaches `balanced_performance` of the last steps of both lists; with equal steps
/// and n = 2 or 3, m = 1 70.7 % or 79.4 %. Ratios Δ⁻/Δ⁺ of .2845, .5488, .7393 and .8415 for 1 to 4 down make it approach
/// its target from all starts [García-Pérez 1998].
///
/// [Levitt 1971] Levitt: Transformed up-down methods in psychoacoustics.
/// [García-Pérez 1998] García-Pérez: Forced-choice staircases with fixed step sizes.
struct TransformedUpDown {
  UpDownTrack track{};

  bool operator==(const TransformedUpDown&) const = default;
};

const Procedure& transformed_up_down();

}  // namespace asperity
