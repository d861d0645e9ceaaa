// Analyses the choices of the target of a selection: over repetitions, and over textures.

#pragma once

#include <vector>

#include "analysis/numbers/proportion.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/shared/selection_choices.h"

namespace asperity {

/// The reliability of the participants' proportions of choices of the target over repetitions, and
/// whether the proportion generalises to other participants and textures. Where not every trial
/// presents every model there is no such proportion, and the findings state that in their status;
/// the same applies to the reliability without a declared target.
void ask_target_choices(const Selection& selection, AnalysisOutcome& outcome);

/// Choices of the target and all choices of each of the gathered people, in their order.
std::vector<HitCount> target_choices_of_people(const Selection& selection);

}  // namespace asperity
