// Sessions of a study: their plans, segments, answers and events.

#include <algorithm>
#include <cerrno>
#include <map>

#include <sqlite3.h>

#include "results_schema/files/file_system.h"
#include "results_schema/study.h"
#include "results_schema/study_places.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

constexpr std::array kModes{SessionMode::run, SessionMode::pilot, SessionMode::simulate};
constexpr std::array kStates{SessionState::open, SessionState::completed, SessionState::stopped,
                             SessionState::crashed};

constexpr const char* kVerify = "; run asperity verify on the study";

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& why) {
  throw ResultsError("the study " + folder.string() + " " + why, folder);
}

std::string named(std::int64_t session_id) {
  return "the session with the id " + std::to_string(session_id);
}

SessionState state_of(Database& database, std::int64_t session_id) {
  Statement statement(database, "SELECT state FROM session WHERE id = ?");
  if (!statement.bind(session_id).step()) {
    refuse(database.folder(), "has no session with the id " + std::to_string(session_id) + kVerify);
  }
  std::string state;
  statement.read(state);
  return enum_of(state, kStates, "session.state");
}

void set_state(Database& database, std::int64_t session_id, SessionState state,
               const std::optional<std::string>& ended_utc) {
  Statement(database, "UPDATE session SET state = ?, ended_utc = ? WHERE id = ?")
      .bind(text_of(state), ended_utc, session_id)
      .run();
}

/// A network file system promises neither locks nor that what was synced is on a disk.
void refuse_network(const std::filesystem::path& folder) {
  const std::string network = network_file_system_at(folder);
  if (!network.empty()) {
    refuse(folder, "lies on a network file system, " + network +
                       ", where a session cannot be stored safely; run it on a local disk and copy "
                       "the study afterwards. The study can be read here");
  }
}

std::vector<int> counts_of(Database& database, const std::string& protocol_name, int rows,
                           const std::optional<SessionMode>& mode,
                           const std::optional<std::string>& group) {
  if (rows < 1) throw std::invalid_argument("the number of rows is 0; it must be at least 1");
  std::optional<std::string> mode_text;
  if (mode) mode_text = text_of(*mode);
  Statement statement(database,
                      "SELECT counterbalance_row, count(*) FROM session "
                      "WHERE protocol_id IN (SELECT id FROM protocol WHERE name = ?1) "
                      "AND state IN ('open', 'completed') AND (?2 IS NULL OR mode = ?2) "
                      "AND (?3 IS NULL OR group_level = ?3) "
                      "AND participant_id NOT IN (SELECT id FROM participant WHERE withdrawn) "
                      "GROUP BY counterbalance_row");
  statement.bind(protocol_name, mode_text, group);
  std::vector<int> counts(static_cast<std::size_t>(rows), 0);
  while (statement.step()) {
    int row = 0;
    int count = 0;
    statement.read(row, count);
    if (row < rows) counts[static_cast<std::size_t>(row)] = count;
  }
  return counts;
}

std::vector<int> participants_of_groups(Database& database, const std::string& protocol_name,
                                        const std::vector<std::string>& groups, SessionMode mode) {
  Statement statement(database,
                      "SELECT count(DISTINCT participant_id) FROM session "
                      "WHERE protocol_id IN (SELECT id FROM protocol WHERE name = ?1) "
                      "AND state IN ('open', 'completed') AND mode = ?2 AND group_level = ?3 "
                      "AND participant_id NOT IN (SELECT id FROM participant WHERE withdrawn)");
  std::vector<int> counts;
  for (const std::string& group : groups) {
    if (statement.bind(protocol_name, text_of(mode), group).step()) {
      statement.read(counts.emplace_back());
    }
    statement.run();
  }
  return counts;
}

std::optional<std::string> earlier_group(Database& database, const std::string& label,
                                         const std::string& protocol_name, SessionMode mode) {
  Statement statement(database,
                      "SELECT group_level FROM session "
                      "JOIN participant ON participant.id = participant_id "
                      "WHERE label = ?1 AND protocol_id IN (SELECT id FROM protocol WHERE name = "
                      "?2) AND mode = ?3 AND group_level NOT NULL ORDER BY session LIMIT 1");
  std::optional<std::string> group;
  if (statement.bind(label, protocol_name, text_of(mode)).step()) statement.read(group);
  return group;
}

/// Every participant who was ever assigned to a group of this protocol, in sessions of one mode.
std::size_t participants_with_a_group(Database& database, const std::string& protocol_name,
                                      SessionMode mode) {
  Statement statement(database,
                      "SELECT count(DISTINCT participant_id) FROM session "
                      "WHERE protocol_id IN (SELECT id FROM protocol WHERE name = ?1) "
                      "AND mode = ?2 AND group_level NOT NULL");
  int count = 0;
  if (statement.bind(protocol_name, text_of(mode)).step()) statement.read(count);
  return static_cast<std::size_t>(count);
}

std::string claimed_group(Database& database, const std::string& protocol_name,
                          const SessionRow& session, const SessionClaim& claim) {
  const std::vector<std::string>& groups = claim.groups;
  if (const auto own = earlier_group(database, session.participant, protocol_name, session.mode)) {
    if (std::find(groups.begin(), groups.end(), *own) != groups.end()) return *own;
    refuse(database.folder(), "has participant " + session.participant + " in the group " + *own +
                                  ", and this version of the protocol " + protocol_name +
                                  " has no such group; add it to the protocol");
  }
  if (claim.group_after) {
    return claim.group_after(participants_with_a_group(database, protocol_name, session.mode));
  }
  const std::vector<int> counts =
      participants_of_groups(database, protocol_name, groups, session.mode);
  return groups[static_cast<std::size_t>(std::min_element(counts.begin(), counts.end()) -
                                         counts.begin())];
}

void insert_session(Database& database, const SessionRow& row, int ordinal,
                    std::int64_t participant_id) {
  Statement(
      database,
      "INSERT INTO session (participant_id, session, protocol_id, mode, state, seed, "
      "generator, counterbalance_row, program_version, program_commit, program_build, "
      "program_sha256, instruction_set, os, device, device_json, pacing, scheduling, rate_Hz, "
      "started_utc, clock_zero_ns, ended_utc, consent_version, consent_utc, observer_json, "
      "mirrored, group_level, expected_trials) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(participant_id, ordinal, row.protocol_id, text_of(row.mode), text_of(row.state),
            row.seed, row.generator, row.counterbalance_row, row.program_version,
            row.program_commit, row.program_build, row.program_sha256, row.instruction_set, row.os,
            row.device, row.device_json, row.pacing, row.scheduling, row.rate_Hz, row.started_utc,
            row.clock_zero_ns, row.ended_utc, row.consent_version, row.consent_utc,
            row.observer_json, row.mirrored, row.group_level, row.expected_trials)
      .run();
}

void insert_plan(Database& database, std::int64_t session_id,
                 const std::vector<PlannedTrialRow>& plan) {
  Statement statement(
      database,
      "INSERT INTO trial (session_id, trial, block, block_ordinal, phase, repetition, "
      "factors_json, plan_json, track, step, is_catch) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const PlannedTrialRow& trial : plan) {
    statement
        .bind(session_id, trial.trial, trial.block, trial.block_ordinal, trial.phase,
              trial.repetition, trial.factors_json, trial.plan_json, trial.track, trial.step,
              trial.is_catch)
        .run();
  }
}

/// Inside the caller's transaction.
std::int64_t insert_session_with_plan(Database& database, const SessionRow& session,
                                      const std::vector<PlannedTrialRow>& plan) {
  std::int64_t participant_id = 0;
  bool has_withdrawn = false;
  Statement participant(database, "SELECT id, withdrawn FROM participant WHERE label = ?");
  if (!participant.bind(session.participant).step()) {
    refuse(database.folder(), "has no participant " + session.participant +
                                  "; add the participant before the session");
  }
  participant.read(participant_id, has_withdrawn);
  if (has_withdrawn) {
    refuse(database.folder(), "has a withdrawal of participant " + session.participant +
                                  "; use another label for the session");
  }
  Statement last(database,
                 "SELECT coalesce(max(session), 0) + 1 FROM session WHERE participant_id = ?");
  int next = 0;
  if (last.bind(participant_id).step()) last.read(next);
  if (session.session != 0 && session.session != next) {
    refuse(database.folder(), "has session " + std::to_string(next) +
                                  " as the next one of participant " + session.participant +
                                  ", not session " + std::to_string(session.session) +
                                  "; begin the next one");
  }
  insert_session(database, session, next, participant_id);
  const std::int64_t id = database.last_row_id();
  Statement file(database, "INSERT INTO session_file VALUES (?, ?, ?, ?)");
  for (const StimulusFileRow& row : session.files) {
    path_in_study(database.folder(), row.path);
    file.bind(id, row.path, row.sha256, row.bytes).run();
  }
  insert_plan(database, id, plan);
  return id;
}

constexpr const char* kSelectSessions =
    "SELECT session.id, participant.label, session.session, protocol_id, mode, state, seed, "
    "generator, counterbalance_row, program_version, program_commit, program_build, "
    "program_sha256, instruction_set, os, device, device_json, pacing, scheduling, rate_Hz, "
    "started_utc, clock_zero_ns, ended_utc, consent_version, consent_utc, observer_json, mirrored, "
    "group_level, expected_trials, iif(latest.verdict = 'exclude', latest.reason, NULL), "
    "latest.reason_json, "
    "participant.withdrawn "
    "FROM session JOIN participant ON participant.id = session.participant_id "
    "LEFT JOIN decision AS latest ON latest.id = (SELECT max(id) FROM decision WHERE session_id = "
    "session.id AND trial IS NULL) ";

void read_session(Statement& statement, SessionRow& row) {
  std::string mode;
  std::string state;
  statement.read(row.id, row.participant, row.session, row.protocol_id, mode, state, row.seed,
                 row.generator, row.counterbalance_row, row.program_version, row.program_commit,
                 row.program_build, row.program_sha256, row.instruction_set, row.os, row.device,
                 row.device_json, row.pacing, row.scheduling, row.rate_Hz, row.started_utc,
                 row.clock_zero_ns, row.ended_utc, row.consent_version, row.consent_utc,
                 row.observer_json, row.mirrored, row.group_level, row.expected_trials,
                 row.excluded, row.withdrawn);
  row.mode = enum_of(mode, kModes, "session.mode");
  row.state = enum_of(state, kStates, "session.state");
}

std::vector<StimulusFileRow> files_of(Database& database, std::int64_t session_id) {
  Statement statement(
      database, "SELECT path, sha256, bytes FROM session_file WHERE session_id = ? ORDER BY path");
  statement.bind(session_id);
  std::vector<StimulusFileRow> rows;
  while (statement.step()) {
    StimulusFileRow& row = rows.emplace_back();
    statement.read(row.path, row.sha256, row.bytes);
  }
  return rows;
}

}  // namespace

void Study::add_trials(std::int64_t session_id, const std::vector<PlannedTrialRow>& trials) {
  Database& database = store_->writable();
  Transaction transaction(database);
  insert_plan(database, session_id, trials);
  transaction.commit();
}

std::int64_t Study::add_session(const SessionRow& session,
                                const std::vector<PlannedTrialRow>& plan) {
  Database& database = store_->writable();
  refuse_network(store_->folder);
  Transaction transaction(database);
  const std::int64_t id = insert_session_with_plan(database, session, plan);
  transaction.commit();
  return id;
}

std::int64_t Study::add_session(
    const SessionRow& session, const SessionClaim& claim,
    const std::function<std::vector<PlannedTrialRow>(const SessionRow&)>& plan_of) {
  Database& database = store_->writable();
  refuse_network(store_->folder);
  Transaction transaction(database);
  Statement protocol_name(database, "SELECT name FROM protocol WHERE id = ?");
  if (!protocol_name.bind(session.protocol_id).step()) {
    refuse(store_->folder,
           "has no protocol with the id " + std::to_string(session.protocol_id) + kVerify);
  }
  std::string name;
  protocol_name.read(name);
  SessionRow row = session;
  std::optional<ClaimedPlace> place;
  if (claim.places.empty()) {
    if (!row.group_level && !claim.groups.empty()) {
      row.group_level = claimed_group(database, name, session, claim);
    }
    const std::vector<int> counts =
        counts_of(database, name, claim.rows, session.mode, row.group_level);
    row.counterbalance_row =
        static_cast<int>(std::min_element(counts.begin(), counts.end()) - counts.begin());
  } else {
    place = claimed_place(database, name, session, claim);
    row.counterbalance_row = place->row;
    if (!row.group_level && !place->group.empty()) row.group_level = place->group;
  }
  const std::int64_t id = insert_session_with_plan(database, row, plan_of(row));
  if (place) add_dealt_event(database, id, row, *place);
  transaction.commit();
  return id;
}

SessionRow Study::session(std::int64_t id) const {
  return store_->read([id](Database& database) {
    Statement statement(database, std::string(kSelectSessions) + "WHERE session.id = ?");
    if (!statement.bind(id).step()) {
      refuse(database.folder(), "has no session with the id " + std::to_string(id) + kVerify);
    }
    SessionRow row;
    read_session(statement, row);
    row.files = files_of(database, id);
    return row;
  });
}

std::vector<SessionRow> Study::sessions() const {
  return store_->read([](Database& database) {
    Statement statement(database, std::string(kSelectSessions) + "ORDER BY label, session.session");
    std::vector<SessionRow> rows;
    while (statement.step()) {
      read_session(statement, rows.emplace_back());
      rows.back().files = files_of(database, rows.back().id);
    }
    return rows;
  });
}

std::vector<PlannedTrialRow> Study::plan(std::int64_t session_id) const {
  return store_->read([session_id](Database& database) {
    Statement statement(
        database,
        "SELECT trial, block, block_ordinal, phase, repetition, track, step, "
        "is_catch, factors_json, plan_json FROM trial WHERE session_id = ? ORDER BY trial");
    statement.bind(session_id);
    std::vector<PlannedTrialRow> rows;
    while (statement.step()) {
      PlannedTrialRow& row = rows.emplace_back();
      statement.read(row.trial, row.block, row.block_ordinal, row.phase, row.repetition, row.track,
                     row.step, row.is_catch, row.factors_json, row.plan_json);
    }
    return rows;
  });
}

std::vector<int> Study::counterbalance_counts(const std::string& protocol_name, int rows) const {
  return store_->read(
      [&](Database& database) { return counts_of(database, protocol_name, rows, {}, {}); });
}

std::vector<int> Study::counterbalance_counts(const std::string& protocol_name, int rows,
                                              SessionMode mode,
                                              const std::optional<std::string>& group) const {
  return store_->read(
      [&](Database& database) { return counts_of(database, protocol_name, rows, mode, group); });
}

std::vector<int> Study::group_counts(const std::string& protocol_name,
                                     const std::vector<std::string>& groups,
                                     SessionMode mode) const {
  return store_->read([&](Database& database) {
    return participants_of_groups(database, protocol_name, groups, mode);
  });
}

std::optional<std::string> Study::group_of_participant(const std::string& label,
                                                       const std::string& protocol_name,
                                                       SessionMode mode) const {
  return store_->read(
      [&](Database& database) { return earlier_group(database, label, protocol_name, mode); });
}

int Study::begin_segment(std::int64_t session_id, std::int64_t time_ns) {
  Database& database = store_->writable();
  refuse_network(store_->folder);
  Transaction transaction(database);
  if (state_of(database, session_id) != SessionState::open) {
    refuse(store_->folder, "has " + named(session_id) + " in the state \"" +
                               text_of(state_of(database, session_id)) +
                               "\"; reopen it before it is resumed");
  }
  Statement last(database,
                 "SELECT coalesce(max(segment), 0) + 1 FROM segment WHERE session_id = ?");
  int segment = 0;
  if (last.bind(session_id).step()) last.read(segment);
  Statement(database, "INSERT INTO segment VALUES (?, ?, ?, NULL, NULL)")
      .bind(session_id, segment, time_ns)
      .run();
  transaction.commit();
  return segment;
}

void Study::end_segment(std::int64_t session_id, int segment, std::int64_t time_ns,
                        const std::string& reason) {
  Database& database = store_->writable();
  Transaction transaction(database);
  Statement(database,
            "UPDATE segment SET ended_ns = ?, end_reason = ? WHERE session_id = ? AND segment = ?")
      .bind(time_ns, reason, session_id, segment)
      .run();
  if (sqlite3_changes(database.handle()) != 1) {
    refuse(store_->folder,
           "has no segment " + std::to_string(segment) + " in " + named(session_id) + kVerify);
  }
  transaction.commit();
}

void Study::end_session(std::int64_t session_id, SessionState state, const std::string& ended_utc) {
  if (state == SessionState::open) {
    throw std::invalid_argument(
        "state is open, and a session cannot end as open; end it as completed, stopped or crashed");
  }
  Database& database = store_->writable();
  Transaction transaction(database);
  if (state_of(database, session_id) != SessionState::open) {
    refuse(store_->folder, "has " + named(session_id) + " in the state \"" +
                               text_of(state_of(database, session_id)) +
                               "\" already; end a session only once");
  }
  set_state(database, session_id, state, ended_utc);
  transaction.commit();
}

void Study::reopen_session(std::int64_t session_id) {
  Database& database = store_->writable();
  refuse_network(store_->folder);
  Transaction transaction(database);
  const SessionState state = state_of(database, session_id);
  if (state != SessionState::stopped && state != SessionState::crashed) {
    refuse(store_->folder,
           "has " + named(session_id) + " in the state \"" + text_of(state) +
               "\"; only a stopped or crashed session can be resumed. Begin a new session");
  }
  set_state(database, session_id, SessionState::open, std::nullopt);
  transaction.commit();
}

std::string Study::session_lock_name(const std::string& participant) {
  return "session-" + participant;
}

std::vector<std::int64_t> Study::mark_crashed_sessions() {
  Database& database = store_->writable();
  std::map<std::string, std::vector<std::int64_t>> open_sessions;
  for (const SessionRow& row : sessions()) {
    if (row.state == SessionState::open) open_sessions[row.participant].push_back(row.id);
  }
  std::vector<std::int64_t> crashed;
  for (const auto& [participant, ids] : open_sessions) {
    std::optional<StudyLock> lock;
    try {
      lock.emplace(store_->folder, session_lock_name(participant));
    } catch (const ResultsError& error) {
      if (error.code() != EAGAIN) throw;
      continue;  // it runs, in another process or elsewhere in this one
    }
    Transaction transaction(database);
    for (const std::int64_t id : ids) {
      if (state_of(database, id) != SessionState::open) continue;  // ended between look and lock
      Statement(database,
                "UPDATE segment SET end_reason = 'crashed' "
                "WHERE session_id = ? AND end_reason IS NULL")
          .bind(id)
          .run();
      set_state(database, id, SessionState::crashed, std::nullopt);
      crashed.push_back(id);
    }
    transaction.commit();
  }
  return crashed;
}

void Study::add_session_answer(std::int64_t session_id, std::span<const ResponseRow> items) {
  Database& database = store_->writable();
  Transaction transaction(database);
  for (const ResponseRow& answer : items) {
    Statement(database,
              "INSERT INTO session_answer (session_id, question, item, answer, answer_number, "
              "correct, options_json, time_ns, from_contact_s, from_cue_s, source) "
              "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(session_id, answer.question, answer.item, answer.answer, answer.answer_number,
              answer.correct, answer.options_json, answer.time_ns, answer.from_contact_s,
              answer.from_cue_s, answer.source)
        .run();
  }
  transaction.commit();
}

std::vector<ResponseRow> Study::session_answers(std::int64_t session_id) const {
  return store_->read([session_id](Database& database) {
    Statement statement(database,
                        "SELECT question, item, answer, answer_number, correct, options_json, "
                        "time_ns, from_contact_s, from_cue_s, source FROM session_answer "
                        "WHERE session_id = ? ORDER BY time_ns, id");
    statement.bind(session_id);
    std::vector<ResponseRow> rows;
    while (statement.step()) {
      ResponseRow& row = rows.emplace_back();
      statement.read(row.question, row.item, row.answer, row.answer_number, row.correct,
                     row.options_json, row.time_ns, row.from_contact_s, row.from_cue_s, row.source);
    }
    return rows;
  });
}

void Study::add_event(std::int64_t session_id, const EventRow& event) {
  Statement(store_->writable(),
            "INSERT INTO event (session_id, time_ns, kind, text, data_json, text_json) "
            "VALUES (?, ?, ?, ?, ?, nullif(?, ''))")
      .bind(session_id, event.time_ns, event.kind, event.text, event.data_json, event.text_json)
      .run();
}

std::vector<EventRow> Study::events(std::int64_t session_id) const {
  return store_->read([session_id](Database& database) {
    Statement statement(database,
                        "SELECT time_ns, kind, text, data_json, coalesce(text_json, '') FROM event "
                        "WHERE session_id = ? AND attempt_id IS NULL ORDER BY time_ns, id");
    statement.bind(session_id);
    std::vector<EventRow> rows;
    while (statement.step()) {
      EventRow& row = rows.emplace_back();
      statement.read(row.time_ns, row.kind, row.text, row.data_json, row.text_json);
    }
    return rows;
  });
}

std::vector<std::string> Study::event_data(const std::string& kind) const {
  return store_->read([&kind](Database& database) {
    Statement statement(
        database, "SELECT data_json FROM event WHERE kind = ? GROUP BY data_json ORDER BY min(id)");
    statement.bind(kind);
    std::vector<std::string> data;
    while (statement.step()) statement.read(data.emplace_back());
    return data;
  });
}

}  // namespace asperity
