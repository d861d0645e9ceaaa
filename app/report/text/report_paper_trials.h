// The surfaces, practice and order of trials in a text for a paper.

#pragma once

#include <string>

#include "app/report/text/report_paper.h"

namespace asperity {

/// The parameters of the force models as they were rendered: "The parameters of the force model were: amplitude 50 µm to
/// 100 µm, wavelength 2.5 mm."; empty where none were stored.
std::string paper_parameters(const ReportFacts& facts);

/// The two functions below require a protocol that can be read.
///
/// Visits, intervals, exposures and what is drawn for each presentation.
std::string paper_arrangement(const Protocol& protocol);
/// The number and order of trials, breaks, the exploration, practice and feedback.
std::string paper_order(const ReportFacts& facts, Sources& sources);

}  // namespace asperity
