// Folders, read to their end or refused by name: the standard library's iterators name none when they fail.

#include "results_schema/files/folder_entries.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>

#include "results_schema/files/file_system.h"

namespace asperity {
namespace {

using std::filesystem::directory_entry;

constexpr std::array<std::string_view, 3> kFilesOfDesktops{".DS_Store", ".directory", ".localized"};
constexpr std::string_view kAttributesOfFile = "._";  // before the name of the file

/// Calls `goes_on` with each entry in the order of the disk, until it returns false.
template <class Visitor>
void visit_entries(const std::filesystem::path& folder, const Visitor& goes_on) {
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error);
  if (error == std::errc::no_such_file_or_directory) return;
  for (; !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
    if (!goes_on(*at)) return;
  }
  if (error) fail_on_file(folder, "read", error.value());
}

void add_entries_below(const std::filesystem::path& folder, std::vector<directory_entry>& all) {
  for (directory_entry& entry : entries_in(folder)) {
    std::error_code unknown;
    const bool is_folder = std::filesystem::is_directory(entry.symlink_status(unknown));
    const std::filesystem::path path = entry.path();
    all.push_back(std::move(entry));
    if (is_folder) add_entries_below(path, all);
  }
}

}  // namespace

bool is_of_desktop(const directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (!name.starts_with(kAttributesOfFile) &&
      std::ranges::find(kFilesOfDesktops, name) == kFilesOfDesktops.end()) {
    return false;
  }
  std::error_code unknown;
  return std::filesystem::is_regular_file(entry.symlink_status(unknown));
}

std::vector<directory_entry> entries_in(const std::filesystem::path& folder) {
  std::vector<directory_entry> entries;
  visit_entries(folder, [&entries](const directory_entry& entry) {
    entries.push_back(entry);
    return true;
  });
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_free(const std::filesystem::path& folder) {
  bool has_content = false;
  visit_entries(folder, [&has_content](const directory_entry& entry) {
    has_content = !is_of_desktop(entry);
    return !has_content;
  });
  return !has_content;
}

std::vector<directory_entry> entries_below(const std::filesystem::path& folder) {
  std::vector<directory_entry> all;
  add_entries_below(folder, all);
  return all;
}

}  // namespace asperity
