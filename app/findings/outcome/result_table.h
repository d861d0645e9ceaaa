// The tables of a result: columns that are declared once, and typed cells.
//
// A ResultColumn is declared next to the method that computes it (shared ones in columns.h) and is used wherever the column is
// filled, drawn, printed or written: an id that does not exist does not compile. Windows, reports and terminals read a table
// through `displayed` (displayed_table.h), programs and files through `stored_table`.

#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/cell_words.h"
#include "results_schema/tables/table.h"

namespace asperity {

struct AnalysisOutcome;
struct Figure;
struct ResultTable;

/// The decimals with which the numbers of a column are displayed; never those of a file.
enum class Digits {
  of_column,  ///< the same for all numbers of the id: those of its narrowest interval, two without intervals
  of_row,     ///< the rows are of different quantities
  estimate,   ///< of participants, whose scales may have any size: three digits instead of two
  bounded,    ///< cannot exceed 1: ".71"
  chance,     ///< a chance level: ".333"
  statistic,  ///< of a test, and its degrees of freedom: two decimals
  p,          ///< ".031", "< .001"
  force,      ///< in N: a millinewton
  length,     ///< in m: ten micrometres, for lengths of 0.1 mm or more
};

/// What a column contains of its quantity.
enum class ColumnPart { value, interval, standard_error };

/// The display text of a stored word: of a code ("not_converged"), or of a name with the unit of its parameter.
using WordText = Phrase (*)(const std::string& stored);

/// One column of a result.
struct ResultColumn {
  std::string
      id{};  ///< fixed, for programs and files: "jnd"; its limits are "jnd_low" and "jnd_high"
  Phrase heading{};  ///< without the unit: "JND"
  std::string
      unit{};  ///< of every number; empty for a pure number, and where cells have units of their own
  Digits digits = Digits::of_column;
  WordText words = words_of_name;
  ColumnPart part = ColumnPart::value;
  /// Of an interval that is not the 95 % CI of the heading: "Wilson 95 % CI".
  Phrase interval_name{};
  /// The columns of files that hold the parts of a JoinedCell, in their order; empty: one, the id.
  std::vector<std::string> stored_as{};
  bool is_for_files = false;  ///< not displayed: what other cells already state, such as their unit

  bool is_same(const ResultColumn& other) const { return id == other.id && part == other.part; }
  /// The names of its columns in files.
  std::vector<std::string> stored_names() const;
};

/// The limits of the numbers of a column; `name` if they are not a 95 % CI.
ResultColumn interval_of(ResultColumn column, Phrase name = {});
/// Their standard errors, which are displayed with the decimals of the numbers.
ResultColumn standard_error_of(ResultColumn column, Phrase heading);
/// The same column, of files only.
ResultColumn for_files(ResultColumn column);

/// A number with the unit of its row, in SI.
struct Quantity {
  double value = 0.0;
  std::string unit{};

  bool operator==(const Quantity&) const = default;
};
/// An interval, from low to high; a limit that could not be computed is missing. `unit` as in Quantity.
struct Interval {
  std::optional<double> low{};
  std::optional<double> high{};
  std::string unit{};

  bool operator==(const Interval&) const = default;
};
/// Several stored values that are displayed together: "t(19) = 12.25", "20 participants", "22/500".
struct JoinedCell {
  std::vector<Cell> stored{};  ///< as many as the column has stored names
  Phrase shown{};              ///< empty: as a missing cell

  bool operator==(const JoinedCell&) const = default;
};

/// Missing, a count, a number in the unit of its column, a word, or one of the above. A word in a column of numbers is the status
/// that replaces a number.
using ResultCell =
    std::variant<std::monostate, std::int64_t, double, std::string, Quantity, Interval, JoinedCell>;
using ResultRow = std::vector<ResultCell>;

/// A cell with the value, or a missing one.
ResultCell cell_of(const std::optional<double>& value);
/// A missing cell instead of an empty text.
ResultCell word_cell(std::string text);
/// A number with its unit; a pure number where the unit is empty.
ResultCell quantity_cell(const std::optional<double>& value, const std::string& unit);
/// A missing cell instead of an interval without limits.
ResultCell interval_cell(std::optional<double> low, std::optional<double> high,
                         const std::string& unit = {});
ResultCell count_cell(std::size_t count);

/// The figures of a table. They may be made from other tables and findings of its outcome.
using FiguresOfTable = std::vector<Figure> (*)(const ResultTable& table,
                                               const AnalysisOutcome& outcome);

/// A table for users and programs: numbers have all their digits, missing cells are missing.
struct ResultTable {
  std::string name{};  ///< fixed, for programs: "table_1", "shares"
  Phrase title{};      ///< for users
  std::vector<ResultColumn> columns{};
  Phrase note{};  ///< how to read it, chance level included; may be empty
  /// A row for each trial, of which a study has hundreds: texts and reports leave the table out.
  bool lists_trials = false;
  std::vector<ResultRow> rows{};
  /// The table that people read in place of this one; null: this one.
  ResultTable (*for_readers)(const ResultTable& table) = nullptr;
  FiguresOfTable figures = nullptr;  ///< null: none

  /// The index of a column; nothing where the table does not have it.
  std::optional<std::size_t> find(const ResultColumn& column) const;
  bool has(const ResultColumn& column) const { return find(column).has_value(); }
  /// Whether any row has a value in this column; false where there is no such column.
  bool has_values(const ResultColumn& column) const;
  /// Adds a row; cells that it lacks at its end are missing. Errors: std::logic_error for more cells than columns.
  void add(ResultRow row);
  /// Removes the columns that are empty in every row, except the first `kept` ones. A table without rows is unchanged.
  void drop_empty_columns(std::size_t kept);
};

/// The cells of a row by their columns.
class RowReader final {
 public:
  RowReader(const ResultTable& table, const ResultRow& row) : table_(table), row_(row) {}

  /// Missing where the table does not have the column.
  const ResultCell& cell(const ResultColumn& column) const;
  /// The word, the first of joined values; empty where there is none.
  std::string text(const ResultColumn& column) const;
  /// The number or count, also of a quantity; nothing where there is none.
  std::optional<double> number(const ResultColumn& column) const;
  /// The limits that belong to `column`; missing ones where there is no interval.
  Interval interval(const ResultColumn& column) const;

 private:
  const ResultTable& table_;
  const ResultRow& row_;
};

/// A number or a count, also of a quantity; nothing for words, intervals and missing cells.
std::optional<double> number_of(const ResultCell& cell);

/// The table as programs and files have it: every value in a separate column, `x_low` and `x_high` for an interval. Errors:
/// std::logic_error for a JoinedCell with more values than its column has names.
Table stored_table(const ResultTable& table);

}  // namespace asperity
