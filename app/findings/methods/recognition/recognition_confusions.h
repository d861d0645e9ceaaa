// Answers which textures were confused with each other.

#pragma once

#include <vector>

#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/judged_answers.h"

namespace asperity {

/// The pairs confused most often, counted in both directions, and the most frequent confusions in one direction if the
/// pairs do not show them.
void ask_confusions(const GatheredAnswers& gathered, const std::vector<JudgedAnswer>& judged,
                    const RecognitionPictures& pictures, AnalysisOutcome& outcome);

}  // namespace asperity
