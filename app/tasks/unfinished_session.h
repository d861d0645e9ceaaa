// The session that a participant could go on with.

#pragma once

#include <cstdint>
#include <optional>
#include <set>
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

/// The session of this participant and this very protocol that `RunInputs::resume` goes on with: see
/// `unfinished_row`.
std::optional<UnfinishedSession> unfinished_session(const Study& study, const Protocol& protocol,
                                                    const std::string& participant,
                                                    std::optional<std::int64_t> id);

/// The trials of a session that are not asked any more: with a valid attempt, or skipped and not set
/// aside.
std::set<int> trials_done(const std::vector<AttemptRow>& attempts,
                          const std::vector<DecisionRow>& decisions);

}  // namespace asperity
