// Analyses magnitude estimates of stimuli of any sort: by stimulus, and by a physical predictor of the stimuli.

#pragma once

#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_test.h"

namespace asperity {

/// Geometric means by stimulus and condition, their analysis of variance, and with a predictor P (a level, a declared
/// value, or a measured property) the power function
///
///   log₁₀ estimate = a + n·log₁₀ P
///
/// by least squares per participant: the exponent n is the mean over the participants, with a t-based CI and a t test
/// against 0. A predictor that is not above 0 for every stimulus is not used, which a remark states.
void analyze_stimulus_estimates(const GatheredAnswers& gathered, AnalysisOutcome& outcome);
/// The tests of its family alone (StudyAnalysis::test_family).
std::vector<StudyTest> test_stimulus_estimates(const GatheredAnswers& gathered);

}  // namespace asperity
