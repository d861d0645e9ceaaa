// Analyses the kind "magnitude".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Perceived roughness as a number: curves over spacings for each condition, their peaks, and the
/// analysis of variance of the logarithms. Each participant's scale is removed first.
void analyze_magnitude(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_magnitude(const GatheredAnswers& gathered);

}  // namespace asperity
