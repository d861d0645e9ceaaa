// Folders, read to their end or refused by name: the standard library's iterators name none when they fail.

#include "results_schema/files/folder_entries.h"

#include <algorithm>
#include <system_error>

#include "results_schema/files/file_system.h"

namespace asperity {
namespace {

using std::filesystem::directory_entry;

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

bool is_hidden(const directory_entry& entry) {
  return entry.path().filename().string().starts_with('.');
}

std::vector<directory_entry> entries_in(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<directory_entry> entries;
  std::filesystem::directory_iterator at(folder, error);
  if (error == std::errc::no_such_file_or_directory) return entries;
  for (; !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
    entries.push_back(*at);
  }
  if (error) fail_on_file(folder, "read", error.value());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_free(const std::filesystem::path& folder) {
  return std::ranges::all_of(entries_in(folder), is_hidden);
}

std::vector<directory_entry> entries_below(const std::filesystem::path& folder) {
  std::vector<directory_entry> all;
  add_entries_below(folder, all);
  return all;
}

}  // namespace asperity
