// Keeps the changes in chronological order; a mask counts as off when a session begins or is resumed.

#include "app/records/eye_mask.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace asperity {

EyeMask::EyeMask(const std::vector<TimedEvent>& timeline) {
  for (const TimedEvent& event : timeline) {
    const std::string& kind = event.row.kind;
    if (kind == "mask_on") {
      changes_.emplace_back(event.row.time_ns, true);
    } else if (kind == "mask_off" || kind == "session_began" || kind == "session_resumed") {
      changes_.emplace_back(event.row.time_ns, false);
    }
  }
}

bool EyeMask::is_on(std::int64_t time_ns) const {
  const auto later =
      std::upper_bound(changes_.begin(), changes_.end(), time_ns,
                       [](std::int64_t at, const auto& change) { return at < change.first; });
  return later != changes_.begin() && std::prev(later)->second;
}

std::optional<bool> EyeMask::was_on_in(const AttemptRow& attempt) const {
  std::optional<bool> was_on{};
  const auto look = [&](std::int64_t time_ns) { was_on = was_on.value_or(true) && is_on(time_ns); };
  for (const PresentationRow& surface : attempt.presentations) {
    for (const VisitRow& visit : surface.visits) look(visit.contact_ns);
    if (surface.visits.empty() && surface.onset_ns) look(*surface.onset_ns);
  }
  return was_on;
}

}  // namespace asperity
