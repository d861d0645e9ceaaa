// Translates a stored attempt to the outcome and the answer that a course takes, and replays all of them.

#include "app/session/trial_outcome.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/study_files/parameter_json.h"
#include "protocols/design/block_factors.h"

namespace asperity {

TrialOutcome outcome_of(const Protocol& protocol, const Trial& trial, const AttemptRow& attempt) {
  const Protocol::Block& block = protocol.blocks.at(trial.block);
  const Dimension& dimension = block.vary.value();
  const bool is_timeout = attempt.outcome == AttemptOutcome::timed_out;
  if (attempt.outcome != AttemptOutcome::answered && !is_timeout) return {};
  const auto varied = std::find_if(
      attempt.presentations.begin(), attempt.presentations.end(),
      [&dimension](const PresentationRow& surface) { return surface.role == dimension.role; });
  if (varied == attempt.presentations.end()) return {};
  const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
  if (judged == nullptr) return {};
  const auto response =
      std::find_if(attempt.responses.begin(), attempt.responses.end(),
                   [&](const ResponseRow& row) { return row.question == judged->name; });
  // A deadline may also be missed at a later question of the trial.
  const bool is_missing = response == attempt.responses.end();
  if (is_missing && !(is_timeout && block.procedure.value().timeouts_are_incorrect)) return {};
  // The relative amplitude is not a parameter of the model: what is stored as rendered is its product with the amplitude.
  const double value =
      dimension.is_relative_amplitude()
          ? std::get<double>(trial.factors.at(dimension.factor))
          : number_of(parameter_values_in(varied->parameters_json), dimension.parameter);
  const LevelOutcome outcome =
      is_missing ? LevelOutcome::incorrect
                 : level_outcome_of(block, *judged, varied->item,
                                    {.answer = response->answer, .correct = response->correct});
  return {.answer = TrialOutcome::Answer{.value = value, .outcome = outcome}};
}

std::optional<LevelAnswer> level_answer_of(const Protocol& protocol, const Trial& trial,
                                           const AttemptRow& attempt) {
  const TrialOutcome outcome = outcome_of(protocol, trial, attempt);
  if (!outcome.answer) return std::nullopt;
  const Dimension& dimension = protocol.blocks.at(trial.block).vary.value();
  return LevelAnswer{.level = dimension.level_of(outcome.answer->value),
                     .outcome = outcome.answer->outcome};
}

AttemptNumbers set_aside_in(const std::vector<DecisionRow>& decisions) {
  AttemptNumbers numbers{};
  for (const DecisionRow& decision : decisions) {
    if (decision.verdict == Verdict::set_aside) {
      numbers.emplace(decision.trial.value_or(0), decision.attempt.value_or(0));
    }
  }
  return numbers;
}

void advance_through(Course& course, const Protocol& protocol,
                     const std::vector<AttemptRow>& attempts, const AttemptNumbers& set_aside,
                     SuppliedSteps supplied) {
  while (!course.is_complete()) {
    if (course.requested()) {
      if (!supplied.supply(course)) return;
      continue;
    }
    const Trial* const trial = course.awaited();
    const auto first =
        std::find_if(attempts.begin(), attempts.end(), [&](const AttemptRow& attempt) {
          return attempt.trial == trial->ordinal && attempt.purpose == AttemptPurpose::trial &&
                 (attempt.valid || attempt.outcome == AttemptOutcome::skipped ||
                  set_aside.contains({attempt.trial, attempt.attempt}));
        });
    if (first == attempts.end()) break;
    course.advance(outcome_of(protocol, *trial, *first));
  }
  if (supplied.left() == 0) return;
  throw std::runtime_error(
      "more levels of an external program are stored than the responses of the session request; "
      "restore the study from a copy");
}

}  // namespace asperity
