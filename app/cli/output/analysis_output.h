// An analysis as a person reads it on a terminal, and as a program reads it.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// Heading, remarks, questions with their answers, then every table with its title: numbers with the digits that mean something,
/// intervals in brackets.
std::string display_text_of(const AnalysisOutcome& outcome);

/// One JSON document, "asperity.analysis/1": all digits, missing is null.
std::string analysis_json(const std::string& study, std::span<const AnalysisOutcome> outcomes);

/// The findings of tables that belong to no study.
struct TableFindings {
  std::string kind{};
  std::vector<std::string> files{};
  std::vector<Finding> findings{};
};

/// Tables with a row per key and a column per quantity, no wider than a terminal; below them every
/// sentence of a status that is not "ok", and what each quantity is.
std::string display_text_of(const TableFindings& findings);

/// One JSON document, "asperity.findings/1".
std::string findings_json(const TableFindings& findings);

}  // namespace asperity
