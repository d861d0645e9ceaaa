#include "app/findings/reading_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/findings/reading_number.h"

namespace asperity {

namespace {

constexpr std::string_view kLow = "_low";
constexpr std::string_view kHigh = "_high";

/// Whether no number in this column can exceed 1.
bool is_bounded(const std::string& column) {
  constexpr std::array<std::string_view, 5> kBounded{"chance_", "clopper_pearson", "r_squared",
                                                     "share", "wilson"};
  return std::any_of(kBounded.begin(), kBounded.end(),
                     [&column](std::string_view each) { return column.starts_with(each); });
}

/// A proportion to two decimals, a force to a millinewton, a length to ten micrometres, a p as in
/// running text. Numbers that two decimals do not show have three significant digits.
std::string reading_cell_number(const std::string& column, double value) {
  if (column == "p" || column == "p_holm" || column == "p_smallest" || column == "p_interior")
    return reading_p_cell(value);
  if (column == "chance") return reading_bounded(value, 3);
  if (is_bounded(column)) return reading_bounded(value);
  if (column.ends_with("_N")) return reading_signed(value, 3);
  if (column.ends_with("_m") || column.ends_with("_m_low")) return reading_signed(value, 5);
  constexpr double kRounding = 1e-7;  // of sums and of iterations
  const double size = std::abs(value);
  const bool is_estimate = column.starts_with("raw") || column.starts_with("normalised");
  if (size > kRounding && size < (is_estimate ? 0.095 : 0.005)) return reading_quantity(value, "1");
  return reading_signed(value, 2);
}

std::string reading_cell(const std::string& column, const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return reading_cell_number(column, *number);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return reading_whole(*whole);
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return "n/a";
}

}  // namespace

std::optional<std::size_t> column_of(const Table& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) return {};
  return static_cast<std::size_t>(found - table.columns.begin());
}

std::optional<double> number_of(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  return {};
}

bool has_cells(const Table& table, const std::string& column) {
  const std::optional<std::size_t> at = column_of(table, column);
  return at && std::any_of(table.rows.begin(), table.rows.end(),
                           [&at](const std::vector<Cell>& row) { return row[*at] != Cell{}; });
}

void drop_empty_columns(Table& table, std::size_t kept) {
  if (table.rows.empty()) return;
  for (std::size_t column = table.columns.size(); column-- > kept;) {
    const bool is_empty =
        std::all_of(table.rows.begin(), table.rows.end(), [column](const std::vector<Cell>& row) {
          return std::holds_alternative<std::monostate>(row[column]);
        });
    if (!is_empty) continue;
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.columns.erase(table.columns.begin() + at);
    for (std::vector<Cell>& row : table.rows) row.erase(row.begin() + at);
  }
}

Table reading_table(const Table& table) {
  Table reading{};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& name = table.columns[i];
    if (name.ends_with(kHigh)) continue;
    reading.columns.push_back(
        name.ends_with(kLow) ? name.substr(0, name.size() - kLow.size()) + " 95 %" : name);
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<Cell>& cells = reading.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& name = table.columns[i];
      if (name.ends_with(kHigh)) continue;
      const bool is_interval = name.ends_with(kLow) && i + 1 < row.size();
      if (std::holds_alternative<std::monostate>(row[i])) {
        cells.emplace_back();
      } else if (is_interval) {
        cells.emplace_back('[' + reading_cell(name, row[i]) + ", " +
                           reading_cell(name, row[i + 1]) + ']');
      } else if (std::holds_alternative<double>(row[i])) {
        cells.emplace_back(reading_cell(name, row[i]));
      } else {
        cells.push_back(row[i]);
      }
    }
  }
  return reading;
}

}  // namespace asperity
