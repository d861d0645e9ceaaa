// The analyses, one per kind of protocol: answers in, tables and findings out.

#pragma once

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/gathered_answers.h"

namespace asperity {

/// Which rendering was chosen as the most realistic: counts and shares of each model, chance 1 of
/// as many as were felt; each pair of models among the choices of either. `cannot_tell` is counted
/// and takes no part in the shares of the models.
void analyze_selection(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// Which picture goes with which felt texture: whole permutations (chance 1/m!) and single items
/// (chance 1/m, judged against random permutations, because the items of one go are not
/// independent).
void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// Which picture was felt: chance 1 of as many as were shown.
void analyze_recognition(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// How rough a surface feels, as a number: curves over spacings for each condition, their peaks, and
/// the analysis of variance of the logarithms. Each participant's own scale is taken out first.
void analyze_magnitude(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity
