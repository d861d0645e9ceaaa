// The sessions of a protocol that could go on.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/phrase.h"
#include "app/tasks/session_conditions.h"
#include "protocols/protocol.h"
#include "results_schema/study.h"

namespace asperity {

struct UnfinishedSession {
  SessionRow row{};
  int trials_done = 0;
  int trials = 0;
  std::optional<double> age_hours{};  ///< since it last ran; absent on a simulated clock
  RecordedNoise noise{};              ///< of its last stretch
};

/// Since the session last ran, in real time; nothing on a simulated clock. Errors: ResultsError.
std::optional<double> hours_since_it_ran(const Study& study, const SessionRow& session);

/// Why a session of this age needs a reason to be resumed, as the protocol declares; empty: it needs none.
Phrase complaint_about_age(const Protocol& protocol, const std::optional<double>& age_hours);

/// Those of this very protocol, by participant, session.
std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol);

/// The one of this participant that `RunInputs::resume` goes on with: the one with this id, or
/// without an id the latest. As `unfinished_row` finds it.
std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id);

}  // namespace asperity
