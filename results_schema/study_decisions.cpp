// What people decided about the data of a study.

#include "results_schema/attempt_rows.h"
#include "results_schema/study.h"
#include "results_schema/study_store.h"

namespace asperity {
void Study::add_decision(std::int64_t session_id, const DecisionRow& decision) {
  Statement(store_->writable(),
            "INSERT INTO decision (session_id, trial, attempt, verdict, reason, reason_json, "
            "decided_by, decided_utc) VALUES (?, ?, ?, ?, ?, ?, ?, "
            "coalesce(nullif(?, ''), strftime('%Y-%m-%dT%H:%M:%fZ', 'now')))")
      .bind(session_id, decision.trial, decision.attempt, text_of(decision.verdict),
            decision.reason, decision.decided_by, decision.decided_utc)
      .run();
}

std::vector<DecisionRow> Study::decisions(std::int64_t session_id) const {
  return store_->read([session_id](Database& database) {
    Statement statement(
        database,
        "SELECT trial, attempt, verdict, reason, reason_json, decided_by, decided_utc "
        "FROM decision WHERE session_id = ? ORDER BY id");
    statement.bind(session_id);
    std::vector<DecisionRow> rows;
    while (statement.step()) {
      DecisionRow& row = rows.emplace_back();
      std::string verdict;
      statement.read(row.trial, row.attempt, verdict, row.reason, row.decided_by, row.decided_utc);
      row.verdict = enum_of(verdict, kVerdicts, "decision.verdict");
    }
    return rows;
  });
}

void Study::set_aside(std::int64_t session_id, int trial, int attempt, const StoredWords& reason) {
  add_decision(session_id, {.trial = trial,
                            .attempt = attempt,
                            .verdict = Verdict::set_aside,
                            .reason = reason,
                            .decided_by = "experimenter"});
}

}  // namespace asperity
