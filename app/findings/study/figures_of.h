// Makes the figures of an analysis: its findings and tables as marks on axes, without further
// computation.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// In reading order; the first figure belongs to the main answer. A figure without sufficient data
/// states that in `instead`. Empty for a kind without figures.
std::vector<Figure> figures_of(const AnalysisOutcome& outcome);

/// The figures of a family's findings (tidy_families.h) for `input`. `level_unit`: SI symbol of the
/// unit of the spacings or levels in its table; empty where it is unknown.
std::vector<Figure> figures_of(const std::string& family, const TidyInput& input,
                               std::span<const Finding> findings,
                               const std::string& level_unit = {});

}  // namespace asperity
