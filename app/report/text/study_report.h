// Makes the report of a study in text, tables and figures, for a methods section or for discussion.

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/report/text/report.h"
#include "results_schema/study.h"

namespace asperity {

/// A chapter about the study, then one per protocol, version and group of participants: design,
/// participants, sessions and exclusions, results, exploration, presentation, and program and
/// files; then an appendix to each: further tables and figures, tests and numbers, and every
/// session. With a `protocol` only the chapters of that name. The results of a protocol that is
/// currently running with a person are withheld: the experimenter is blind.
///
/// The same study gives the same report. After a stop request, returns the part that is finished;
/// `progress` receives 0 to 1.
///
/// Errors: ResultsError, also when the study has no session of the named protocol.
Report study_report(const Study& study, const std::optional<std::string>& protocol = {},
                    const std::stop_token& stop = {},
                    const std::function<void(double)>& progress = {});

}  // namespace asperity
