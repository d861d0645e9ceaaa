// Makes the sentences of a text for a paper about contact times and response times.

#pragma once

#include <string>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/report/text/report_paper.h"

namespace asperity {

/// How the times were modelled; empty where no model has a fit.
std::string exploration_method(const AnalysisOutcome& outcome, Sources& sources);

/// The tests of conditions, and the change over trials, blocks and sessions as a factor with its CI; empty where no model
/// has a fit.
std::string exploration_results(const AnalysisOutcome& outcome);

}  // namespace asperity
