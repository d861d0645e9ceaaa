// Writes a folder of exported files that appears complete or not at all, with a list of its
// contents.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/files/atomic_file.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/tables/table_file.h"

namespace asperity {

struct ExportedFile {
  std::string name{};                 ///< within the folder
  std::optional<std::size_t> rows{};  ///< of a table, without the header line
  std::size_t marked_cells = 0;       ///< see WrittenTable
  std::size_t spaced_cells = 0;
  std::size_t cut_cells = 0;
  std::string sha256{};
  std::vector<std::string> left_out{};  ///< columns that this audience does not receive
};

/// Files are written into a PartFolder, which replaces an earlier export in one step at the end.
///
/// Errors: ResultsError when the folder exists and is not empty; with Overwrite::allow only when it
/// contains a file that is not listed in a MANIFEST.tsv of an export there, or whose SHA-256
/// differs from the listed one, because data would be lost.
class ExportFolder final {
 public:
  ExportFolder(const std::filesystem::path& folder, Overwrite overwrite);
  ExportFolder(const ExportFolder&) = delete;
  ExportFolder& operator=(const ExportFolder&) = delete;
  /// The path at which to write a file of this name; its folder exists.
  std::filesystem::path path_of(const std::string& name) const;
  void write(const std::string& name, std::string_view text);
  void add(const std::string& name, const WrittenTable& written,
           std::vector<std::string> left_out = {});

  /// Writes MANIFEST.tsv, syncs and renames. Returns all files, in the order of names.
  std::vector<ExportedFile> take_place();

  /// See PartFolder.
  ResultsError about_target(const ResultsError& error) const { return part_.about_target(error); }

 private:
  std::filesystem::path target_{};
  PartFolder part_;
  std::vector<ExportedFile> files_{};
};

/// The check of the constructor alone.
void refuse_target(const std::filesystem::path& folder, Overwrite overwrite);

}  // namespace asperity
