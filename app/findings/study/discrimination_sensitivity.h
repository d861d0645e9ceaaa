// Sensitivity by level: hits and false alarms, d′ and the criterion of every participant.

#pragma once

#include <vector>

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/discrimination_results.h"

namespace asperity {

/// The tables, and the analysis of the findings of the first.
inline constexpr const char* kSensitivity = "sensitivity";
inline constexpr const char* kResponsesByPair = "responses_by_pair";

/// Adds, for the tasks with correct responses whose levels did not depend on the responses:
///
///   sensitivity        the findings of the family `dprime` (id: condition and level), a row for every participant,
///                      condition and level; where options are words, a question about the mean d′. Where a surface is
///                      chosen, hits and false alarms are the responses "the first" with the comparison first and second;
///                      otherwise "yes" or "different" with and without a signal, the latter of all levels of the
///                      condition together.
///   responses_by_pair  same–different: the responses to every ordered pair of surfaces
///
/// A proportion over levels that a procedure chose depends on the procedure and is not stated.
void add_sensitivity(const GatheredAnswers& gathered, const std::vector<DiscriminationResults>& all,
                     AnalysisOutcome& outcome);

}  // namespace asperity
