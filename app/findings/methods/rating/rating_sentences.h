// Reports how the agreement, reliability and dimensions of ratings were analysed, in sentences for a paper.

#pragma once

#include <string>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/estimate_sentences.h"

namespace asperity {

/// Methods: intraclass correlations, reliability over repetitions, Cronbach's alpha and principal components, of those that the
/// outcome contains. Publications are cited by their keys in brackets.
std::string rating_methods_text(const AnalysisOutcome& outcome);

/// Results: agreement and reliability on each scale, Cronbach's alpha of each construct, and the first principal component.
EstimateSentence rating_estimates_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
