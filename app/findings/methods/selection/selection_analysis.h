// Analyses the kind "selection".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Which rendering was chosen as the most realistic: counts and proportions of each item (chance is
/// 1 divided by the number felt), and each pair of items among the choices of either. "Cannot tell"
/// is counted and is not part of the proportions.
void analyze_selection(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_selection(const GatheredAnswers& gathered);

}  // namespace asperity
