// A folder of exported files that appears complete or not at all, with a list of what is in it.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/atomic_file.h"
#include "results_schema/part_folder.h"
#include "results_schema/table_file.h"

namespace asperity {

struct ExportedFile {
  std::string name{};                 ///< within the folder
  std::optional<std::size_t> rows{};  ///< of a table, without the line that names the columns
  std::size_t marked_cells = 0;       ///< see WrittenTable
  std::size_t spaced_cells = 0;
  std::size_t cut_cells = 0;
  std::string sha256{};
  std::vector<std::string> left_out{};  ///< columns that this audience does not get
};

/// Files are written into a PartFolder, which takes the place of an earlier export in one step at the end.
///
/// Errors: ResultsError when the folder exists and is not empty; with Overwrite::allow only when it
/// holds a file that stands in no MANIFEST.tsv of an export there, or one that has another SHA-256
/// there, because work would be lost.
class ExportFolder final {
 public:
  ExportFolder(const std::filesystem::path& folder, Overwrite overwrite);
  ExportFolder(const ExportFolder&) = delete;
  ExportFolder& operator=(const ExportFolder&) = delete;
  /// Where a file of this name is to be written; its folder is there.
  std::filesystem::path path_of(const std::string& name) const;
  void write(const std::string& name, std::string_view text);
  void add(const std::string& name, const WrittenTable& written,
           std::vector<std::string> left_out = {});

  /// Writes MANIFEST.tsv, syncs and renames. Returns every file, in the order of names.
  std::vector<ExportedFile> take_place();

 private:
  std::filesystem::path target_{};
  PartFolder part_;
  std::vector<ExportedFile> files_{};
};

}  // namespace asperity
