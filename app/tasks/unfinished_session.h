// The sessions of a protocol that could go on.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/records/session_conditions.h"
#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// How long ago a session in real time last ran. h. Errors: ResultsError.
double hours_since_it_ran(const Study& study, const SessionRow& session);

/// How long ago a session last ran that is older than its protocol has sessions resumed.
struct LateResume {
  double age_hours = 0.0;
  double maximum_age_hours = 0.0;
};
/// Nothing where the protocol declares no maximum, on a simulated clock, and in time. Errors: ResultsError.
std::optional<LateResume> late_resume(const Study& study, const Protocol& protocol,
                                      const SessionRow& session);
/// Why it needs a reason to be resumed.
Phrase complaint_about(const LateResume& late);

struct UnfinishedSession {
  SessionRow row{};
  int trials_done = 0;
  int trials = 0;
  std::optional<LateResume> late{};  ///< if it were resumed now
  RecordedNoise noise{};             ///< of its last stretch
};

/// Those of this very protocol, by participant, session.
std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol);

/// The one of this participant that `RunInputs::resume` goes on with: the one with this id, or
/// without an id the latest. As `unfinished_row` finds it.
std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id);

}  // namespace asperity
