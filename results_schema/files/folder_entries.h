// The names in a folder, with an error that names the folder.

#pragma once

#include <filesystem>
#include <vector>

namespace asperity {

/// What is in a folder, by name; nothing where there is no such folder.
/// Errors: ResultsError naming the folder that cannot be read.
std::vector<std::filesystem::directory_entry> entries_in(const std::filesystem::path& folder);

/// Whether a file is one that desktops write into every folder that they display, such as .DS_Store. Other hidden files are
/// content: a study shares and copies what is in its folder.
bool is_of_desktop(const std::filesystem::directory_entry& entry);

/// Whether nothing is in a folder but files of desktops: it can become a study. Reads no further than to the first other entry.
/// Errors: those of `entries_in`.
bool is_free(const std::filesystem::path& folder);

/// What is in a folder and in the folders below it, each folder before its content. Links are not followed.
/// Errors: those of `entries_in`.
std::vector<std::filesystem::directory_entry> entries_below(const std::filesystem::path& folder);

}  // namespace asperity
