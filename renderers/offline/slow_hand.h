// Declares the recorded motion of a hand without its fast components.

#pragma once

#include <span>
#include <vector>

#include "renderers/servo/tick_record.h"

namespace asperity {

/// The highest frequency of a deliberate motion: participants move their hands below about 10 Hz and tremble at 8 to
/// 12 Hz.
inline constexpr double kSlowHand_Hz = 30.0;

/// The records with the position, the orientation and both velocities of the probe low-passed at kSlowHand_Hz without delay
/// (filtered_without_delay, order 2: a gain of ½ at 30 Hz and 0.002 at 150 Hz). Everything else is unchanged. Records that
/// are not consecutive (kUnbroken_ticks) and a reset of the renderer begin a new motion.
///
/// A renderer that replays the result is in an open loop: an oscillation of hand and device above the cut-off does not
/// reach it.
///
/// Errors: std::invalid_argument for a rate that is not above 2·kSlowHand_Hz.
std::vector<TickRecord> slow_hand(std::span<const TickRecord> records, double rate_Hz);

}  // namespace asperity
