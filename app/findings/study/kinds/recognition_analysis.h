// Analyses the kind "recognition".

#pragma once

#include "app/findings/study/study_analysis.h"

namespace asperity {

/// Which picture was chosen for the texture felt: chance is 1 divided by the number of pictures
/// shown.
void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

const StudyAnalysis& recognition_analysis();

}  // namespace asperity
