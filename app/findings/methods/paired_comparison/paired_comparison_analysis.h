// Analyses the kind "paired_comparison".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Choices between two items: proportions and tests for every pair, the number of comparisons in which each item was
/// chosen (Friedman's test), a Bradley–Terry scale with its order effect, ties and goodness of fit, and the consistency
/// of each participant (circular triads).
void analyze_paired_comparison(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_paired_comparison(const GatheredAnswers& gathered);

}  // namespace asperity
