// Counts the participants of each study in the order of its sessions; a merged session counts in every study that it was in.

#include "app/study_files/group_places.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "app/study_files/dealt_places.h"
#include "app/study_files/session_origins.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

/// A session at its place in the order of a study.
struct OrderedSession {
  std::int64_t id = 0;  ///< of the session in that study
  const SessionRow* session = nullptr;
  bool is_assigned_there = false;  ///< otherwise it was there already
  std::optional<int> dealt{};
};

/// By SessionOrigin::key, this study under an empty one.
std::map<std::string, std::vector<OrderedSession>> sessions_by_study(
    const Study& study, const std::vector<SessionRow>& sessions) {
  std::map<std::string, std::vector<OrderedSession>> by_study{};
  for (const SessionRow& session : sessions) {
    if (!session.group_level || session.mode == SessionMode::simulate) continue;
    const std::vector<EventRow> events = study.events(session.id);
    const std::optional<int> dealt = dealt_place(events);
    const std::vector<SessionOrigin> origins = session_origins(events);
    by_study[""].push_back({session.id, &session, origins.empty(), dealt});
    for (const SessionOrigin& origin : origins) {
      by_study[origin.key].push_back(
          {origin.session_id, &session, &origin == &origins.front(), dealt});
    }
  }
  for (auto& [key, ordered] : by_study) {
    std::sort(
        ordered.begin(), ordered.end(),
        [](const OrderedSession& one, const OrderedSession& other) { return one.id < other.id; });
  }
  return by_study;
}

}  // namespace

std::vector<GroupPlace> group_places(const Study& study, const std::vector<SessionRow>& sessions) {
  std::map<std::int64_t, std::string> names{};
  for (const ProtocolRow& row : study.protocols()) names[row.id] = row.name;
  std::vector<GroupPlace> places{};
  for (const auto& [key, ordered] : sessions_by_study(study, sessions)) {
    struct First {
      const SessionRow* session = nullptr;
      std::size_t before = 0;
    };
    std::map<std::pair<std::string, SessionMode>, std::map<std::string, First>> firsts{};
    for (const OrderedSession& one : ordered) {
      const SessionRow& session = *one.session;
      auto& of_protocol = firsts[{names.at(session.protocol_id), session.mode}];
      const std::size_t before = of_protocol.size();
      const First& first =
          of_protocol.try_emplace(session.participant, First{&session, before}).first->second;
      if (!one.is_assigned_there) continue;
      places.push_back({&session, first.session, key, first.before, one.dealt});
    }
  }
  return places;
}

}  // namespace asperity
