// Tests phase, catch trials and repetition first, then the state of the attempt.

#include "results_schema/analysis_use.h"

#include "results_schema/rows.h"

namespace asperity {

AnalysisUse use_in_analyses(std::string_view phase, int repetition, bool is_catch) noexcept {
  if (phase != "main") return AnalysisUse::practice;
  if (is_catch) return AnalysisUse::catch_trial;
  return repetition == 0 ? AnalysisUse::anchor : AnalysisUse::counted;
}

AnalysisUse use_in_analyses(const PlannedTrialRow& trial) noexcept {
  return use_in_analyses(trial.phase, trial.repetition, trial.is_catch);
}

AnalysisUse use_in_analyses(AnalysisUse of_trial, const AttemptState& attempt) noexcept {
  if (of_trial != AnalysisUse::counted) return of_trial;
  if (!attempt.valid) return AnalysisUse::invalid;
  if (!attempt.answered) return AnalysisUse::unanswered;
  return attempt.excluded ? AnalysisUse::excluded : AnalysisUse::counted;
}

AnalysisUse use_in_analyses(const PlannedTrialRow& trial, const AttemptRow& attempt) noexcept {
  return use_in_analyses(use_in_analyses(trial), {.valid = attempt.valid,
                                                  .answered = !attempt.responses.empty(),
                                                  .excluded = attempt.excluded.has_value()});
}

}  // namespace asperity
