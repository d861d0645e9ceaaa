#include "app/findings/study/table_quantities.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/findings/reading_table.h"
#include "app/findings/study/catch_exclusions.h"
#include "app/findings/study/choice_model.h"
#include "app/findings/study/choice_sensitivity.h"
#include "app/findings/study/confidence_roc.h"
#include "app/findings/study/discrimination_results.h"
#include "app/findings/study/discrimination_sensitivity.h"

namespace asperity {

namespace {

/// Columns of some tables whose unit is in another column of the row.
struct ColumnsWithUnit {
  std::set<std::string> tables{};
  std::string unit{};               ///< the column of the unit
  std::set<std::string> columns{};  ///< with those of their limits, "…_low" and "…_high"
};

const std::array<ColumnsWithUnit, 4>& columns_with_units() {
  static const std::array<ColumnsWithUnit, 4> kColumns{
      ColumnsWithUnit{{kThresholds, kMeanThresholds, kPsychometric, kTracks, kSensitivity,
                       kSensitivityOfChoices, kConfidenceRoc},
                      "unit",
                      {"pse", "jnd", "jnd_dprime1", "jnd_posterior", "mean", "geometric_mean",
                       "level", "difference"}},
      ColumnsWithUnit{{kChoiceModel}, "unit", {"sd"}},
      ColumnsWithUnit{{kStimulusEstimates}, "predictor_unit", {"predictor"}},
      ColumnsWithUnit{{kStimulusEstimates, kEstimatesOfPersons}, "stimulus_unit", {"stimulus"}}};
  return kColumns;
}

/// A number, or a level that is stored as text.
std::optional<double> quantity_in(const Cell& cell) {
  const auto* const text = std::get_if<std::string>(&cell);
  return text == nullptr ? number_of(cell) : number_in(*text);
}

void write_quantities(const ColumnsWithUnit& of, Table& table) {
  const std::optional<std::size_t> unit = column_of(table, of.unit);
  if (!unit) return;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::string name = table.columns[column];
    for (const std::string end : {"_low", "_high"}) {
      if (name.ends_with(end)) name.erase(name.size() - end.size());
    }
    if (!of.columns.contains(name)) continue;
    for (std::vector<Cell>& row : table.rows) {
      const std::optional<double> number = quantity_in(row[column]);
      const auto* const of_row = std::get_if<std::string>(&row[*unit]);
      if (number && of_row != nullptr) row[column] = reading_quantity(*number, *of_row);
    }
  }
}

void drop_column(const std::string& name, Table& table) {
  const std::optional<std::size_t> column = column_of(table, name);
  if (!column) return;
  const auto at = static_cast<std::ptrdiff_t>(*column);
  table.columns.erase(table.columns.begin() + at);
  for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + at);
}

/// "22/500": repetitions without a threshold, of all.
void write_of_repetitions(Table& table) {
  const std::optional<std::size_t> without = column_of(table, "without_threshold");
  const std::optional<std::size_t> repetitions = column_of(table, "repetitions");
  if (!without || !repetitions) return;
  for (std::vector<Cell>& row : table.rows) {
    const std::optional<double> part = number_of(row[*without]);
    const std::optional<double> whole = number_of(row[*repetitions]);
    if (part && whole) row[*without] = reading_number(*part) + '/' + reading_number(*whole);
  }
}

}  // namespace

Table with_quantities(const NamedTable& table) {
  const std::string name = name_without_ending(table.name);
  Table made = table.table;
  for (const ColumnsWithUnit& of : columns_with_units()) {
    if (of.tables.contains(name)) write_quantities(of, made);
  }
  for (const ColumnsWithUnit& of : columns_with_units()) {
    if (!of.tables.contains(name) || !column_of(table.table, of.unit)) continue;
    if (&of == &columns_with_units().front()) {
      write_of_repetitions(made);
      for (const char* const column : {"parameter", "repetitions"}) drop_column(column, made);
    }
    drop_column(of.unit, made);
  }
  return made;
}

}  // namespace asperity
