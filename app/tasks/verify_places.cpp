#include "app/tasks/verify_places.h"

#include <cstdint>
#include <exception>
#include <map>
#include <set>
#include <utility>

#include "app/study_files/dealt_places.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

/// Null for a protocol that this program cannot read, which is reported with the plan of its sessions.
const Protocol* readable_protocol(const SessionRow& session, PlansOfSessions& plans) {
  try {
    return &plans.protocol_of(session);
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace

std::vector<std::string> place_problems(const Study& study, PlansOfSessions& plans) {
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& row : study.protocols()) names[row.id] = row.name;
  std::set<std::pair<std::string, std::string>> compared{};  // participants and protocols
  std::vector<std::string> problems{};
  for (const SessionRow& session : study.sessions()) {
    if (session.mode != SessionMode::run) continue;
    const std::optional<int> place = dealt_place(study.events(session.id));
    if (!place || !compared.insert({session.participant, names[session.protocol_id]}).second) {
      continue;
    }
    const Protocol* const protocol = readable_protocol(session, plans);
    if (protocol == nullptr) continue;
    const Allocation expected =
        allocations_in_turn(*protocol, text_of(session.mode), *place).back();
    const std::string group = session.group_level.value_or("");
    if (session.counterbalance_row == expected.counterbalance_row && group == expected.group) {
      continue;
    }
    const auto text = [](int row, const std::string& of_group) {
      return "row " + std::to_string(row) + (of_group.empty() ? "" : " and group " + of_group);
    };
    problems.push_back("session " + std::to_string(session.session) + " of participant " +
                       session.participant + ": it has " + text(session.counterbalance_row, group) +
                       ", and its place " + std::to_string(*place) + " has " +
                       text(expected.counterbalance_row, expected.group) +
                       "; restore the study from a copy");
  }
  return problems;
}

}  // namespace asperity
