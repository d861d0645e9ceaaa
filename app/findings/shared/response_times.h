// Describes response times by condition, for every kind of protocol.

#pragma once

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The findings and the table of response times.
inline constexpr const char* kResponseTimes = "response_times";

/// Adds the table of geometric means over participants: of all trials and by what the protocol
/// varies between trials (repetition and texture, or condition and spacing). A description without
/// a test. Where no trial has a response time, adds a remark instead.
void add_response_times(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

}  // namespace asperity
