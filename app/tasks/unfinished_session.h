// The unfinished sessions of a protocol, and whether they can be resumed.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/records/session_conditions.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// The latest stored time of a session, on its clock; a resumed session continues after it.
std::int64_t last_time_ns(const Study& study, const SessionRow& session);

/// The time since a session in real time last ran, in hours. Errors: ResultsError.
double hours_since_it_ran(const Study& study, const SessionRow& session);

/// A session that is older than its protocol permits for resuming.
struct LateResume {
  double age_hours = 0.0;
  double maximum_age_hours = 0.0;
};
/// Empty if the protocol declares no maximum, on a simulated clock, and within the maximum. Errors: ResultsError.
std::optional<LateResume> late_resume(const Study& study, const Protocol& protocol,
                                      const SessionRow& session);
/// States that a reason is required to resume it.
Phrase complaint_about(const LateResume& late);

struct UnfinishedSession {
  SessionRow row{};
  int trials_done = 0;
  int trials = 0;
  std::optional<LateResume> late{};  ///< if it is resumed now
  RecordedNoise noise{};             ///< of its last stretch
  bool lacks_levels = false;         ///< an external program has to state further levels
};

/// The unfinished sessions of exactly this protocol, by participant and session.
std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol);

/// The session of this participant that `RunInputs::resume` resumes: that with this id, or
/// without an id the latest. The same as that of `unfinished_row`.
std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id);

}  // namespace asperity
