// The analysis of the kind "matching".

#pragma once

#include "app/findings/study/study_analysis.h"

namespace asperity {

/// Which picture was assigned to which texture: whole permutations (chance 1/m!) and single items
/// (chance 1/m, tested against random permutations, because the items of one trial depend on each other).
void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

const StudyAnalysis& matching_analysis();

}  // namespace asperity
