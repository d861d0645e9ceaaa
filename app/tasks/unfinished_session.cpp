#include "app/tasks/unfinished_session.h"

#include <algorithm>

#include "app/conductor/session_setup.h"

namespace asperity {

std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol) {
  std::set<std::int64_t> ids{};  // of this text
  for (const ProtocolRow& row : study.protocols()) {
    if (row.source == protocol.source) ids.insert(row.id);
  }
  std::vector<UnfinishedSession> sessions{};
  for (const SessionRow& row : study.sessions()) {
    if (row.state == SessionState::completed || !ids.contains(row.protocol_id)) continue;
    if (has_ended_by_rule(study, protocol, row)) continue;
    const std::set<int> done = trials_done(study.attempts(row.id), study.decisions(row.id));
    sessions.push_back({.row = row,
                        .trials_done = static_cast<int>(done.size()),
                        .trials = static_cast<int>(study.plan(row.id).size())});
  }
  return sessions;
}

std::optional<UnfinishedSession> unfinished_of(const std::vector<UnfinishedSession>& sessions,
                                               const std::string& participant,
                                               std::optional<std::int64_t> id) {
  std::optional<UnfinishedSession> found{};
  for (const UnfinishedSession& session : sessions) {
    if (session.row.participant == participant && (!id || session.row.id == *id)) found = session;
  }
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
