// Declares a tab-separated table of numbers as text, for the files of recorded textures.

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A table of finite numbers under a line of column names.
struct NumberTable {
  struct Row {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<double> cells{};
  };

  std::vector<std::string> columns{};
  std::vector<Row> rows{};
};

/// Reads a table; `name` names it in messages. `check_columns` gets the names of the columns before any row is read, and
/// throws for those that it does not accept. A byte order mark and empty lines are skipped; a line may
/// end with CR LF.
///
/// Errors: std::invalid_argument with `name` and the line, for a row with another number of cells than the first line and for
/// cells that are not finite numbers; what `check_columns` throws. A file without a line has one column without a name.
NumberTable number_table_in(
    std::string_view tsv, const std::string& name,
    const std::function<void(const std::vector<std::string>&)>& check_columns);

/// Throws std::invalid_argument: "NAME:LINE: PROBLEM".
[[noreturn]] void refuse_table_line(const std::string& name, std::size_t line,
                                    const std::string& problem);

}  // namespace asperity
