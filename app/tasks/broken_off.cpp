#include "app/tasks/broken_off.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <tuple>

#include "app/tasks/unfinished_session.h"
#include "results_schema/atomic_file.h"

namespace asperity {

namespace {

bool is_broken_off(const Study& study, const SessionRow& row) {
  if (row.excluded) return false;
  if (row.state == SessionState::crashed) return true;
  if (row.state != SessionState::open) return false;
  const std::string lock = Study::session_lock_name(row.participant);
  if (StudyLock::holder(study.folder(), lock)) return false;
  // It may have ended, and let go of the lock, since it was read.
  return study.session(row.id).state == SessionState::open;
}

std::optional<std::filesystem::path> file_of(const std::filesystem::path& study,
                                             const std::string& text) {
  std::error_code ignored{};
  for (const auto& entry : std::filesystem::directory_iterator(study / "protocols", ignored)) {
    if (entry.path().extension() != ".json") continue;
    try {
      if (read_file(entry.path()) == text) return entry.path();
    } catch (const std::exception&) {
      // What is wrong with it is said where protocols are listed.
    }
  }
  return {};
}

}  // namespace

std::vector<BrokenOffSession> broken_off_sessions(const Study& study, const std::stop_token& stop) {
  std::vector<BrokenOffSession> found{};
  for (const SessionRow& row : study.sessions()) {
    if (stop.stop_requested()) break;
    if (!is_broken_off(study, row)) continue;
    const ProtocolRow protocol = study.protocol(row.protocol_id);
    const std::set<int> done = trials_done(study.attempts(row.id), study.decisions(row.id));
    found.push_back({.row = row,
                     .protocol_name = protocol.name,
                     .protocol_version = protocol.version,
                     .protocol_file = file_of(study.folder(), protocol.source),
                     .trials_done = static_cast<int>(done.size()),
                     .trials = static_cast<int>(study.plan(row.id).size())});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const BrokenOffSession& a, const BrokenOffSession& b) {
                     const auto order = [](const BrokenOffSession& session) {
                       return std::tuple(session.row.mode != SessionMode::simulate, session.row.id);
                     };
                     return order(a) > order(b);
                   });
  return found;
}

}  // namespace asperity
