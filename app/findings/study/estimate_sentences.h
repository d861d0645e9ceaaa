// Reports the estimates of a study in sentences, which a paper prints before its tests.

#pragma once

#include <string>

#include "app/findings/study/analysis_outcome.h"

namespace asperity {

/// In English; empty for kinds whose tests state their estimates (matching, recognition).
struct EstimateSentence {
  std::string text{};
  bool has_mean_interval = false;  ///< the 95 % CI is that of a mean proportion
};

/// For a selection: "Mean proportions of choices were 83 % (95 % CI [49 %, 96 %]) for height_map
/// and 17 % (…) for sinusoid, N = 6; the chance level was 50 %.", where every trial presented every
/// item.
EstimateSentence choices_sentence(const AnalysisOutcome& outcome);
/// For a magnitude: the mean exponents.
EstimateSentence exponents_sentence(const AnalysisOutcome& outcome);

/// The sentence of the outcome's kind.
EstimateSentence estimate_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
