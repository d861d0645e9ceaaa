// Describes how participants explored the surfaces, for every kind of protocol: by condition and over the session.

#pragma once

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The findings, and the tables by condition: of times, strokes and lengths; of forces and speeds.
inline constexpr const char* kExploration = "exploration";
inline constexpr const char* kExplorationForces = "exploration_forces";

/// Adds the tables `exploration`, `exploration_forces` and `exploration_model` (add_exploration_models), over the surfaces of all counted
/// trials: of each participant the median of times, the mean of other quantities; over participants median and
/// quartiles, mean and SD. A description without a test. Quantities that no session stores have a row without numbers.
/// Nothing where no session stores any, and where the questions only accompany others, whose trials are the same.
///
/// The first two are displayed with a row per condition and a column per quantity: "5.17 [4.90, 5.61]" (median and
/// quartiles) or "0.951 (0.021)" (mean and SD).
void add_exploration(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity
