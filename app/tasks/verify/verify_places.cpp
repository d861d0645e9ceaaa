// Compares stored groups and rows with the allocation at each place, and finds places with several stations.

#include "app/tasks/verify/verify_places.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/records/recorded_attempt.h"
#include "app/study_files/dealt_places.h"
#include "app/study_files/session_origins.h"
#include "app/words/text_parts.h"
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

std::map<std::int64_t, std::string> names_of_protocols(const Study& study) {
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& row : study.protocols()) names[row.id] = row.name;
  return names;
}

/// The participants at a place, with the station of each: empty in its own study.
using ParticipantsAtPlace = std::map<std::string, std::string>;

bool has_several_stations(const ParticipantsAtPlace& participants) {
  return std::any_of(participants.begin(), participants.end(), [&](const auto& participant) {
    return participant.second != participants.begin()->second;
  });
}

}  // namespace

std::vector<std::string> place_problems(const Study& study, PlansOfSessions& plans) {
  std::map<std::int64_t, std::string> names = names_of_protocols(study);
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
    problems.push_back(session_name(session) + ": it has " +
                       text(session.counterbalance_row, group) + ", and its place " +
                       std::to_string(*place) + " has " +
                       text(expected.counterbalance_row, expected.group));
  }
  return problems;
}

std::vector<std::string> shared_places(const Study& study) {
  std::map<std::int64_t, std::string> names = names_of_protocols(study);
  std::map<std::string, std::map<int, ParticipantsAtPlace>> places{};  // by protocol
  for (const SessionRow& session : study.sessions()) {
    const bool is_open_or_completed =
        session.state == SessionState::open || session.state == SessionState::completed;
    if (session.mode != SessionMode::run || session.withdrawn || !is_open_or_completed) continue;
    const std::vector<EventRow> events = study.events(session.id);
    const std::optional<int> place = dealt_place(events);
    if (!place) continue;
    const std::vector<SessionOrigin> origins = session_origins(events);
    places[names[session.protocol_id]][*place].try_emplace(
        session.participant, origins.empty() ? "" : origins.front().key);
  }
  std::vector<std::string> warnings{};
  for (const auto& [protocol, participants_at] : places) {
    std::vector<std::string> shared{};
    for (const auto& [place, participants] : participants_at) {
      if (!has_several_stations(participants)) continue;
      std::vector<std::string> labels{};
      for (const auto& [label, station] : participants) labels.push_back(label);
      shared.push_back(std::to_string(place) + " (" + listed(labels) + ')');
    }
    if (shared.empty()) continue;
    warnings.push_back("participants of different stations have the same places of the protocol " +
                       protocol + ": " + listed(shared) +
                       ". Their groups and rows of the counterbalancing are assigned more often "
                       "than planned; all of their data can be analysed. Deal places that no "
                       "station has to further participants (asperity metadata --deal)");
  }
  return warnings;
}

}  // namespace asperity
