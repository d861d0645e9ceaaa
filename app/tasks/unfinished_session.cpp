#include "app/tasks/unfinished_session.h"

#include <algorithm>

#include "app/conductor/session_setup.h"

namespace asperity {

std::optional<UnfinishedSession> unfinished_session(const Study& study, const Protocol& protocol,
                                                    const std::string& participant,
                                                    std::optional<std::int64_t> id) {
  const std::optional<SessionRow> row = unfinished_row(study, protocol, participant, id);
  if (!row) return {};
  return UnfinishedSession{
      .row = *row,
      .trials_done =
          static_cast<int>(trials_done(study.attempts(row->id), study.decisions(row->id)).size()),
      .trials = static_cast<int>(study.plan(row->id).size()),
  };
}

std::set<int> trials_done(const std::vector<AttemptRow>& attempts,
                          const std::vector<DecisionRow>& decisions) {
  std::set<int> done{};
  for (const AttemptRow& attempt : attempts) {
    const bool is_set_aside =
        std::any_of(decisions.begin(), decisions.end(), [&attempt](const DecisionRow& decision) {
          return decision.verdict == Verdict::set_aside && decision.trial == attempt.trial &&
                 decision.attempt == attempt.attempt;
        });
    if (attempt.valid || (attempt.outcome == AttemptOutcome::skipped && !is_set_aside)) {
      done.insert(attempt.trial);
    }
  }
  return done;
}

}  // namespace asperity
