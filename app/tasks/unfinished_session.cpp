#include "app/tasks/unfinished_session.h"

#include <set>

#include "app/conductor/session_setup.h"

namespace asperity {

std::optional<UnfinishedSession> unfinished_session(const Study& study, const Protocol& protocol,
                                                    const std::string& participant) {
  std::optional<UnfinishedSession> found{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant != participant || row.state == SessionState::completed) continue;
    if (study.protocol(row.protocol_id).source == protocol.source &&
        !has_ended_by_rule(study, protocol, row)) {
      found = UnfinishedSession{.row = row};
    }
  }
  if (!found) return {};
  std::set<int> done{};
  for (const AttemptRow& attempt : study.attempts(found->row.id)) {
    if (attempt.valid || attempt.outcome == AttemptOutcome::skipped) done.insert(attempt.trial);
  }
  found->trials_done = static_cast<int>(done.size());
  found->trials = static_cast<int>(study.plan(found->row.id).size());
  return found;
}

}  // namespace asperity
