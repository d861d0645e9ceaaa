// From which studies a session was merged.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

/// One of the studies from which a session was merged.
struct SessionOrigin {
  std::string key{};            ///< identifies that study among all that were merged; not empty
  std::int64_t session_id = 0;  ///< the id of the session there
};

/// The studies from which a session was merged, by its events: the one in which it was run first, the one that was merged last
/// at the end. Empty for a session that was run in this study, and for one of a virtual participant.
std::vector<SessionOrigin> session_origins(const std::vector<EventRow>& events);

}  // namespace asperity
