// The choices of the target of a selection: over repetitions, and beyond its textures.

#pragma once

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/selection_choices.h"

namespace asperity {

/// How reliable the participants' proportions of choices of the target are over repetitions, and whether the
/// proportion holds for other participants and textures. Where not every trial presents every model there is no such
/// proportion, and the findings give that as the status; so does the reliability without a declared target.
void ask_target_choices(const Selection& selection, AnalysisOutcome& outcome);

}  // namespace asperity
