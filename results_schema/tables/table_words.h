// Bytes with a meaning of their own in a table's text. Seen by this folder only.

#pragma once

#include <string_view>

namespace asperity {

/// What stands for a missing cell.
inline constexpr std::string_view kMissingCell = "n/a";
/// How some programs begin a file in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A character that a reader does not see, or sees as a space, and its name.
struct UnseenCharacter {
  std::string_view bytes{};
  std::string_view name{};
};
inline constexpr UnseenCharacter kUnseenCharacters[] = {
    {"\xC2\xA0", "a no-break space (U+00A0)"},
    {"\xE2\x80\x87", "a figure space (U+2007)"},
    {"\xE2\x80\x89", "a thin space (U+2009)"},
    {"\xE2\x80\xAF", "a narrow no-break space (U+202F)"},
    {"\xE2\x80\x8B", "a zero-width space (U+200B)"},
    {"\xE2\x81\xA0", "a word joiner (U+2060)"},
    {"\xE3\x80\x80", "an ideographic space (U+3000)"},
    {kByteOrderMark, "a byte order mark (U+FEFF)"}};
/// The minus sign of typography, as this program and word processors show it.
inline constexpr std::string_view kMinusSign = "\xE2\x88\x92";

}  // namespace asperity
