// The analysis of the kind "recognition".

#pragma once

#include "app/findings/study/study_analysis.h"

namespace asperity {

/// Which picture was chosen for the texture felt: chance 1 of as many as were shown.
void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

const StudyAnalysis& recognition_analysis();

}  // namespace asperity
