// How reliable participants' results are over the repetitions of an experiment.

#pragma once

#include <cstdint>
#include <span>

#include "app/analyses/analysis_outcome.h"
#include "app/analyses/gathered_answers.h"

namespace asperity {

/// The proportion correct of one trial, or of one answer.
struct RepeatedScore {
  std::uint32_t person = 0;  ///< which of the people
  std::uint32_t column = 0;  ///< word of the repetition; that of the empty text without
  double proportion = 0.0;
};

/// Intraclass correlations of the participants' mean proportions in each repetition. Asks nothing where
/// there are not two repetitions and two participants with both.
void ask_reliability(const GatheredAnswers& gathered, std::span<const RepeatedScore> scores,
                     AnalysisOutcome& outcome);

}  // namespace asperity
