// Texts of files and other programs as a terminal or a log may show them.

#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// With every control character as its number: "\u001b[31m" for an escape sequence, "\u000a" for a line feed. A terminal
/// obeys them: a text could colour, delete or forge lines, or change the title of the window. Control characters are
/// those of ASCII and Latin-1, and those that reverse the direction of writing, with which a text can look like another.
/// Bytes that are not UTF-8 are unchanged. The form is that of JSON, so that JSON remains JSON.
std::string shown_in_a_line(std::string_view text);

/// The same for a text of lines: line feeds and tabs are unchanged.
std::string shown_in_lines(std::string_view text);

}  // namespace asperity
