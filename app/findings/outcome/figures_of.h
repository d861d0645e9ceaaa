// Collects the figures of an analysis from its tables, which declare them.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// In the order of the tables. A figure without sufficient data states that in `instead`.
std::vector<Figure> figures_of(const AnalysisOutcome& outcome);

}  // namespace asperity
