// Reads the tables of an outcome for its figures.

#pragma once

#include <string>

#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The unit in which a quantity is drawn, with its value in the stored unit.
struct DrawnUnit {
  std::string text{};
  double size = 1.0;
};
/// Metres as µm, mm or m, by the greatest absolute value.
DrawnUnit drawn_unit(const std::string& unit, double greatest);

/// Null where the outcome has no such table.
const ResultTable* table_named(const AnalysisOutcome& outcome, const char* name);

/// Letters and digits, the others as underscores.
std::string figure_file_name(std::string text);

}  // namespace asperity
