// Content has a name: its SHA-256.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// 64 lower-case hexadecimal digits.
std::string sha256_of(std::string_view content);
/// Reads the file in pieces. Errors: ResultsError.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace asperity
