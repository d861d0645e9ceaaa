// Attempts, and the decisions that change how they stand.

#include "results_schema/attempt_rows.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "results_schema/study_store.h"

namespace asperity {
namespace {

constexpr std::array kOutcomes{AttemptOutcome::answered,      AttemptOutcome::timed_out,
                               AttemptOutcome::not_compliant, AttemptOutcome::aborted,
                               AttemptOutcome::device_fault,  AttemptOutcome::emergency_stop,
                               AttemptOutcome::skipped};
constexpr std::array kPurposes{AttemptPurpose::trial, AttemptPurpose::refresher};

// The schema counts an emergency stop among the faults; the servo's row tells which one it was.
constexpr const char* kOutcomeAsRead =
    "CASE WHEN outcome = 'device_fault' AND (SELECT fault FROM servo_quality WHERE attempt_id = "
    "attempt.id) = 'emergency_stop' THEN 'emergency_stop' ELSE outcome END";

/// What was decided about attempts, or about their session, in the order of deciding.
void apply_decisions(Database& database, const std::string& which, std::int64_t key,
                     Attempts& attempts) {
  Statement statement(database,
                      "SELECT attempt.id, verdict, reason, reason_json, decision.trial IS NULL "
                      "FROM attempt JOIN decision "
                      "ON decision.session_id = attempt.session_id AND (decision.trial IS NULL OR "
                      "(decision.trial = attempt.trial AND decision.attempt = attempt.attempt)) "
                      "WHERE attempt.id IN (SELECT id FROM attempt WHERE " +
                          which + ") ORDER BY decision.trial IS NULL, decision.id");
  statement.bind(key);
  std::map<std::int64_t, std::optional<StoredWords>> of_session;
  while (statement.step()) {
    std::int64_t id = 0;
    std::string verdict;
    StoredWords reason;
    bool is_of_session = false;
    statement.read(id, verdict, reason, is_of_session);
    AttemptRow& row = attempts.of(id);
    switch (enum_of(verdict, kVerdicts, "decision.verdict")) {
      case Verdict::set_aside:
        row.valid = false;
        row.invalid_reason = joined(row.invalid_reason, set_aside_because(reason));
        break;
      case Verdict::flag:
        row.flagged = true;
        row.flag_reason = joined(row.flag_reason, reason);
        break;
      case Verdict::exclude:
        (is_of_session ? of_session[id] : row.excluded) = reason;
        break;
      case Verdict::include:
        (is_of_session ? of_session[id] : row.excluded).reset();
        break;
    }
  }
  for (const auto& [id, reason] : of_session) {
    if (reason && !attempts.of(id).excluded) attempts.of(id).excluded = reason;
  }
}

}  // namespace

AttemptRow& Attempts::of(std::int64_t id) {
  return *std::lower_bound(
      rows_.begin(), rows_.end(), id,
      [](const AttemptRow& row, std::int64_t wanted) { return row.id < wanted; });
}

std::vector<AttemptRow> Attempts::in_order() && {
  std::sort(rows_.begin(), rows_.end(), [](const AttemptRow& a, const AttemptRow& b) {
    return a.trial != b.trial ? a.trial < b.trial : a.attempt < b.attempt;
  });
  return std::move(rows_);
}

Attempts read_bare_attempts(Database& database, const std::string& which, std::int64_t key) {
  Attempts attempts;
  Statement statement(database,
                      std::string("SELECT id, trial, attempt, segment, ") + kOutcomeAsRead +
                          ", valid, invalid_reason, invalid_reason_json, flagged, flag_reason, "
                          "flag_reason_json, onset_ns, offset_ns, purpose FROM attempt WHERE " +
                          which + " ORDER BY id");
  statement.bind(key);
  while (statement.step()) {
    AttemptRow row;
    std::string outcome;
    std::string purpose;
    statement.read(row.id, row.trial, row.attempt, row.segment, outcome, row.valid,
                   row.invalid_reason, row.flagged, row.flag_reason, row.onset_ns, row.offset_ns,
                   purpose);
    row.purpose = enum_of(purpose, kPurposes, "attempt.purpose");
    row.outcome = enum_of(outcome, kOutcomes, "attempt.outcome");
    attempts.add(std::move(row));
  }
  apply_decisions(database, which, key, attempts);
  return attempts;
}

}  // namespace asperity
