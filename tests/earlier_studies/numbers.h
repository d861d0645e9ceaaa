// Tables of the numbers in the program's output, without its sentences: stored by one version, compared by the next.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::test {

/// A named table of text; a missing cell is empty.
struct NumberTable {
  std::string name{};
  std::vector<std::string> columns{};
  std::vector<std::vector<std::string>> rows{};
  bool may_grow = false;  ///< rows may be added; those of findings may change their order
};
using Numbers = std::vector<NumberTable>;

/// Of `analyze --json`: counts, tables, findings and questions of each outcome.
Numbers numbers_of_analysis(const std::string& json);

/// Of a folder that `export` wrote: its tables, wide.csv and wide.sav. The codebook and the manifest describe them;
/// trials.sav, BIDS and Psych-DS repeat their cells. A reason in the program's words becomes "(words)".
Numbers numbers_of_export(const std::filesystem::path& folder);

/// Of an HTML report: the numbers in each row of its tables, in reading order.
Numbers numbers_of_report(const std::string& html);

/// As stored: for each table a line "## NAME" ("##+ NAME" where rows may be added), its columns, its rows, with tabs
/// between cells, and an empty line.
std::string text_of(const Numbers& numbers);
Numbers read_numbers(std::string_view text);

/// The correct content of a stored cell that is wrong.
struct Correction {
  std::string table{};
  int row = 0;  ///< from 1, as stored
  std::string column{};
  std::string was{};
  std::string is{};
  std::string reason{};
};
std::vector<Correction> read_corrections(std::string_view text);
/// A row of a report whose numbers are corrected to nothing is gone. Throws std::runtime_error for a cell that does not
/// exist or is not as it `was`.
void correct(Numbers& stored, const std::vector<Correction>& corrections);

/// Tables, columns, rows and cells of `stored` that `now` lacks, a sentence each. Tables and columns may be added, and
/// rows to a table that `may_grow`, and there `low`, `high` and `confidence` to a row that had none. Numbers agree to a part in 10⁹, or to 10⁻¹²:
/// their last digits depend on the compiler.
std::vector<std::string> differences(const Numbers& stored, const Numbers& now);

}  // namespace asperity::test
