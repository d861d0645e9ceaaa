#include "app/tasks/unfinished_session.h"

#include <algorithm>

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
  const std::int64_t id = found->row.id;
  found->trials_done =
      static_cast<int>(trials_done(study.attempts(id), study.decisions(id)).size());
  found->trials = static_cast<int>(study.plan(found->row.id).size());
  return found;
}

std::set<int> trials_done(const std::vector<AttemptRow>& attempts,
                          const std::vector<DecisionRow>& decisions) {
  std::set<int> done{};
  for (const AttemptRow& attempt : attempts) {
    const bool is_set_aside =
        std::any_of(decisions.begin(), decisions.end(), [&attempt](const DecisionRow& decision) {
          return decision.verdict == Verdict::set_aside && decision.trial == attempt.trial &&
                 decision.attempt == attempt.attempt;
        });
    if (attempt.valid || (attempt.outcome == AttemptOutcome::skipped && !is_set_aside)) {
      done.insert(attempt.trial);
    }
  }
  return done;
}

}  // namespace asperity
