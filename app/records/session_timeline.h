// The events of a session in chronological order, with their durations and attempts.

#pragma once

#include <optional>
#include <vector>

#include "results_schema/rows.h"

namespace asperity {

struct TimedEvent {
  int number = 0;  ///< within the session, by time, from 1
  EventRow row{};
  /// 0 for an instantaneous event. Absent where its end was not recorded, for example after a
  /// crash.
  std::optional<double> duration_s{};
  /// The attempt that it belongs to, or that was current at its time; points into the argument.
  const AttemptRow* attempt = nullptr;
};

/// All rows of the table `event` of one session: its events (`Study::events`) and those of its
/// attempts.
std::vector<TimedEvent> session_timeline(const std::vector<EventRow>& events,
                                         const std::vector<AttemptRow>& attempts);

}  // namespace asperity
