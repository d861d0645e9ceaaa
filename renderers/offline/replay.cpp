// Implements the replay of a recording through a force model.

#include "renderers/offline/replay.h"

#include <cstdint>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "renderers/servo/servo_time.h"

namespace asperity {

std::vector<RenderedTick> replay(ForceRenderer& renderer, std::span<const TickRecord> records,
                                 double rate_Hz) {
  if (!(rate_Hz > 0.0))
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
  std::vector<RenderedTick> ticks;
  ticks.reserve(records.size());
  bool was_asked = false;
  std::int64_t last_ns = 0;
  for (const TickRecord& record : records) {
    if (!record.has(TickFlag::presenting)) {
      ticks.emplace_back();
      continue;
    }
    const bool first = record.has(TickFlag::first_of_presentation) || !was_asked;
    if (first) renderer.reset(record.probe);
    const double dt_s =
        first ? 1.0 / rate_Hz : clamped_dt_s(last_ns, record.probe.time_ns, rate_Hz);
    ticks.push_back(renderer.tick(record.probe, dt_s));
    last_ns = record.probe.time_ns;
    was_asked = true;
  }
  return ticks;
}

}  // namespace asperity
