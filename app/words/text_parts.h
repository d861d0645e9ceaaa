// A text taken apart: where a letter stands, or into lines.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// What stands before, between and after the letters `between`, in order; empty parts are parts too, so
/// that there is at least one. Keys of findings are joined by "|".
inline std::vector<std::string> parts_of(const std::string& text, char between = '|') {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == between) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

/// In characters, each one column of a terminal wide.
std::size_t width_of(std::string_view utf8);

/// The text in lines of at most so many characters, broken between words; breaks of its own stay, and a word that is
/// longer stays whole. `prefix` stands before the first line, as much room before the others.
std::string wrapped_text(const std::string& text, std::size_t columns,
                         const std::string& prefix = {});

}  // namespace asperity
