// Characters of a text that are invisible, or that look like the ASCII character that is meant.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/words/phrase.h"

namespace asperity {

/// How some programs begin a file in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The text behind a byte order mark at its beginning; the whole text where there is none.
inline std::string_view without_byte_order_mark(std::string_view text) noexcept {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

struct LookAlike {
  std::string_view bytes{};  ///< in UTF-8
  Phrase character{};        ///< with its article and code point: "a no-break space (U+00A0)"
  Phrase correction{};       ///< what to do: "write a space instead"
};

/// The character at the beginning of a text in UTF-8, if a reader would not notice it: spaces without a break or width,
/// marks of order and direction, typographic quotation marks, dashes, full-width and Arabic punctuation, which word
/// processors, web pages and input methods write in place of ASCII.
std::optional<LookAlike> look_alike_at(std::string_view text);

/// The first one in a text.
std::optional<LookAlike> first_look_alike(std::string_view text);

/// Why the text of a cell is not a number, and what to do: "with a decimal comma; write a decimal point", "with a no-break
/// space (U+00A0); delete it", or "which is not a finite number; correct it". It follows the quoted text.
std::string number_correction(std::string_view cell);

}  // namespace asperity
