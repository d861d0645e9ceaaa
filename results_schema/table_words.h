// Bytes with a meaning of their own in a table's text. Seen by this folder only.

#pragma once

#include <string_view>

namespace asperity {

/// What stands for a missing cell.
inline constexpr std::string_view kMissingCell = "n/a";
/// How some programs begin a file in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace asperity
