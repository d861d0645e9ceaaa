// An analysis as a person reads it on a terminal, and as a program reads it.

#pragma once

#include <span>
#include <string>

#include "app/analyses/analysis_outcome.h"

namespace asperity {

/// Heading, remarks, then every table with its title: numbers with the digits that mean something,
/// intervals in brackets.
std::string reading_text_of(const AnalysisOutcome& outcome);

/// One JSON document, "asperity.analysis/1": all digits, missing is null.
std::string analysis_json(const std::string& study, std::span<const AnalysisOutcome> outcomes);

}  // namespace asperity
