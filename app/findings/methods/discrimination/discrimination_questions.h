// The questions of a discrimination, with their answers in a sentence.

#pragma once

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

/// Once the tests are finished: how large the thresholds are, whether the point of subjective equality differs from the
/// standard, whether thresholds differ between conditions, and whether the order of presentation matters.
void ask_discrimination(const DiscriminationResults& results, const StudyTests& tests,
                        AnalysisOutcome& outcome);

}  // namespace asperity
