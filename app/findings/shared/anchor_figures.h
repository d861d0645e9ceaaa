// Makes the figures of responses to anchors.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// Responses to anchors by their place in a run, a figure for each row of the table of their change, `trend`: the means, and a
/// line for each run of a participant.
std::vector<Figure> anchor_figures(const ResultTable& trend, const AnalysisOutcome& outcome);

}  // namespace asperity
