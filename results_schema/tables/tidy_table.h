// A table of anyone's, one observation per row: CSV or TSV as spreadsheets and statistics programs
// write it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

namespace asperity {

/// A column of names, each row as the place of its name in `names`.
struct LabelColumn {
  static constexpr std::size_t kMissing = static_cast<std::size_t>(-1);
  std::vector<std::string> names{};
  std::vector<std::size_t> codes{};  ///< by row; kMissing where the cell is empty
};

/// A column of numbers, by row; nothing where there is none.
using NumberColumn = std::vector<std::optional<double>>;

/// The cells of a file as text, with the lines on which they stand.
///
/// Reads UTF-8 with or without a byte order mark, LF and CRLF, separated by commas (RFC 4180: quoted
/// cells may hold commas, quotes twice and line breaks) or by tabs, where the header has those. A
/// cell is missing when it is empty, `NA` or `n/a`. Empty lines are no rows. Numbers have a decimal
/// point whatever the locale, and blanks around them, also those without a break or a width, mean nothing; blanks in names
/// do, and a name that begins or ends with one of the latter is refused. A first line "sep=," of a spreadsheet is skipped.
///
/// Errors: ResultsError "FILE:LINE:COLUMN: …", COLUMN counting columns from 1, for a row of another
/// length, a header with no name or the same twice, semicolons between columns, a decimal comma,
/// a thousands separator, a text where a number belongs, a quote that does not close; "FILE:LINE: …" for what is not UTF-8.
class TidyTable final {
 public:
  /// `name` is what messages call the file. Cells are views into `text`, which is kept: moved
  /// here, a table of hundreds of megabytes is held once.
  TidyTable(std::string text, std::string name);
  /// A table of values instead of text: named columns of names or of numbers. Rows are counted as lines from 2, as
  /// in a file. A column of numbers has neither texts nor labels. Throws std::invalid_argument for columns of
  /// different lengths, for a code beyond its names, and for a number that is not finite.
  struct Column {
    std::string name{};
    std::variant<LabelColumn, NumberColumn> cells{};
  };
  TidyTable(std::vector<Column> columns, std::string name);
  TidyTable(TidyTable&&) = default;
  TidyTable& operator=(TidyTable&&) = default;

  const std::string& name() const noexcept { return name_; }
  std::size_t rows() const noexcept {
    return made_.empty() ? lines_.size() : rows_in(made_.front());
  }
  bool has(std::string_view column) const;

  /// The columns below throw a sentence with the columns that there are when theirs is not there.
  /// By row; empty where missing. The views live as long as the table.
  std::vector<std::string_view> texts(std::string_view column) const;
  /// Numbers whose squares, which analyses sum, keep all their digits.
  static constexpr double kGreatestNumber = 1e100;
  static constexpr double kLeastNumber = 1e-100;
  /// Empty where missing. Refuses what is not finite, and, but for 0, what is greater or smaller in magnitude than these.
  std::vector<std::optional<double>> numbers(std::string_view column) const;
  /// Refuses a missing one as well.
  std::vector<double> all_numbers(std::string_view column) const;
  /// From 2⁵³ on doubles skip whole numbers: 2⁵³ + 1 is read as 2⁵³.
  static constexpr std::uint64_t kMostCounted = (std::uint64_t{1} << 53) - 1;
  /// Whole numbers from 0 to `most`, none missing.
  std::vector<std::uint64_t> counts(std::string_view column,
                                    std::uint64_t most = kMostCounted) const;
  /// The names in the order in which they first stand. Refuses two that are one name in two forms (name_forms.h).
  LabelColumn labels(std::string_view column) const;
  /// Only these names, in this order; another is refused.
  LabelColumn labels(std::string_view column, std::vector<std::string> names) const;
  /// As `labels`, none missing.
  LabelColumn all_labels(std::string_view column) const;

  /// Throws the sentence with the place of that cell before it.
  [[noreturn]] void refuse(std::size_t row, std::string_view column,
                           const std::string& sentence) const;

 private:
  void add_column(std::string column);
  std::size_t index_of(std::string_view column) const;
  /// Whether a cell has a comma that can only be a decimal one, such as "0,5".
  bool has_certain_decimal_comma(std::size_t column) const;
  static std::size_t rows_in(const std::variant<LabelColumn, NumberColumn>& cells) noexcept;
  LabelColumn made_labels(const LabelColumn& made) const;
  /// Throws std::logic_error for a column of numbers: a mistake in the program.
  const LabelColumn& made_names(std::size_t column) const;
  std::string_view cell(std::size_t row, std::size_t column) const;

  // Behind a pointer, because the characters of a moved string may move.
  std::unique_ptr<std::string> text_{};
  std::string name_{};
  std::vector<std::string> columns_{};
  std::unordered_map<std::string, std::size_t> index_of_column_{};
  std::vector<std::string_view> cells_{};
  std::vector<std::uint32_t> lines_{};
  std::vector<std::variant<LabelColumn, NumberColumn>>
      made_{};  // as columns_, of a table of values
};

}  // namespace asperity
