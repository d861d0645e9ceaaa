// Draws the sequence of the protocol anew up to the place of each participant.

#include "app/tasks/verify/verify_groups.h"

#include <algorithm>
#include <cstddef>
#include <exception>

#include "app/records/recorded_attempt.h"
#include "app/study_files/group_places.h"
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

/// What contradicts the sequence in the group of a session; empty where nothing does.
std::string problem_of(const GroupPlace& place, std::size_t deleted, PlansOfSessions& plans) {
  const SessionRow& session = *place.session;
  const Protocol* const protocol = protocol_with_sequence(session, plans);
  if (protocol == nullptr) return {};
  if (place.first != place.session) {
    return place.first->group_level == session.group_level
               ? ""
               : session_name(session) + ": its group is " + *session.group_level +
                     ", and that of the participant's first session " + *place.first->group_level;
  }
  if (place.dealt) return {};
  const auto group_at = [&](std::size_t before) {
    return permuted_group(*protocol, text_of(session.mode), before);
  };
  for (std::size_t before = place.before; before <= place.before + deleted; ++before) {
    if (group_at(before) == *session.group_level) return {};
  }
  return session_name(session) + ": its group is " + *session.group_level + ", and that of place " +
         std::to_string(place.before + 1) + " in the permuted blocks is " + group_at(place.before);
}

}  // namespace

std::vector<std::string> group_problems(const Study& study, PlansOfSessions& plans) {
  const std::vector<WithdrawalRow> withdrawals = study.withdrawals();
  const auto deleted = static_cast<std::size_t>(
      std::count_if(withdrawals.begin(), withdrawals.end(),
                    [](const WithdrawalRow& row) { return row.data == WithdrawnData::deleted; }));
  const std::vector<SessionRow> sessions = study.sessions();
  std::vector<std::string> problems{};
  for (const GroupPlace& place : group_places(study, sessions)) {
    const std::string problem = problem_of(place, deleted, plans);
    if (!problem.empty()) problems.push_back(problem);
  }
  return problems;
}

}  // namespace asperity
