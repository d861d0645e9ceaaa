// Declares the replay of a recording through a force model.

#pragma once

#include <span>
#include <vector>

#include "renderers/force/force_renderer.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// The results of the renderer for the hand's motion in a recording, record by record. It is called and reset exactly
/// where the recorded one was; nothing is rendered elsewhere (a fault, free space).
///
/// With the original renderer and all records of the presentation, the results equal TickRecord::rendered bit for bit
/// (a recording stores it as float). For a renderer that depends on past samples, this no longer holds after records
/// that the ring lost.
///
/// Errors: std::invalid_argument for a rate that is not positive.
std::vector<RenderedTick> replay(ForceRenderer& renderer, std::span<const TickRecord> records,
                                 double rate_Hz);

}  // namespace asperity
