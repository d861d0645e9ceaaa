// Splits a text into parts or lines, and joins words to a list.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The parts separated by the character `between`, in order; empty parts are included, so that
/// there is at least one.
inline std::vector<std::string> parts_of(const std::string& text, char between) {
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

/// "one", "one, two", "one, two, three"; of a range of strings. Empty for none.
template <class Words>
std::string comma_separated(const Words& words) {
  std::string text{};
  bool is_first = true;
  for (const auto& word : words) {
    if (!is_first) text += ", ";
    text += word;
    is_first = false;
  }
  return text;
}

/// "one", "one and two", "one, two and three"; empty for none.
std::string listed(const std::vector<std::string>& words);

/// In characters, each one terminal column wide.
std::size_t width_of(std::string_view utf8);

/// The text in lines of at most `columns` characters, broken between words; existing line breaks
/// are kept, and a longer word is not broken. `prefix` precedes the first line, and the other lines
/// are indented by its width.
std::string wrapped_text(const std::string& text, std::size_t columns,
                         const std::string& prefix = {});

}  // namespace asperity
