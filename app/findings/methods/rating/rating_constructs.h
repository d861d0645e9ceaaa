// Reports the internal consistency of the scales of a declared construct.

#pragma once

#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/shared/rated_scales.h"

namespace asperity {

/// Adds Cronbach's alpha of each construct that the protocol declares (`analysis.constructs`), with its scales as test
/// items. Respondents are the combinations of a participant and a rated item, because the construct is to distinguish
/// items as well as participants; the interval is over participants, whose combinations are not independent.
void add_constructs(const GatheredAnswers& gathered, const std::vector<RatedScale>& scales,
                    AnalysisOutcome& outcome);

}  // namespace asperity
