// Writes rows of exported columns as a file for SPSS, whose header contains the lengths of their
// texts.

#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "results_schema/tables/sav_file.h"

namespace asperity {

/// Keeps the rows in an unnamed file until all of them are known.
///
/// A text with declared levels, and a truth value, becomes a number with a label for each level,
/// which is the form of a factor in SPSS; where it is missing for a declared reason, the number -1
/// represents that reason and counts as missing. Other texts are exported as typed.
class SavTable final {
 public:
  /// `spool_folder` temporarily stores the rows.
  SavTable(std::vector<ExportColumn> columns, const std::filesystem::path& spool_folder);

  void add(std::vector<Cell> row);
  std::size_t rows() const noexcept { return rows_; }
  /// `names` are the names of the columns in the file, for the codebook.
  WrittenTable write(const std::filesystem::path& path, const std::string& title);
  std::vector<std::string> names() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  struct Seen {
    std::set<std::string> texts{};  ///< of a column with levels
    std::size_t width_bytes = 1;
    bool any_missing = false;
  };
  void put(const void* bytes, std::size_t count);
  bool get(void* bytes, std::size_t count);
  bool read_row(std::vector<Cell>& row);
  bool is_coded(std::size_t column) const;

  std::filesystem::path spool_folder_{};
  std::vector<ExportColumn> columns_{};
  std::vector<Seen> seen_{};
  std::unique_ptr<std::FILE, Close> spool_{};
  std::size_t rows_ = 0;
};

}  // namespace asperity
