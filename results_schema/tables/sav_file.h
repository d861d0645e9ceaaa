// A table as SPSS, PSPP, JASP and jamovi keep theirs.

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results_schema/tables/table_file.h"

namespace asperity {

/// One column of an SPSS file.
struct SavVariable {
  enum class Measure { nominal, ordinal, scale };

  std::string name{};   ///< see `sav_names`
  std::string label{};  ///< what it means, in a sentence
  bool is_text = false;
  std::size_t width_bytes = 1;  ///< of the longest text
  Measure measure = Measure::scale;
  int decimals = 6;                                            ///< of a number, that SPSS shows
  std::vector<std::pair<double, std::string>> value_labels{};  ///< of a number
  std::optional<double> missing{};                             ///< a number that stands for missing
};

/// The names as SPSS takes them: at most 64 bytes of letters, digits and underscores, the first a
/// letter, none a word of its language, no two the same whatever the case. In the same order.
std::vector<std::string> sav_names(const std::vector<std::string>& names);

/// An SPSS system file, in UTF-8, its rows compressed, by ReadStat. Missing numbers are
/// system-missing, a missing text is empty. The date in its header is always the first of January
/// 1970, so that the same rows give the same bytes, and the date of the export is not disclosed.
///
/// A label longer than SPSS takes (255 bytes, 120 of a value) ends in "…", labels of values that
/// would then be alike in a number too; a text longer than 32 000 bytes is cut. Texts and labels of
/// values that were cut are counted. Errors: ResultsError.
class SavFile final {
 public:
  /// `rows` is how many will be added.
  SavFile(const std::filesystem::path& path, const std::vector<SavVariable>& variables,
          std::size_t rows, const std::string& title);
  SavFile(const SavFile&) = delete;
  SavFile& operator=(const SavFile&) = delete;
  ~SavFile();

  void add(const std::vector<Cell>& row);
  WrittenTable finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace asperity
