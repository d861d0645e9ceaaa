// Chooses the decimals of a column by its narrowest interval, and joins the limits of intervals in one cell.

#include "app/findings/outcome/displayed_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

constexpr double kRoundingOfNumbers = 1e-7;  // of sums and of iterations

/// Digits that do not depend on the other numbers of the column.
std::optional<std::string> fixed_digits(const ResultColumn& column, double value) {
  constexpr double kShortest_m = 1e-4;
  switch (column.digits) {
    case Digits::p:
      return display_p_cell(value);
    case Digits::chance:
      return column.part == ColumnPart::value ? display_bounded(value, 3) : display_bounded(value);
    case Digits::bounded:
      return display_bounded(value);
    case Digits::statistic:
      return display_signed(value, 2);
    case Digits::force:
      return display_signed(value, 3);
    case Digits::length:
      if (value == 0.0 || std::abs(value) >= kShortest_m) return display_signed(value, 5);
      return {};
    case Digits::of_column:
    case Digits::of_row:
    case Digits::estimate:
      return {};
  }
  return {};
}

/// Whether two decimals do not show the number.
bool needs_more_digits(Digits digits, double size) {
  return size > kRoundingOfNumbers && size < (digits == Digits::estimate ? 0.095 : 0.005);
}

/// Three significant digits, or two decimals where these show the number.
std::string own_digits(Digits digits, double value) {
  return needs_more_digits(digits, std::abs(value)) ? display_quantity(value, "1")
                                                    : display_signed(value, 2);
}

/// By id, the decimals that all of its numbers have: those of the narrowest interval and the smallest standard error, or without
/// these those of the smallest number. In a column whose rows are of different quantities, each row has those of its interval.
class DecimalsOfColumns final {
 public:
  explicit DecimalsOfColumns(const ResultTable& table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        add(table.columns[i], row, table.rows[row][i]);
      }
    }
  }
  std::string text(const ResultColumn& column, std::size_t row, double value) const {
    const Shown& shown = shown_.at(key_of(column, row));
    const int decimals = shown.of_intervals.value_or(shown.of_numbers);
    const double unit = std::pow(10.0, -decimals);
    // More digits than a reader can compare, and numbers of which these decimals show nothing, or one digit of the largest.
    constexpr double kMostDigits = 5.0;
    const double before_point = std::floor(std::log10(std::max(shown.largest, 0.1))) + 1.0;
    const bool is_wide = decimals > 2 && before_point + decimals > kMostDigits;
    const bool is_small = shown.largest > kRoundingOfNumbers && shown.largest < 9.95 * unit;
    const bool hides =
        !shown.of_intervals && std::abs(value) > kRoundingOfNumbers && std::abs(value) < unit;
    // The most decimals show one digit of the smallest number, so that 4.6e-05 and 5.2e-05 would look the same.
    const bool shows_one_digit = !shown.of_intervals && shown.smallest < 9.95 * unit;
    const bool is_single = column.digits == Digits::of_row && !shown.of_intervals;
    return is_wide || is_small || hides || shows_one_digit || is_single
               ? own_digits(column.digits, value)
               : display_signed(value, decimals);
  }

 private:
  struct Shown {
    std::optional<int> of_intervals{};
    int of_numbers = 2;
    double largest = 0.0;
    double smallest =
        std::numeric_limits<double>::infinity();  ///< of those that need more than two decimals

    void hold(double size) {
      if (size > kRoundingOfNumbers)
        of_intervals = std::max(of_intervals.value_or(2), decimals_of(size));
    }
    void note_size(double value) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
  };

  using Key = std::pair<std::string, std::size_t>;
  static Key key_of(const ResultColumn& column, std::size_t row) {
    return {column.id, column.digits == Digits::of_row ? row : 0};
  }

  void add(const ResultColumn& column, std::size_t row, const ResultCell& cell) {
    Shown& shown = shown_[key_of(column, row)];
    if (const auto* const interval = std::get_if<Interval>(&cell)) {
      for (const auto& limit : {interval->low, interval->high}) {
        if (limit) shown.note_size(*limit);
      }
      if (interval->low && interval->high) shown.hold(*interval->high - *interval->low);
      return;
    }
    const auto* const value = std::get_if<double>(&cell);
    if (value == nullptr || !std::isfinite(*value)) return;
    shown.note_size(*value);
    if (column.part == ColumnPart::standard_error) return shown.hold(*value);
    const double size = std::abs(*value);
    if (!needs_more_digits(column.digits, size)) return;
    shown.smallest = std::min(shown.smallest, size);
    const double of_three =
        column.digits == Digits::estimate ? 0.1 : 1.0;  // three digits instead of two
    shown.of_numbers = std::max(shown.of_numbers, decimals_of(of_three * size));
  }

  std::map<Key, Shown> shown_{};
};

/// One cell; `row`: the index of its row.
class CellText final {
 public:
  CellText(const ResultColumn& column, const DecimalsOfColumns& decimals, std::size_t row)
      : column_(column), decimals_(decimals), row_(row) {}

  Phrase operator()(std::monostate) const { return {}; }
  Phrase operator()(std::int64_t count) const { return display_whole(count); }
  Phrase operator()(double value) const { return number(value, ""); }
  Phrase operator()(const std::string& word) const { return column_.words(word); }
  Phrase operator()(const Quantity& quantity) const {
    return display_quantity(quantity.value, quantity.unit);
  }
  Phrase operator()(const Interval& interval) const {
    if (!interval.low) return {};
    return '[' + number(*interval.low, interval.unit) + ", " +
           (interval.high ? number(*interval.high, interval.unit) : "n/a") + ']';
  }
  Phrase operator()(const JoinedCell& joined) const { return joined.shown; }

 private:
  std::string number(double value, const std::string& unit) const {
    if (!unit.empty()) return display_quantity(value, unit);
    if (const auto text = fixed_digits(column_, value)) return *text;
    return decimals_.text(column_, row_, value);
  }

  const ResultColumn& column_;
  const DecimalsOfColumns& decimals_;
  std::size_t row_;
};

/// Whether the column contains words and not quantities: one of its cells is a word, or begins with one.
bool holds_words(const ResultTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [column](const ResultRow& row) {
    if (std::holds_alternative<std::string>(row[column])) return true;
    const auto* const joined = std::get_if<JoinedCell>(&row[column]);
    return joined != nullptr && !joined->stored.empty() &&
           std::holds_alternative<std::string>(joined->stored.front());
  });
}

Phrase with_unit(const Phrase& heading, const std::string& unit, Reader reader) {
  if (unit.empty()) return heading;
  return reader == Reader::report ? phrase("Columns", "%1 (%2)").with(heading, unit)
                                  : phrase("Columns", "%1, %2").with(heading, unit);
}

Phrase id_for_terminal(const ResultColumn& column) {
  switch (column.part) {
    case ColumnPart::value:
      return column.id;
    case ColumnPart::interval:
      return column.id + " 95 %";
    case ColumnPart::standard_error:
      return column.id + "_se";
  }
  return {};
}

}  // namespace

Phrase heading_for(const ResultColumn& column, Reader reader) {
  if (reader == Reader::terminal) return id_for_terminal(column);
  if (column.part != ColumnPart::interval) return with_unit(column.heading, column.unit, reader);
  if (!column.interval_name.empty()) return with_unit(column.interval_name, column.unit, reader);
  const Phrase interval = phrase("Columns", "95 % CI");
  if (reader == Reader::report) return with_unit(interval, column.unit, reader);
  return phrase("Columns", "%1, %2").with(with_unit(column.heading, column.unit, reader), interval);
}

DisplayedTable displayed(const ResultTable& table, Reader reader) {
  const ResultTable read = table.for_readers == nullptr ? table : table.for_readers(table);
  const DecimalsOfColumns decimals(read);
  DisplayedTable shown{};
  shown.rows.resize(read.rows.size());
  for (std::size_t i = 0; i < read.columns.size(); ++i) {
    const ResultColumn& column = read.columns[i];
    if (column.is_for_files) continue;
    std::vector<Phrase> texts{};
    for (std::size_t row = 0; row < read.rows.size(); ++row) {
      texts.push_back(std::visit(CellText(column, decimals, row), read.rows[row][i]));
    }
    const bool is_empty =
        !texts.empty() &&
        std::all_of(texts.begin(), texts.end(), [](const Phrase& text) { return text.empty(); });
    if (is_empty && !shown.columns.empty()) continue;
    shown.columns.push_back({heading_for(column, reader), holds_words(read, i)});
    for (std::size_t row = 0; row < texts.size(); ++row) shown.rows[row].push_back(texts[row]);
  }
  return shown;
}

}  // namespace asperity
