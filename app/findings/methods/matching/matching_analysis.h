// Analyses the kind "matching".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Which picture was assigned to which texture: complete permutations (chance 1/m!) and single
/// items (chance 1/m, tested by permutation, because the items of one trial depend on each other).
void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_matching(const GatheredAnswers& gathered);

}  // namespace asperity
