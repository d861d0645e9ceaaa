// Declares the evaluation of a force model along a known path.

#pragma once

#include <span>
#include <vector>

#include "renderers/force/force_renderer.h"
#include "renderers/force/simulated_tool.h"

namespace asperity {

/// The result of the renderer for each sample of the path: `reset` at the first, `dt_s` from the time stamps by the
/// rule of the servo loop (one period for the first, then clamped to [½, 4] periods).
///
/// Errors: std::invalid_argument for a rate that is not positive.
std::vector<RenderedTick> along_path(ForceRenderer& renderer, std::span<const ProbeState> path,
                                     double rate_Hz);

/// The results along a path, with the tool.
struct ToolAlongPath {
  std::vector<RenderedTick> ticks{};
  /// The tool after each tick: the simulated one (SimulatesTool), otherwise the probe of the sample.
  std::vector<TipPose> tools{};
};

/// The same, with the pose of the tool. Errors: as `along_path`.
ToolAlongPath tool_along_path(ForceRenderer& renderer, std::span<const ProbeState> path,
                              double rate_Hz);

}  // namespace asperity
