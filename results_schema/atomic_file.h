// The only way in which the program writes a file.

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace asperity {

enum class Overwrite { refuse, allow };

/// Writes under a temporary name, syncs, renames, syncs the folder: after a crash the file is the
/// old one or the new one, never a part.
///
/// Errors: ResultsError naming the path: it exists (and `refuse`), the folder is missing, no
/// permission, no space. Nothing is left behind.
void write_file(const std::filesystem::path& path, std::span<const std::byte> content,
                Overwrite overwrite);
void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite);

/// The whole file. Errors: ResultsError naming the path.
std::string read_file(const std::filesystem::path& path);

}  // namespace asperity
