#include "app/tasks/unfinished_session.h"

#include <set>

#include "app/conductor/session_setup.h"

namespace asperity {

std::vector<UnfinishedSession> unfinished_sessions(const Study& study, const Protocol& protocol) {
  std::set<std::int64_t> ids{};  // of this text
  for (const ProtocolRow& row : study.protocols()) {
    if (row.source == protocol.source) ids.insert(row.id);
  }
  std::vector<UnfinishedSession> sessions{};
  for (const SessionRow& row : study.sessions()) {
    if (row.state == SessionState::completed || row.withdrawn || !ids.contains(row.protocol_id)) {
      continue;
    }
    if (has_ended_by_rule(study, protocol, row)) continue;
    const SessionCounts counts = study.session_counts(row.id);
    sessions.push_back(
        {.row = row, .trials_done = counts.done_trials, .trials = counts.planned_trials});
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

}  // namespace asperity
