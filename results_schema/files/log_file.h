// A text file of a study that grows.

#pragma once

#include <filesystem>
#include <string_view>

namespace asperity {

/// Appends to a file, and makes it and its folder where they are missing; in a study that its group shares they are
/// shared as well. Not synced: after a crash the end may be missing.
///
/// Errors: ResultsError naming the path, also for a symbolic link.
void append_to_log(const std::filesystem::path& path, std::string_view text);

}  // namespace asperity
