// Which results of an analysis compare women and men.

#pragma once

#include "app/findings/study/analysis_outcome.h"

namespace asperity {

/// Without what is about women or men: their test and question, their findings, and their rows in tables that also
/// have a row of all participants. A report compares sexes only where the protocol declares it.
AnalysisOutcome without_sexes(AnalysisOutcome outcome);

}  // namespace asperity
