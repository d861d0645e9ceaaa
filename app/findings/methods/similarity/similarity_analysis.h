// The analysis of the kind "similarity".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Rated dissimilarities: configuration and dendrogram of the items, weights of the participants, measured properties.
void analyze_similarity(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_similarity(const GatheredAnswers& gathered);

}  // namespace asperity
