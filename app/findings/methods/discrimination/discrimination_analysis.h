// Analyses the kind "discrimination".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Choices between a standard and a comparison: psychometric functions and thresholds per participant and condition, their
/// means, the effect of the order of presentation, and tests of the thresholds.
void analyze_discrimination(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_discrimination(const GatheredAnswers& gathered);

}  // namespace asperity
