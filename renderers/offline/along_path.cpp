// Implements the evaluation of a force model along a path.

#include "renderers/offline/along_path.h"

#include <cstddef>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "renderers/servo/servo_time.h"

namespace asperity {

std::vector<RenderedTick> along_path(ForceRenderer& renderer, std::span<const ProbeState> path,
                                     double rate_Hz) {
  return tool_along_path(renderer, path, rate_Hz).ticks;
}

ToolAlongPath tool_along_path(ForceRenderer& renderer, std::span<const ProbeState> path,
                              double rate_Hz) {
  if (!(rate_Hz > 0.0))
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
  const auto* simulates = dynamic_cast<const SimulatesTool*>(&renderer);
  ToolAlongPath along;
  along.ticks.reserve(path.size());
  along.tools.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 0) renderer.reset(path[i]);
    const double dt_s =
        i == 0 ? 1.0 / rate_Hz : clamped_dt_s(path[i - 1].time_ns, path[i].time_ns, rate_Hz);
    along.ticks.push_back(renderer.tick(path[i], dt_s));
    const TipPose probe{.position_m = path[i].position_m, .orientation = path[i].orientation};
    along.tools.push_back(simulates ? simulates->simulated_tool().value_or(probe) : probe);
  }
  return along;
}

}  // namespace asperity
