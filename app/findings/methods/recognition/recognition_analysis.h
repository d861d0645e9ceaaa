// Analyses the kind "recognition".

#pragma once

#include <vector>

#include "app/findings/outcome/study_analysis.h"

namespace asperity {

/// Which picture was chosen for the texture felt: chance is 1 divided by the number of pictures
/// shown.
void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_recognition(const GatheredAnswers& gathered);

}  // namespace asperity
