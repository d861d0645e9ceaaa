// The names in a folder, with an error that names the folder.

#pragma once

#include <filesystem>
#include <vector>

namespace asperity {

/// What is in a folder, by name; nothing where there is no such folder.
/// Errors: ResultsError naming the folder that cannot be read.
std::vector<std::filesystem::directory_entry> entries_in(const std::filesystem::path& folder);

/// Whether a file or folder is hidden: its name begins with a point.
bool is_hidden(const std::filesystem::directory_entry& entry);

/// Whether nothing is in a folder but hidden entries, such as a desktop's .DS_Store: it can become a study.
/// Errors: those of `entries_in`.
bool is_free(const std::filesystem::path& folder);

/// What is in a folder and in the folders below it, each folder before its content. Links are not followed.
/// Errors: those of `entries_in`.
std::vector<std::filesystem::directory_entry> entries_below(const std::filesystem::path& folder);

}  // namespace asperity
