// Makes the tables of a discrimination.

#pragma once

#include <vector>

#include "app/findings/study/analysis_outcome.h"
#include "app/findings/study/discrimination_results.h"

namespace asperity {

/// Appends the tables of all tasks.
void add_discrimination_tables(const GatheredAnswers& gathered,
                               const std::vector<DiscriminationResults>& all,
                               AnalysisOutcome& outcome);

}  // namespace asperity
