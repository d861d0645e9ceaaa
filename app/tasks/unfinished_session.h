// The sessions of a protocol that could go on.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocols/protocol.h"
#include "results_schema/study.h"

namespace asperity {

struct UnfinishedSession {
  SessionRow row{};
  int trials_done = 0;
  int trials = 0;
};

/// Those of this very protocol, by participant, session.
std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol);

/// The one of this participant that `RunInputs::resume` goes on with: the one with this id, or
/// without an id the latest. As `unfinished_row` finds it.
std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id);

}  // namespace asperity
