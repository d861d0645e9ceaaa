// Removes the results that compare women and men from an analysis.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// Without the test, the question and the findings on women and men, and without their rows in
/// tables that also have a row of all participants. A report compares sexes only where the protocol
/// declares it.
AnalysisOutcome without_sexes(AnalysisOutcome outcome);

}  // namespace asperity
