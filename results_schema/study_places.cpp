// Reads taken places from events, and takes the first free one of the dealt ranges.

#include "results_schema/study_places.h"

#include <optional>
#include <set>

#include "results_schema/study.h"

namespace asperity {
namespace {

/// The events `dealt` of the protocols of one name, in sessions of one mode.
constexpr const char* kFromDealtEvents =
    "FROM event JOIN session ON session.id = event.session_id "
    "JOIN participant ON participant.id = session.participant_id "
    "WHERE event.kind = ?1 AND session.mode = ?3 "
    "AND session.protocol_id IN (SELECT id FROM protocol WHERE name = ?2) ";

std::optional<ClaimedPlace> own_place(Database& database, const std::string& protocol_name,
                                      const SessionRow& session) {
  Statement statement(
      database, std::string("SELECT json_extract(event.data_json, '$.place'), session.group_level, "
                            "session.counterbalance_row ") +
                    kFromDealtEvents +
                    "AND participant.label = ?4 ORDER BY session.session LIMIT 1");
  statement.bind(kDealtEvent, protocol_name, text_of(session.mode), session.participant);
  if (!statement.step()) return std::nullopt;
  ClaimedPlace place;
  std::optional<std::string> group;
  statement.read(place.place, group, place.row);
  place.group = group.value_or("");
  return place;
}

std::set<int> taken_places(Database& database, const std::string& protocol_name, SessionMode mode,
                           bool keeps_places) {
  Statement statement(database,
                      std::string("SELECT DISTINCT json_extract(event.data_json, '$.place') ") +
                          kFromDealtEvents +
                          "AND (?4 OR (session.state IN ('open', 'completed') "
                          "AND NOT participant.withdrawn))");
  statement.bind(kDealtEvent, protocol_name, text_of(mode), keeps_places);
  std::set<int> taken;
  while (statement.step()) {
    int place = 0;
    statement.read(place);
    taken.insert(place);
  }
  return taken;
}

}  // namespace

ClaimedPlace claimed_place(Database& database, const std::string& protocol_name,
                           const SessionRow& session, const SessionClaim& claim) {
  if (const auto own = own_place(database, protocol_name, session)) return *own;
  const std::set<int> taken =
      taken_places(database, protocol_name, session.mode, claim.keeps_places);
  for (const ClaimedPlace& place : claim.places) {
    const bool is_of_group = !session.group_level || *session.group_level == place.group;
    if (is_of_group && !taken.contains(place.place)) return place;
  }
  const std::filesystem::path& folder = database.folder();
  throw ResultsError(
      "the study " + folder.string() + " has no place left for the protocol " + protocol_name +
          (session.group_level ? " in the group " + *session.group_level : std::string()) +
          ": all of the " + std::to_string(claim.places.size()) +
          " places that are dealt to it, or all of this group, are taken. Deal further places to "
          "it, "
          "which no other station has: asperity metadata " +
          folder.string() + " --deal FROM-TO",
      folder);
}

void add_dealt_event(Database& database, std::int64_t session_id, const SessionRow& session,
                     const ClaimedPlace& place) {
  const std::string number = std::to_string(place.place);
  Statement(database,
            "INSERT INTO event (session_id, time_ns, kind, text, data_json) VALUES (?, ?, ?, ?, ?)")
      .bind(session_id, session.clock_zero_ns, kDealtEvent, number, "{\"place\":" + number + "}")
      .run();
}

}  // namespace asperity
