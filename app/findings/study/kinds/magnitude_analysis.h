// Analyses the kind "magnitude".

#pragma once

#include "app/findings/study/study_analysis.h"

namespace asperity {

/// Perceived roughness as a number: curves over spacings for each condition, their peaks, and the
/// analysis of variance of the logarithms. Each participant's scale is removed first.
void analyze_magnitude(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

const StudyAnalysis& magnitude_analysis();

}  // namespace asperity
