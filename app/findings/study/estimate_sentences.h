// What a study estimated, in words that a paper prints before its tests.

#pragma once

#include <string>

#include "app/findings/study/analysis_outcome.h"

namespace asperity {

/// In English; empty of kinds whose tests state their estimates (matching, recognition).
struct EstimateSentence {
  std::string text{};
  bool has_mean_interval = false;  ///< the CI of a mean proportion
};

/// Of a selection: "Mean proportions of choices were 83 % (95 % CI [49 %, 96 %]) for height_map and 17 % (…) for sinusoid, N =
/// 6; the chance level was 50 %.", where every trial presented every item.
EstimateSentence choices_sentence(const AnalysisOutcome& outcome);
/// Of a magnitude: the mean exponents.
EstimateSentence exponents_sentence(const AnalysisOutcome& outcome);

/// That of the kind of the outcome.
EstimateSentence estimate_sentence(const AnalysisOutcome& outcome);

}  // namespace asperity
