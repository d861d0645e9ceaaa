// Declares the evaluation of a force model along a known path.

#pragma once

#include <span>
#include <vector>

#include "renderers/force/force_renderer.h"

namespace asperity {

/// The result of the renderer for each sample of the path: `reset` at the first, `dt_s` from the time stamps by the
/// rule of the servo loop (one period for the first, then clamped to [½, 4] periods).
///
/// Errors: std::invalid_argument for a rate that is not positive.
std::vector<RenderedTick> along_path(ForceRenderer& renderer, std::span<const ProbeState> path,
                                     double rate_Hz);

}  // namespace asperity
