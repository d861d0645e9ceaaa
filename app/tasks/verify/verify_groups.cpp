#include "app/tasks/verify/verify_groups.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <utility>

#include "app/study_files/dealt_places.h"
#include "app/tasks/session_origins.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

/// Null for a protocol that this program cannot read, which is reported with the plan of its sessions.
const Protocol* protocol_with_sequence(const SessionRow& session, PlansOfSessions& plans) {
  try {
    const Protocol& protocol = plans.protocol_of(session);
    const bool is_permuted = protocol.groups && protocol.groups->assigned ==
                                                    Protocol::Groups::Assignment::permuted_blocks;
    return is_permuted ? &protocol : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::string name_of_session(const SessionRow& session) {
  return "session " + std::to_string(session.session) + " of participant " + session.participant;
}

/// A session at its place in the order in which a study assigned groups.
struct AssignedSession {
  std::int64_t place = 0;  ///< the id of the session in that study
  const SessionRow* session = nullptr;
  bool is_assigned_there = false;  ///< otherwise it was there already
  bool has_dealt_place = false;    ///< its group follows from the place and not from the sequence
};

/// The sessions of each study that assigned groups: this one, under an empty key, and those that were merged into it. A
/// session that was merged was assigned in the study from which it came; in the others it counts as one that was there.
std::map<std::string, std::vector<AssignedSession>> sessions_by_study(
    const Study& study, const std::vector<SessionRow>& sessions) {
  std::map<std::string, std::vector<AssignedSession>> by_study{};
  for (const SessionRow& session : sessions) {
    if (!session.group_level || session.mode == SessionMode::simulate) continue;
    const std::vector<EventRow> events = study.events(session.id);
    const bool is_dealt = dealt_place(events).has_value();
    const std::vector<SessionOrigin> origins = session_origins(events);
    by_study[""].push_back({session.id, &session, origins.empty(), is_dealt});
    for (const SessionOrigin& origin : origins) {
      by_study[origin.key].push_back(
          {origin.session_id, &session, &origin == &origins.front(), is_dealt});
    }
  }
  for (auto& [key, assigned] : by_study) {
    std::sort(assigned.begin(), assigned.end(),
              [](const AssignedSession& one, const AssignedSession& other) {
                return one.place < other.place;
              });
  }
  return by_study;
}

/// What contradicts the sequence in one study that assigned groups.
class GroupSequence final {
 public:
  GroupSequence(const std::map<std::int64_t, std::string>& names, std::size_t deleted,
                PlansOfSessions& plans)
      : names_(names), deleted_(deleted), plans_(plans) {}

  void add(const AssignedSession& assigned, std::vector<std::string>& problems) {
    const SessionRow& session = *assigned.session;
    auto& groups = groups_[{names_.at(session.protocol_id), session.mode}];
    const std::size_t before = groups.size();
    const auto [own, is_first] = groups.try_emplace(session.participant, *session.group_level);
    if (!assigned.is_assigned_there) return;
    const Protocol* const protocol = protocol_with_sequence(session, plans_);
    if (protocol == nullptr) return;
    if (!is_first && own->second != *session.group_level) {
      problems.push_back(name_of_session(session) + ": its group is " + *session.group_level +
                         ", and that of the participant's first session " + own->second);
    }
    if (!is_first || assigned.has_dealt_place) return;
    for (std::size_t place = before; place <= before + deleted_; ++place) {
      if (permuted_group(*protocol, text_of(session.mode), place) == *session.group_level) return;
    }
    problems.push_back(name_of_session(session) + ": its group is " + *session.group_level +
                       ", and that of place " + std::to_string(before + 1) +
                       " in the permuted blocks is " +
                       permuted_group(*protocol, text_of(session.mode), before));
  }

 private:
  const std::map<std::int64_t, std::string>& names_;  ///< of protocols
  std::size_t deleted_;
  PlansOfSessions& plans_;
  /// The group of each participant, by the name of the protocol and the mode.
  std::map<std::pair<std::string, SessionMode>, std::map<std::string, std::string>> groups_{};
};

}  // namespace

std::vector<std::string> group_problems(const Study& study, PlansOfSessions& plans) {
  const std::vector<WithdrawalRow> withdrawals = study.withdrawals();
  const auto deleted = static_cast<std::size_t>(
      std::count_if(withdrawals.begin(), withdrawals.end(),
                    [](const WithdrawalRow& row) { return row.data == WithdrawnData::deleted; }));
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& row : study.protocols()) names[row.id] = row.name;
  const std::vector<SessionRow> sessions = study.sessions();
  std::vector<std::string> problems{};
  for (const auto& [key, assigned] : sessions_by_study(study, sessions)) {
    GroupSequence sequence(names, deleted, plans);
    for (const AssignedSession& session : assigned) sequence.add(session, problems);
  }
  return problems;
}

}  // namespace asperity
