// Makes the figures of a discrimination: thresholds and psychometric functions.

#pragma once

#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// Of the table of mean thresholds: the thresholds by condition, with those of the participants.
std::vector<Figure> threshold_figures(const ResultTable& means, const AnalysisOutcome& outcome);
/// Of the table of the responses by level: the psychometric functions of each participant.
std::vector<Figure> function_figures(const ResultTable& responses, const AnalysisOutcome& outcome);

}  // namespace asperity
