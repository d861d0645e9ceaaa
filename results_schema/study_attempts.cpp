// Attempts of a study, with everything that hangs on them.

#include "results_schema/attempt_rows.h"
#include "results_schema/files/file_system.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

void insert_presentations(Database& database, std::int64_t attempt_id,
                          const std::vector<PresentationRow>& rows) {
  Statement statement(database,
                      "INSERT INTO presentation (attempt_id, position, role, item, stimulus, "
                      "model, model_version, texture, parameters_json, seed, onset_ns, contact_ns, "
                      "offset_ns, contact_s, matched_texture_force_N, achieved_texture_force_N, "
                      "stiffness_N_per_m, friction, raised_m, gaps_in_contact) "
                      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement asset(database, "INSERT INTO presentation_asset VALUES (?, ?, ?, ?)");
  Statement limit(database, "INSERT INTO model_limit VALUES (?, ?, ?, ?)");
  Statement instability(
      database, "INSERT INTO instability VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement visit(database, "INSERT INTO visit VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const PresentationRow& row : rows) {
    statement
        .bind(attempt_id, row.position, row.role, row.item, row.stimulus, row.model,
              row.model_version, row.texture, row.parameters_json, row.seed, row.onset_ns,
              row.contact_ns, row.offset_ns, row.contact_s, row.matched_texture_force_N,
              row.achieved_texture_force_N, row.stiffness_N_per_m, row.friction, row.raised_m,
              row.gaps_in_contact)
        .run();
    for (const AssetRow& each : row.assets) {
      asset.bind(attempt_id, row.position, each.role, each.sha256).run();
    }
    for (const ModelLimitRow& each : row.limits) {
      limit.bind(attempt_id, row.position, each.kind, each.ticks).run();
    }
    if (const auto& judged = row.instability) {
      instability
          .bind(attempt_id, row.position, judged->buzz, judged->buzz_force_N, judged->buzz_ns,
                judged->no_buzz, judged->resting_s, judged->alive_force_N,
                judged->alive_plate_force_N, judged->alive_motion_m, judged->alive_work_J,
                judged->no_aliveness, judged->crest_share, judged->slow_s, judged->no_crest_share)
          .run();
    }
    int number = 0;
    for (const VisitRow& each : row.visits) {
      visit
          .bind(attempt_id, row.position, ++number, each.contact_ns, each.offset_ns, each.contact_s,
                each.path_m, each.force_mean_N, each.force_sd_N, each.speed_mean_m_per_s,
                each.speed_sd_m_per_s)
          .run();
    }
  }
}

void insert_responses(Database& database, std::int64_t attempt_id,
                      const std::vector<ResponseRow>& rows) {
  Statement statement(database,
                      "INSERT INTO response (attempt_id, question, item, answer, answer_number, "
                      "correct, options_json, time_ns, from_contact_s, from_cue_s, source) "
                      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const ResponseRow& row : rows) {
    statement
        .bind(attempt_id, row.question, row.item, row.answer, row.answer_number, row.correct,
              row.options_json, row.time_ns, row.from_contact_s, row.from_cue_s, row.source)
        .run();
  }
}

void insert_servo(Database& database, std::int64_t attempt_id, const ServoQualityRow& row) {
  Statement(database,
            "INSERT INTO servo_quality VALUES "
            "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(attempt_id, row.rate_Hz, row.ticks, row.period_mean_s, row.period_sd_s,
            row.period_p50_s, row.period_p99_s, row.period_p99_9_s, row.period_maximum_s,
            row.lateness_p50_s, row.lateness_p99_s, row.lateness_maximum_s, row.execution_p99_s,
            row.execution_maximum_s, row.missed_deadlines, row.saturated_ticks,
            row.slew_limited_ticks, row.not_finite_ticks, row.lost_records, row.fault,
            row.missed_in_contact, row.gaps_in_contact, row.held_readings)
      .run();
}

void insert_compliance(Database& database, std::int64_t attempt_id,
                       const std::vector<ComplianceRow>& rows) {
  Statement statement(database,
                      "INSERT INTO compliance (attempt_id, position, quantity, minimum, maximum, "
                      "mean, sd, p05, p50, p95, fraction_in_band, passed) "
                      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const ComplianceRow& row : rows) {
    statement
        .bind(attempt_id, row.position, row.quantity, row.minimum, row.maximum, row.mean, row.sd,
              row.p05, row.p50, row.p95, row.fraction_in_band, row.passed)
        .run();
  }
}

void insert_events(Database& database, std::int64_t session_id, std::int64_t attempt_id,
                   const std::vector<EventRow>& rows) {
  Statement statement(database,
                      "INSERT INTO event (session_id, attempt_id, time_ns, kind, text, data_json, "
                      "text_json) VALUES (?, ?, ?, ?, ?, ?, nullif(?, ''))");
  for (const EventRow& row : rows) {
    statement
        .bind(session_id, attempt_id, row.time_ns, row.kind, row.text, row.data_json, row.text_json)
        .run();
  }
}

void read_presentations(Database& database, const std::string& which, std::int64_t key,
                        Attempts& attempts) {
  Statement statement(
      database,
      "SELECT attempt_id, position, role, item, stimulus, model, model_version, texture, "
      "parameters_json, seed, onset_ns, contact_ns, offset_ns, contact_s, "
      "matched_texture_force_N, achieved_texture_force_N, stiffness_N_per_m, friction, raised_m, "
      "gaps_in_contact FROM presentation WHERE " +
          which + " ORDER BY attempt_id, position");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    PresentationRow row;
    statement.read(id, row.position, row.role, row.item, row.stimulus, row.model, row.model_version,
                   row.texture, row.parameters_json, row.seed, row.onset_ns, row.contact_ns,
                   row.offset_ns, row.contact_s, row.matched_texture_force_N,
                   row.achieved_texture_force_N, row.stiffness_N_per_m, row.friction, row.raised_m,
                   row.gaps_in_contact);
    attempts.of(id).presentations.push_back(std::move(row));
  }
}

void read_assets(Database& database, const std::string& which, std::int64_t key,
                 Attempts& attempts) {
  Statement statement(
      database, "SELECT attempt_id, position, role, sha256 FROM presentation_asset WHERE " + which +
                    " ORDER BY attempt_id, position, role");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    AssetRow row;
    statement.read(id, position, row.role, row.sha256);
    for (PresentationRow& presentation : attempts.of(id).presentations) {
      if (presentation.position == position) presentation.assets.push_back(row);
    }
  }
}

void read_limits(Database& database, const std::string& which, std::int64_t key,
                 Attempts& attempts) {
  Statement statement(database, "SELECT attempt_id, position, kind, ticks FROM model_limit WHERE " +
                                    which + " ORDER BY attempt_id, position, kind");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    ModelLimitRow row;
    statement.read(id, position, row.kind, row.ticks);
    for (PresentationRow& presentation : attempts.of(id).presentations) {
      if (presentation.position == position) presentation.limits.push_back(row);
    }
  }
}

void read_visit_rows(Database& database, const std::string& which, std::int64_t key,
                     Attempts& attempts) {
  Statement statement(database,
                      "SELECT attempt_id, position, contact_ns, offset_ns, contact_s, path_m, "
                      "force_mean_N, force_sd_N, speed_mean_m_per_s, speed_sd_m_per_s "
                      "FROM visit WHERE " +
                          which + " ORDER BY attempt_id, position, visit");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    VisitRow row;
    statement.read(id, position, row.contact_ns, row.offset_ns, row.contact_s, row.path_m,
                   row.force_mean_N, row.force_sd_N, row.speed_mean_m_per_s, row.speed_sd_m_per_s);
    for (PresentationRow& presentation : attempts.of(id).presentations) {
      if (presentation.position == position) presentation.visits.push_back(row);
    }
  }
}

void read_instability(Database& database, const std::string& which, std::int64_t key,
                      Attempts& attempts) {
  Statement statement(
      database,
      "SELECT attempt_id, position, buzz, buzz_force_N, buzz_ns, no_buzz, resting_s, "
      "alive_force_N, alive_plate_force_N, alive_motion_m, alive_work_J, no_aliveness, "
      "crest_share, slow_s, no_crest_share FROM instability WHERE " +
          which + " ORDER BY attempt_id, position");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    int position = 0;
    InstabilityRow row;
    statement.read(id, position, row.buzz, row.buzz_force_N, row.buzz_ns, row.no_buzz,
                   row.resting_s, row.alive_force_N, row.alive_plate_force_N, row.alive_motion_m,
                   row.alive_work_J, row.no_aliveness, row.crest_share, row.slow_s,
                   row.no_crest_share);
    for (PresentationRow& presentation : attempts.of(id).presentations) {
      if (presentation.position == position) presentation.instability = row;
    }
  }
}

void read_responses(Database& database, const std::string& which, std::int64_t key,
                    Attempts& attempts) {
  Statement statement(database,
                      "SELECT attempt_id, question, item, answer, answer_number, correct, "
                      "options_json, time_ns, from_contact_s, from_cue_s, source FROM response "
                      "WHERE " +
                          which + " ORDER BY id");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    ResponseRow row;
    statement.read(id, row.question, row.item, row.answer, row.answer_number, row.correct,
                   row.options_json, row.time_ns, row.from_contact_s, row.from_cue_s, row.source);
    attempts.of(id).responses.push_back(std::move(row));
  }
}

void read_servo(Database& database, const std::string& which, std::int64_t key,
                Attempts& attempts) {
  Statement statement(database, "SELECT * FROM servo_quality WHERE " + which);
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    ServoQualityRow row;
    statement.read(id, row.rate_Hz, row.ticks, row.period_mean_s, row.period_sd_s, row.period_p50_s,
                   row.period_p99_s, row.period_p99_9_s, row.period_maximum_s, row.lateness_p50_s,
                   row.lateness_p99_s, row.lateness_maximum_s, row.execution_p99_s,
                   row.execution_maximum_s, row.missed_deadlines, row.saturated_ticks,
                   row.slew_limited_ticks, row.not_finite_ticks, row.lost_records, row.fault,
                   row.missed_in_contact, row.gaps_in_contact, row.held_readings);
    attempts.of(id).servo = std::move(row);
  }
}

void read_compliance(Database& database, const std::string& which, std::int64_t key,
                     Attempts& attempts) {
  Statement statement(database,
                      "SELECT attempt_id, position, quantity, minimum, maximum, mean, sd, p05, "
                      "p50, p95, fraction_in_band, passed FROM compliance WHERE " +
                          which + " ORDER BY id");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    ComplianceRow row;
    statement.read(id, row.position, row.quantity, row.minimum, row.maximum, row.mean, row.sd,
                   row.p05, row.p50, row.p95, row.fraction_in_band, row.passed);
    attempts.of(id).compliance.push_back(std::move(row));
  }
}

void read_recordings(Database& database, const std::string& which, std::int64_t key,
                     Attempts& attempts) {
  Statement statement(
      database,
      "SELECT attempt_id, path, format, sha256, records, bytes FROM recording WHERE " + which);
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    RecordingRow row;
    statement.read(id, row.path, row.format, row.sha256, row.records, row.bytes);
    attempts.of(id).recording = std::move(row);
  }
}

void read_events(Database& database, const std::string& which, std::int64_t key,
                 Attempts& attempts) {
  Statement statement(database,
                      "SELECT attempt_id, time_ns, kind, text, data_json, coalesce(text_json, '') "
                      "FROM event WHERE " +
                          which + " ORDER BY id");
  statement.bind(key);
  while (statement.step()) {
    std::int64_t id = 0;
    EventRow row;
    statement.read(id, row.time_ns, row.kind, row.text, row.data_json, row.text_json);
    attempts.of(id).events.push_back(std::move(row));
  }
}

/// `which` selects attempts by the one parameter `key`.
std::vector<AttemptRow> read_attempts(Database& database, const std::string& which,
                                      std::int64_t key) {
  Attempts attempts = read_bare_attempts(database, which, key);
  const std::string hanging = "attempt_id IN (SELECT id FROM attempt WHERE " + which + ")";
  read_presentations(database, hanging, key, attempts);
  read_assets(database, hanging, key, attempts);
  read_limits(database, hanging, key, attempts);
  read_visit_rows(database, hanging, key, attempts);
  read_instability(database, hanging, key, attempts);
  read_responses(database, hanging, key, attempts);
  read_servo(database, hanging, key, attempts);
  read_compliance(database, hanging, key, attempts);
  read_recordings(database, hanging, key, attempts);
  read_events(database, hanging, key, attempts);
  return std::move(attempts).in_order();
}

}  // namespace

std::int64_t Study::add_attempt(std::int64_t session_id, const AttemptRow& attempt) {
  Database& database = store_->writable();
  Transaction transaction(database);
  Statement(database,
            "INSERT INTO attempt (session_id, trial, attempt, segment, outcome, valid, "
            "invalid_reason, invalid_reason_json, flagged, flag_reason, flag_reason_json, "
            "onset_ns, offset_ns, purpose) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(session_id, attempt.trial, attempt.attempt, attempt.segment,
            text_of(attempt.outcome == AttemptOutcome::emergency_stop ? AttemptOutcome::device_fault
                                                                      : attempt.outcome),
            attempt.valid, attempt.invalid_reason, attempt.flagged, attempt.flag_reason,
            attempt.onset_ns, attempt.offset_ns, text_of(attempt.purpose))
      .run();
  const std::int64_t id = database.last_row_id();
  insert_presentations(database, id, attempt.presentations);
  insert_responses(database, id, attempt.responses);
  if (attempt.servo) insert_servo(database, id, *attempt.servo);
  insert_compliance(database, id, attempt.compliance);
  if (attempt.recording) {
    const RecordingRow& row = *attempt.recording;
    path_in_study(store_->folder, row.path);
    Statement(database, "INSERT INTO recording VALUES (?, ?, ?, ?, ?, ?)")
        .bind(id, row.path, row.format, row.sha256, row.records, row.bytes)
        .run();
  }
  insert_events(database, session_id, id, attempt.events);
  transaction.commit();
  return id;
}

std::vector<AttemptRow> Study::attempts(std::int64_t session_id) const {
  return store_->read([session_id](Database& database) {
    return read_attempts(database, "session_id = ?1", session_id);
  });
}

std::optional<AttemptRow> Study::attempt(std::int64_t id) const {
  return store_->read([id](Database& database) {
    std::optional<AttemptRow> found;
    for (AttemptRow& row : read_attempts(database, "id = ?1", id)) found = std::move(row);
    return found;
  });
}

std::vector<PluginUse> Study::plugin_uses() const {
  return store_->read([](Database& database) {
    Statement statement(database,
                        "SELECT model, model_version, sha256, count(DISTINCT attempt_id) FROM "
                        "presentation JOIN presentation_asset USING (attempt_id, position) WHERE "
                        "presentation_asset.role = ? GROUP BY 1, 2, 3 ORDER BY 1, 2, 3");
    statement.bind(std::string(kPluginRole));
    std::vector<PluginUse> uses;
    while (statement.step()) {
      PluginUse& use = uses.emplace_back();
      statement.read(use.model, use.model_version, use.sha256, use.attempts);
    }
    return uses;
  });
}

StudyWords Study::words() const {
  return store_->read([](Database& database) {
    StudyWords words;
    Statement factors(database, "SELECT DISTINCT factors_json FROM trial ORDER BY 1");
    while (factors.step()) factors.read(words.factors_json.emplace_back());
    const auto pairs = [&database](const char* sql, auto& into) {
      Statement statement(database, sql);
      while (statement.step()) {
        auto& [first, second] = into.emplace_back();
        statement.read(first, second);
      }
    };
    pairs("SELECT DISTINCT model, parameters_json FROM presentation ORDER BY 1, 2",
          words.parameters);
    pairs(
        "SELECT DISTINCT kind, model FROM model_limit JOIN presentation USING (attempt_id, "
        "position) ORDER BY 1, 2",
        words.model_limits);
    pairs(
        "SELECT DISTINCT presentation_asset.role, model FROM presentation_asset JOIN presentation "
        "USING (attempt_id, position) ORDER BY 1, 2",
        words.assets);
    return words;
  });
}

std::int64_t Study::session_of(std::int64_t attempt_id) const {
  return store_->read([attempt_id](Database& database) {
    Statement statement(database, "SELECT session_id FROM attempt WHERE id = ?");
    if (!statement.bind(attempt_id).step()) {
      throw ResultsError("the study " + database.folder().string() +
                             " has no attempt with the id " + std::to_string(attempt_id) +
                             "; run asperity verify on the study",
                         database.folder());
    }
    std::int64_t session_id = 0;
    statement.read(session_id);
    return session_id;
  });
}

}  // namespace asperity
