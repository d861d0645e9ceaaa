// A study in words, tables and figures: for a methods section and a lab meeting.

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/findings/study/analysis_outcome.h"
#include "app/report/text/report.h"
#include "results_schema/study.h"

namespace asperity {

/// What draws on an outcome: app/figures/figures_of.h, or nothing where there is no Qt.
using FiguresOfOutcome = std::function<std::vector<Figure>(const AnalysisOutcome&)>;

/// A chapter about the study, then one per protocol, version and group of participants: design,
/// participants, sessions and exclusions, results, exploration, presentation and what it was made
/// with; then an appendix to each: further tables and figures, tests and numbers, and every session.
/// With a `protocol` only the chapters of that name. Of a protocol that is running with a person now, the results are held back: whoever runs it is blind.
///
/// The same study gives the same report. When asked to stop, what there is by then; `progress` is
/// told 0 to 1.
///
/// Errors: ResultsError, also when the study has no session of the named protocol.
Report study_report(const Study& study, const FiguresOfOutcome& figures_of,
                    const std::optional<std::string>& protocol = {},
                    const std::stop_token& stop = {},
                    const std::function<void(double)>& progress = {});

}  // namespace asperity
