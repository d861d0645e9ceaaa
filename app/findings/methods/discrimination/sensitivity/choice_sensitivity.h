// Sensitivity of choices among three surfaces, from the proportion correct at each level.

#pragma once

#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"

namespace asperity {

/// The table of d′ by participant, condition and level; absent without such a task.
inline constexpr const char* kSensitivityOfChoices = "sensitivity_of_choices";

/// Of every task of three surfaces whose levels no procedure chose, the findings of the family `dprime` (analysis
/// `sensitivity`, key "CONDITION|LEVEL|PARTICIPANT") and their table: d′ of three alternatives by `ForcedChoice`; of an oddity
/// task by both rules of `Oddity`. The question `sensitivity` states the means over the participants.
void add_choice_sensitivity(const GatheredAnswers& gathered,
                            const std::vector<DiscriminationResults>& all,
                            AnalysisOutcome& outcome);

}  // namespace asperity
