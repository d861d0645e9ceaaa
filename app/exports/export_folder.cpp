// Writes a folder next to the target with MANIFEST.tsv, syncs all of it at once and puts it in place.

#include "app/exports/export_folder.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <map>
#include <set>
#include <unistd.h>
#include <utility>

#include "results_schema/error_text.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "MANIFEST.tsv";

/// The files that an earlier export lists, with the SHA-256 of each.
std::map<std::string, std::string> files_of_export_in(const fs::path& folder) {
  if (!fs::exists(folder / kManifest)) return {};
  const Table manifest = read_tsv(read_file(folder / kManifest), kManifest);
  const auto column = std::find(manifest.columns.begin(), manifest.columns.end(), "sha256");
  if (column == manifest.columns.end()) return {};
  const auto sha256_at = static_cast<std::size_t>(column - manifest.columns.begin());
  std::map<std::string, std::string> files{};
  for (const std::vector<Cell>& row : manifest.rows) {
    const auto* name = std::get_if<std::string>(&row.front());
    const auto* sha256 = std::get_if<std::string>(&row[sha256_at]);
    if (name != nullptr && sha256 != nullptr) files[*name] = *sha256;
  }
  return files;
}

/// The reason why `folder` cannot be written, as the end of a sentence.
std::optional<std::string> obstacle_in(const fs::path& folder, Overwrite overwrite) {
  if (!fs::exists(folder)) return std::nullopt;
  if (!fs::is_directory(folder)) return "exists and is not a folder; choose another name";
  if (fs::is_empty(folder)) return std::nullopt;
  if (overwrite == Overwrite::refuse) {
    return "is not empty; choose another folder, or replace an earlier export with --force";
  }
  const std::map<std::string, std::string> own_files = files_of_export_in(folder);
  std::set<std::string> others{};
  std::set<std::string> unsure{};  // to be compared, once there is no other reason
  for (const fs::directory_entry& entry : entries_below(folder)) {
    const std::string name = fs::relative(entry.path(), folder).generic_string();
    if (entry.is_directory() || (name == kManifest && !own_files.empty())) continue;
    (own_files.contains(name) ? unsure : others).insert(name);
  }
  if (!others.empty()) {
    return "contains \"" + *others.begin() +
           "\", which was not written by an export and would be lost; choose another folder";
  }
  for (const std::string& name : unsure) {
    if (sha256_of_file(folder / name) == own_files.at(name)) continue;
    return "contains \"" + name +
           "\", which was changed since it was exported, and the changes would be lost; move that "
           "file away, or choose another folder";
  }
  return std::nullopt;
}

/// Syncs all files at once: syncing them one by one would take much longer.
void sync_file_system_of(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int result = descriptor < 0 ? -1 : ::syncfs(descriptor);
  const int error_number = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (result == 0) return;
  throw fs::filesystem_error("sync", folder,
                             std::error_code(error_number, std::generic_category()));
}

[[noreturn]] void fail(const fs::path& target, const fs::filesystem_error& error) {
  throw ResultsError("the export cannot be written to " + target.string() + ": " +
                         text_of_error_number(error.code().value()),
                     target, error.code().value());
}

/// The folder's absolute path, once it can be written.
fs::path free_target(const fs::path& folder, Overwrite overwrite) {
  fs::path target = fs::absolute(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();  // a trailing slash
  try {
    if (const auto obstacle = obstacle_in(target, overwrite)) {
      throw ResultsError("the folder " + target.string() + " " + *obstacle, target);
    }
  } catch (const fs::filesystem_error& error) {
    fail(target, error);
  }
  return target;
}

}  // namespace

void refuse_target(const fs::path& folder, Overwrite overwrite) {
  static_cast<void>(free_target(folder, overwrite));
}

ExportFolder::ExportFolder(const fs::path& folder, Overwrite overwrite)
    : target_(free_target(folder, overwrite)), part_(target_, 0777) {}

fs::path ExportFolder::path_of(const std::string& name) const {
  const fs::path path = part_.content() / name;
  try {
    fs::create_directories(path.parent_path());
  } catch (const fs::filesystem_error& error) {
    fail(target_, error);
  }
  return path;
}

void ExportFolder::write(const std::string& name, std::string_view text) {
  // Neither synced nor renamed: this is done for the complete folder.
  const fs::path path = path_of(name);
  errno = 0;  // a stream does not set it in every failure
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    const int error_number = errno != 0 ? errno : EIO;
    throw ResultsError("the export cannot be written to " + target_.string() + ": " +
                           text_of_error_number(error_number),
                       target_, error_number);
  }
  ExportedFile& file = files_.emplace_back();
  file.name = name;
  file.sha256 = sha256_of(text);
}

void ExportFolder::add(const std::string& name, const WrittenTable& written,
                       std::vector<std::string> left_out) {
  files_.push_back({.name = name,
                    .rows = written.rows,
                    .marked_cells = written.marked_cells,
                    .spaced_cells = written.spaced_cells,
                    .cut_cells = written.cut_cells,
                    .sha256 = written.sha256,
                    .left_out = std::move(left_out)});
}

std::vector<ExportedFile> ExportFolder::take_place() {
  std::sort(files_.begin(), files_.end(),
            [](const ExportedFile& a, const ExportedFile& b) { return a.name < b.name; });
  Table manifest{{"file", "rows", "sha256", "left_out"}, {}};
  for (const ExportedFile& file : files_) {
    std::string names{};
    for (const std::string& column : file.left_out) names += (names.empty() ? "" : " ") + column;
    manifest.rows.push_back({file.name,
                             file.rows ? Cell{static_cast<std::int64_t>(*file.rows)} : Cell{},
                             file.sha256, names.empty() ? Cell{} : Cell{names}});
  }
  write(kManifest, tsv_of(manifest));
  files_.back().rows = manifest.rows.size();
  try {
    sync_file_system_of(part_.content());
    part_.take_place(Overwrite::allow);  // an existing folder was checked before
  } catch (const fs::filesystem_error& error) {
    fail(target_, error);
  }
  return std::move(files_);
}

}  // namespace asperity
