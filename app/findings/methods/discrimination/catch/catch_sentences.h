// Reports the responses in catch trials in sentences for a paper.

#pragma once

#include <string>

#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// " Of 24 responses in catch trials, 23 were correct (75 % to 100 % for single participants)."; a sentence per type, from the
/// table `kCatchTrials`. Empty without one.
std::string catch_trials_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
