// Analyses all responses of a study.

#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "results_schema/study.h"

namespace asperity {

/// One outcome per protocol, version and group, in that order. With a `protocol`, only those of
/// that name. A study without sessions has none. When `stop` is requested the analysis ends early,
/// and its result is not usable.
/// returns is of no use.
///
/// The first remark of each outcome states whether the study's file was changed (Study::condition).
/// Errors: ResultsError when the study has no session of the named protocol, or is damaged.
std::vector<AnalysisOutcome> analyze_study(const Study& study,
                                           const std::optional<std::string>& protocol = {},
                                           const std::stop_token& stop = {});

}  // namespace asperity
