// A recorded hand through a force model.

#pragma once

#include <span>
#include <vector>

#include "renderers/force/force_renderer.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// What the renderer answers to the hand of a recording, record by record: it is asked, and reset,
/// exactly where the one of the recording was; nothing is rendered in between (a fault, free
/// space).
///
/// With the renderer that was felt and every record of the presentation there, the answers equal
/// TickRecord::rendered bit for bit (a recording keeps that as float). Records that the ring lost
/// break this from there on for a renderer that depends on the past.
///
/// Errors: std::invalid_argument for a rate that is not positive.
std::vector<RenderedTick> replay(ForceRenderer& renderer, std::span<const TickRecord> records,
                                 double rate_Hz);

}  // namespace asperity
