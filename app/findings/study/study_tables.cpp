// Joins statistics, effects and units of a row in single cells, then formats the table like any other.

#include "app/findings/study/study_tables.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/methods/discrimination/choice_model.h"
#include "app/findings/methods/discrimination/sensitivity/choice_sensitivity.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/reading_number.h"
#include "app/findings/outcome/reading_table.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/exploration.h"
#include "app/findings/shared/exploration_model.h"

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

/// Quantities with the prefix of their unit, "12.3 µm", and without the columns of units and parameters; a
/// table of another name is unchanged.
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

/// Looks up cells by the name of their column.
class TestRow final {
 public:
  TestRow(const Table& table, const std::vector<Cell>& row) : table_(table), row_(row) {}

  /// Missing where there is no such column.
  Cell cell(const std::string& column) const {
    const std::optional<std::size_t> at = column_of(table_, column);
    return at ? row_[*at] : Cell{};
  }
  std::string text(const std::string& column) const {
    const Cell content = cell(column);
    const auto* text = std::get_if<std::string>(&content);
    return text == nullptr ? std::string() : *text;
  }
  std::optional<double> number(const std::string& column) const { return number_of(cell(column)); }

 private:
  const Table& table_;
  const std::vector<Cell>& row_;
};

/// The code of the test, and after a stroke the number of permutations, as `words_of_cell` reads
/// it.
Cell method_cell(const TestRow& row) {
  const std::string permutations = row.text("permutations");
  if (permutations.empty()) return row.cell("method");
  return row.text("method") + '|' + permutations;
}

/// The code of the test, and after a stroke its subject.
Cell test_cell(const TestRow& row) {
  const std::string about = row.text("about");
  return row.text("test") + (about.empty() ? "" : '|' + about);
}

/// The number, and after a stroke its unit; missing where nothing was tested.
Cell n_cell(const TestRow& row) {
  const double n = row.number("n").value_or(0.0);
  return n > 0.0 ? Cell{fixed(n, 0) + '|' + row.text("unit")} : Cell{};
}

/// "F(2, 38) = 5.17", "F(1.54, 29.18) = 5.17, ε = .77"
Cell statistic_cell(const TestRow& row) {
  const std::optional<double> value = row.number("value");
  if (!value) return {};
  std::vector<double> degrees{};
  for (const char* column : {"df1", "df2"}) {
    if (const std::optional<double> df = row.number(column)) degrees.push_back(*df);
  }
  return statistic_text(row.text("statistic"), degrees, *value, row.number("epsilon"));
}

/// "d = 2.74 [1.75, 3.71]"
Cell effect_cell(const TestRow& row) {
  const std::optional<double> value = row.number("effect");
  if (!value) return {};
  return effect_text(row.text("effect_size"), *value,
                     {.low = row.number("effect_low"), .high = row.number("effect_high")});
}

/// Combines statistics with their degrees of freedom, and effect sizes with their intervals, in one
/// cell each.
Table with_joined_cells(const Table& tests) {
  Table made{{"test", "method", "n", "statistic", "effect_size", "p", "p_holm", "p_smallest",
              "role", "status"},
             {}};
  for (const std::vector<Cell>& cells : tests.rows) {
    const TestRow row(tests, cells);
    made.rows.push_back({test_cell(row), method_cell(row), n_cell(row), statistic_cell(row),
                         effect_cell(row), row.cell("p"), row.cell("p_holm"),
                         row.cell("p_smallest"), row.cell("role"), row.cell("status")});
  }
  drop_empty_columns(made, 1);
  return made;
}

}  // namespace

Table reading_table(const NamedTable& table) {
  if (name_without_ending(table.name) == StudyTests::kTable)
    return reading_table(with_joined_cells(table.table));
  const bool is_of_exploration = table.name == kExploration || table.name == kExplorationForces ||
                                 table.name == kExplorationModel;
  return reading_table(is_of_exploration ? with_exploration_as_read(table)
                                         : with_quantities(table));
}

}  // namespace asperity
