// The choices of the target of a selection over repetitions.

#pragma once

#include "app/analyses/analysis_outcome.h"
#include "app/analyses/selection_choices.h"

namespace asperity {

/// How reliable the participants' proportions of choices of the target are over repetitions. Without a declared target,
/// or where not every trial presents every model, there is no such proportion, and a finding gives that as the status.
void ask_target_choices(const Selection& selection, AnalysisOutcome& outcome);

}  // namespace asperity
