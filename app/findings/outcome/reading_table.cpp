// Chooses the decimals of a column by its narrowest interval, and joins the limits of intervals in one cell.

#include "app/findings/outcome/reading_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "app/findings/outcome/reading_number.h"

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

/// Whether the numbers are test statistics or their degrees of freedom.
bool is_statistic(const std::string& column) {
  constexpr std::array<std::string_view, 8> kStatistics{"F",   "chi_squared", "deviance", "df",
                                                        "df1", "df2",         "t",        "z"};
  return std::find(kStatistics.begin(), kStatistics.end(), column) != kStatistics.end();
}

/// Whether the numbers of a column have digits that do not depend on the others: p as in running text, a force to a millinewton, a
/// length of 0.1 mm or more to ten micrometres, a proportion or a test statistic to two decimals.
std::optional<std::string> fixed_digits(const std::string& column, double value) {
  if (column == "p" || column == "p_holm" || column == "p_smallest" || column == "p_interior")
    return reading_p_cell(value);
  if (column == "chance") return reading_bounded(value, 3);
  if (is_bounded(column)) return reading_bounded(value);
  if (is_statistic(column)) return reading_signed(value, 2);
  if (column.ends_with("_N")) return reading_signed(value, 3);
  constexpr double kShortest_m = 1e-4;
  const bool is_length = column.ends_with("_m") || column.ends_with("_m_low");
  if (is_length && (value == 0.0 || std::abs(value) >= kShortest_m))
    return reading_signed(value, 5);
  return {};
}

/// A column whose rows are of different quantities.
bool is_mixed(const std::string& quantity) {
  constexpr std::array<std::string_view, 3> kMixed{"effect", "statistic", "value"};
  return std::find(kMixed.begin(), kMixed.end(), quantity) != kMixed.end();
}

/// "x" of "x_low", "x_high" and "x_se", which are printed with the digits of x.
std::string quantity_of(const std::string& column) {
  for (const std::string_view ending : {kLow, kHigh, std::string_view("_se")}) {
    if (column.ends_with(ending)) return column.substr(0, column.size() - ending.size());
  }
  return column;
}

constexpr double kRoundingOfNumbers = 1e-7;  // of sums and of iterations

/// Estimates of participants, whose scales may be of any size.
bool is_estimate(const std::string& quantity) {
  return quantity.starts_with("raw") || quantity.starts_with("normalised");
}

/// Whether two decimals do not show the number.
bool needs_more_digits(const std::string& quantity, double size) {
  return size > kRoundingOfNumbers && size < (is_estimate(quantity) ? 0.095 : 0.005);
}

/// Three significant digits, or two decimals where these show the number.
std::string own_digits(const std::string& column, double value) {
  return needs_more_digits(column, std::abs(value)) ? reading_quantity(value, "1")
                                                    : reading_signed(value, 2);
}

/// By quantity, the decimals that all of its numbers have: those of the narrowest interval and the smallest standard error, or
/// without these those of the smallest number. In a mixed column, each row has those of its interval.
class DecimalsOfColumns final {
 public:
  explicit DecimalsOfColumns(const Table& table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      for (std::size_t row = 0; row < table.rows.size(); ++row) add(table, row, i);
    }
  }
  std::string text(const std::string& column, std::size_t row, double value) const {
    const std::string quantity = quantity_of(column);
    const Digits& digits = digits_.at(key_of(quantity, row));
    const int decimals = digits.of_intervals.value_or(digits.of_numbers);
    const double unit = std::pow(10.0, -decimals);
    // More digits than a reader can compare, and numbers of which these decimals show nothing, or one digit of the largest.
    constexpr double kMostDigits = 5.0;
    const double before_point = std::floor(std::log10(std::max(digits.largest, 0.1))) + 1.0;
    const bool is_wide = decimals > 2 && before_point + decimals > kMostDigits;
    const bool is_small = digits.largest > kRoundingOfNumbers && digits.largest < 9.95 * unit;
    const bool hides =
        !digits.of_intervals && std::abs(value) > kRoundingOfNumbers && std::abs(value) < unit;
    // The most decimals show one digit of the smallest number, so that 4.6e-05 and 5.2e-05 would look the same.
    const bool shows_one_digit = !digits.of_intervals && digits.smallest < 9.95 * unit;
    const bool is_single = is_mixed(quantity) && !digits.of_intervals;
    return is_wide || is_small || hides || shows_one_digit || is_single
               ? own_digits(column, value)
               : reading_signed(value, decimals);
  }

 private:
  struct Digits {
    std::optional<int> of_intervals{};
    int of_numbers = 2;
    double largest = 0.0;
    double smallest =
        std::numeric_limits<double>::infinity();  ///< of those that need more than two decimals
  };

  using Key = std::pair<std::string, std::size_t>;
  static Key key_of(const std::string& quantity, std::size_t row) {
    return {quantity, is_mixed(quantity) ? row : 0};
  }

  void add(const Table& table, std::size_t at, std::size_t i) {
    const std::vector<std::string>& columns = table.columns;
    const std::vector<Cell>& row = table.rows[at];
    const auto* const value = std::get_if<double>(&row[i]);
    if (value == nullptr) return;
    const std::string quantity = quantity_of(columns[i]);
    Digits& digits = digits_[key_of(quantity, at)];
    if (!std::isfinite(*value)) return;
    digits.largest = std::max(digits.largest, std::abs(*value));
    const auto hold = [&digits](double size) {
      if (size > kRoundingOfNumbers)
        digits.of_intervals = std::max(digits.of_intervals.value_or(2), decimals_of(size));
    };
    if (columns[i].ends_with("_se")) return hold(*value);
    const bool is_interval = columns[i].ends_with(kLow) && i + 1 < row.size();
    const auto* const high = is_interval ? std::get_if<double>(&row[i + 1]) : nullptr;
    if (high != nullptr) return hold(*high - *value);
    const double size = std::abs(*value);
    if (!needs_more_digits(quantity, size)) return;
    digits.smallest = std::min(digits.smallest, size);
    const double of_three = is_estimate(quantity) ? 0.1 : 1.0;  // three digits instead of two
    digits.of_numbers = std::max(digits.of_numbers, decimals_of(of_three * size));
  }

  std::map<Key, Digits> digits_{};
};

/// A cell of the row with this index.
std::string reading_cell(const std::string& column, const Cell& cell,
                         const DecimalsOfColumns& decimals, std::size_t at) {
  if (const auto* number = std::get_if<double>(&cell)) {
    if (const auto text = fixed_digits(column, *number)) return *text;
    return decimals.text(column, at, *number);
  }
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
  const DecimalsOfColumns decimals(table);
  for (std::size_t at = 0; at < table.rows.size(); ++at) {
    const std::vector<Cell>& row = table.rows[at];
    std::vector<Cell>& cells = reading.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& name = table.columns[i];
      if (name.ends_with(kHigh)) continue;
      const bool is_interval = name.ends_with(kLow) && i + 1 < row.size();
      if (std::holds_alternative<std::monostate>(row[i])) {
        cells.emplace_back();
      } else if (is_interval) {
        cells.emplace_back('[' + reading_cell(name, row[i], decimals, at) + ", " +
                           reading_cell(name, row[i + 1], decimals, at) + ']');
      } else if (std::holds_alternative<double>(row[i])) {
        cells.emplace_back(reading_cell(name, row[i], decimals, at));
      } else {
        cells.push_back(row[i]);
      }
    }
  }
  return reading;
}

}  // namespace asperity
