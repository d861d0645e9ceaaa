// The names in a folder, with an error that names the folder.

#pragma once

#include <filesystem>
#include <vector>

namespace asperity {

/// What is in a folder, by name; nothing where there is no such folder.
/// Errors: ResultsError naming the folder that cannot be read.
std::vector<std::filesystem::directory_entry> entries_in(const std::filesystem::path& folder);

/// What is in a folder and in the folders below it, each folder before its content. Links are not followed.
/// Errors: those of `entries_in`.
std::vector<std::filesystem::directory_entry> entries_below(const std::filesystem::path& folder);

}  // namespace asperity
