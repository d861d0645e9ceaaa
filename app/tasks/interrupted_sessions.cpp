// Finds sessions that are open without a running program, and matches protocol files by their text.

#include "app/tasks/interrupted_sessions.h"

#include <algorithm>
#include <tuple>

#include "app/tasks/study_overview.h"

namespace asperity {

namespace {

bool is_interrupted(const Study& study, const SessionRow& row) {
  if (row.excluded) return false;
  if (row.state == SessionState::crashed) return true;
  if (row.state != SessionState::open) return false;
  if (is_running(study, row)) return false;
  // It may have ended, and released the lock, since it was read.
  return study.session(row.id).state == SessionState::open;
}

}  // namespace

std::vector<InterruptedSession> interrupted_sessions(const Study& study,
                                                     const std::stop_token& stop) {
  std::vector<SessionRow> rows{};
  for (const SessionRow& row : study.sessions()) {
    if (stop.stop_requested()) break;
    if (is_interrupted(study, row)) rows.push_back(row);
  }
  if (rows.empty()) return {};
  const auto files = protocol_files_by_text(study.folder());
  std::vector<InterruptedSession> found{};
  for (const SessionRow& row : rows) {
    if (stop.stop_requested()) break;
    const ProtocolRow protocol = study.protocol(row.protocol_id);
    const SessionCounts counts = study.session_counts(row.id);
    found.push_back({.row = row,
                     .protocol_name = protocol.name,
                     .protocol_version = protocol.version,
                     .trials_done = counts.done_trials,
                     .trials = counts.planned_trials});
    if (const auto file = files.find(protocol.source); file != files.end()) {
      found.back().protocol_file = file->second;
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const InterruptedSession& a, const InterruptedSession& b) {
                     const auto order = [](const InterruptedSession& session) {
                       return std::tuple(session.row.mode != SessionMode::simulate, session.row.id);
                     };
                     return order(a) > order(b);
                   });
  return found;
}

}  // namespace asperity
