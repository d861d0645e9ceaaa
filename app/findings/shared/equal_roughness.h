// Adds to an analysis the relative amplitudes at which models were as rough as the reference.

#pragma once

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The findings, and the table of each participant's amplitudes with their status.
inline constexpr const char* kEqualRoughness = "equal_roughness";
/// The table of their geometric means over participants.
inline constexpr const char* kMeanAmplitudes = "equal_roughness_means";

/// Nothing where no surface was matched. The means are over the participants whose amplitude is `matched`; of a
/// participant with several sessions the geometric mean of the sessions counts.
void add_equal_roughness(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity
