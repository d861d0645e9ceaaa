// Reports the mean thresholds of a discrimination in sentences for a paper.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/estimate_sentences.h"

namespace asperity {

/// The mean thresholds by condition, and after them what qualifies them: thresholds that were not estimated or that the means
/// leave out, unfinished tracks, mean d′, the responses in catch trials, and participants whom a declared rule excluded.
EstimateSentence thresholds_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
