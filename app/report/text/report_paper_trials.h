// The arrangement, practice and order of trials in a text for a paper.

#pragma once

#include <string>

#include "app/report/text/report_paper.h"

namespace asperity {

/// These functions require a protocol that can be read.
///
/// Visits, intervals, exposures and what is drawn for each presentation.
std::string paper_arrangement(const Protocol& protocol);
/// The number and order of trials, breaks, the exploration, practice and feedback.
std::string paper_order(const ReportFacts& facts, Sources& sources);

}  // namespace asperity
