// Makes the tables of a discrimination.

#pragma once

#include <vector>

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// Appends the tables of all tasks.
void add_discrimination_tables(const GatheredAnswers& gathered,
                               const std::vector<DiscriminationResults>& all,
                               AnalysisOutcome& outcome);

}  // namespace asperity
