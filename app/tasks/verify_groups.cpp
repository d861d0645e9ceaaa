#include "app/tasks/verify_groups.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <utility>

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

}  // namespace

std::vector<std::string> group_problems(const Study& study, PlansOfSessions& plans) {
  const std::vector<WithdrawalRow> withdrawals = study.withdrawals();
  const auto deleted = static_cast<std::size_t>(
      std::count_if(withdrawals.begin(), withdrawals.end(),
                    [](const WithdrawalRow& row) { return row.data == WithdrawnData::deleted; }));
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& row : study.protocols()) names[row.id] = row.name;
  std::vector<SessionRow> sessions = study.sessions();
  std::sort(sessions.begin(), sessions.end(),
            [](const SessionRow& one, const SessionRow& other) { return one.id < other.id; });
  std::vector<std::string> problems{};
  std::map<std::pair<std::string, SessionMode>, std::map<std::string, std::string>> assigned{};
  for (const SessionRow& session : sessions) {
    if (!session.group_level || session.mode == SessionMode::simulate) continue;
    auto& groups = assigned[{names[session.protocol_id], session.mode}];
    const std::size_t before = groups.size();
    const auto [own, is_first] = groups.try_emplace(session.participant, *session.group_level);
    const Protocol* const protocol = protocol_with_sequence(session, plans);
    if (protocol == nullptr) continue;
    if (!is_first && own->second != *session.group_level) {
      problems.push_back(name_of_session(session) + ": its group is " + *session.group_level +
                         ", and that of the participant's first session " + own->second +
                         "; restore the study from a copy");
    }
    if (!is_first) continue;
    bool is_possible = false;
    for (std::size_t place = before; place <= before + deleted; ++place) {
      is_possible = is_possible ||
                    permuted_group(*protocol, text_of(session.mode), place) == *session.group_level;
    }
    if (is_possible) continue;
    problems.push_back(name_of_session(session) + ": its group is " + *session.group_level +
                       ", and that of place " + std::to_string(before + 1) +
                       " in the permuted blocks is " +
                       permuted_group(*protocol, text_of(session.mode), before) +
                       "; restore the study from a copy");
  }
  return problems;
}

}  // namespace asperity
