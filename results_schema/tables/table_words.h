// Bytes with a meaning of their own in a table's text. Seen by this folder and its tests only.

#pragma once

#include <string>
#include <string_view>

#include "results_schema/study.h"

namespace asperity {

/// What stands for a missing cell.
inline constexpr std::string_view kMissingCell = "n/a";
/// How some programs begin a file in UTF-8. The store uses no other folder, and states it itself.
inline constexpr std::string_view kTableByteOrderMark = "\xEF\xBB\xBF";

/// The text of a table behind its byte order mark. Errors: ResultsError where lines end as those of old programs.
inline std::string_view text_of_table(std::string_view text, const std::string& file_name) {
  if (text.starts_with(kTableByteOrderMark)) text.remove_prefix(kTableByteOrderMark.size());
  if (text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos) {
    throw ResultsError(file_name +
                           ":1:1: the lines end with carriage returns alone; save the "
                           "table with line feeds (LF or CRLF)",
                       file_name);
  }
  return text;
}

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
    {kTableByteOrderMark, "a byte order mark (U+FEFF)"}};
/// The minus sign of typography, as this program and word processors show it.
inline constexpr std::string_view kMinusSign = "\xE2\x88\x92";

}  // namespace asperity
