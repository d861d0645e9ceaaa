// The question whether the position of a surface affects the choices of a discrimination, with its answer in a sentence.

#pragma once

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_tests.h"

namespace asperity {

/// Once the tests are finished: of two alternatives the difference between the proportions of choices of the comparison in both
/// positions, of three surfaces the proportions of choices of each. No question of a design whose responses are words.
void ask_order_effect(const DiscriminationResults& results, const StudyTests& tests,
                      AnalysisOutcome& outcome);

}  // namespace asperity
