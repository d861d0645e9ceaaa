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

/// For display: quantities with the prefix of their unit, "12.3 µm", and without the columns of units and parameters; a
/// table of another name is unchanged.
Table with_quantities(const NamedTable& table);

}  // namespace asperity
