// Analyses the kind "rating".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Ratings on one or more scales, each on its own: mean ratings of the items, tests between them, and
/// the agreement of the participants. A participant's ratings of an item are averaged over its trials
/// first. Scales that accompany a question of another kind are reported apart (accompanying_scales.h).
void analyze_rating(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_ratings(const GatheredAnswers& gathered);

}  // namespace asperity
