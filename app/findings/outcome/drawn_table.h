// Reads the tables of an outcome for its figures.

#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/reading_table.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The unit in which a quantity is drawn, with its value in the stored unit.
struct DrawnUnit {
  std::string text{};
  double size = 1.0;
};
/// Metres as µm, mm or m, by the greatest absolute value.
DrawnUnit drawn_unit(const std::string& unit, double greatest);

/// Null where the outcome has no such table.
const NamedTable* table_named(const AnalysisOutcome& outcome, const char* name);

/// Letters and digits, the others as underscores.
std::string figure_file_name(std::string text);

/// The cells of a row by the name of their column.
class RowOfTable final {
 public:
  RowOfTable(const Table& table, const std::vector<Cell>& row) : table_(table), row_(row) {}
  Cell cell(const std::string& column) const {
    const auto at = column_of(table_, column);
    return at ? row_[*at] : Cell{};
  }
  std::string text(const std::string& column) const {
    const Cell content = cell(column);
    const auto* const words = std::get_if<std::string>(&content);
    return words == nullptr ? std::string() : *words;
  }
  std::optional<double> number(const std::string& column) const { return number_of(cell(column)); }

 private:
  const Table& table_;
  const std::vector<Cell>& row_;
};

}  // namespace asperity
