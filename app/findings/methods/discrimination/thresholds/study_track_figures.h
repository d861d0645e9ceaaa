// Makes the figures of the tracks of a study.

#pragma once

#include <vector>

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/result_table.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The tracks of each participant, from the table of the trials of a discrimination.
std::vector<Figure> track_figures(const ResultTable& table, const AnalysisOutcome& outcome);

}  // namespace asperity
