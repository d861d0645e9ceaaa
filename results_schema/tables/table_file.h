// A table that is written row by row, for tables that are larger than memory.

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "results_schema/tables/table.h"

namespace asperity {

/// What became of a file that an export wrote.
struct WrittenTable {
  std::size_t rows = 0;          ///< without the one that names the columns
  std::size_t marked_cells = 0;  ///< text that got an apostrophe
  std::size_t spaced_cells = 0;  ///< text whose tabs or line breaks became spaces
  std::size_t cut_cells = 0;     ///< text that is longer than the format can hold
  std::string sha256{};
};

/// Text for other programs, UTF-8 without byte order mark, numbers as in `tsv_of`:
///
/// - `tsv`: as `tsv_of`; missing is `n/a`.
/// - `csv`: RFC 4180, lines end in CR LF; missing is empty, an empty text is `""`, a text with a
///   semicolon is quoted too.
/// - `bare_tsv_gz`: as `tsv`, without the line of names, compressed by gzip without a time stamp.
///
/// A text that a spreadsheet could take for a formula, because it begins with = + - @, a tab or a
/// line break, gets an apostrophe before it, unless it is a negative number ("-2"); so does a text that begins with an apostrophe or is
/// exactly `n/a`. Taking one apostrophe away from every text cell that begins with one therefore gives the texts back as
/// they were.
///
/// Errors: ResultsError (it exists, no space, no permission). Nothing is synced: a caller that writes
/// a folder of these syncs it once.
class TableFile final {
 public:
  enum class Format { tsv, csv, bare_tsv_gz };

  TableFile(const std::filesystem::path& path, Format format,
            const std::vector<std::string>& columns);
  TableFile(TableFile&&) noexcept;
  TableFile& operator=(TableFile&&) noexcept;
  ~TableFile();

  /// As many cells as there are columns.
  void add(const std::vector<Cell>& row);
  /// The same for a number and floats, which are written in the shortest digits of a float.
  void add(double first, const std::vector<float>& rest);
  WrittenTable finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace asperity
