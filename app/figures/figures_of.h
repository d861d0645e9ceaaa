// The figures of an analysis: its findings and tables as marks on axes. Nothing is computed anew.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/findings/figure.h"
#include "app/findings/study/analysis_outcome.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// In the order in which they are read; the first one goes with the answer. A figure that the data
/// cannot fill says so in `instead`. Empty for a kind without figures.
std::vector<Figure> figures_of(const AnalysisOutcome& outcome);

/// Of the findings of a family (tidy_families.h) about `input`. `level_unit`: of the spacings or
/// levels in its table, as SI writes it; empty where nobody has said.
std::vector<Figure> figures_of(const std::string& family, const TidyInput& input,
                               std::span<const Finding> findings,
                               const std::string& level_unit = {});

}  // namespace asperity
