// Makes the figures of a discrimination: thresholds, psychometric functions and tracks.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// Of a discrimination: the thresholds by condition, and the tracks and psychometric functions of each participant. None
/// without the tables of thresholds.
std::vector<Figure> threshold_figures(const AnalysisOutcome& outcome);

}  // namespace asperity
