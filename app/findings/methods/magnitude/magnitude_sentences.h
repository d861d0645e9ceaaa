// Reports the peaks and exponents of a magnitude estimation in sentences for a paper.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/estimate_sentences.h"

namespace asperity {

/// Results: the spacings of maximum roughness, and the mean exponents of the conditions without one.
EstimateSentence exponents_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
