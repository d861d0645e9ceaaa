// Counts the characters of UTF-8, and breaks lines between words under an indented prefix.

#include "app/words/text_parts.h"

#include <algorithm>

namespace asperity {

std::string listed(const std::vector<std::string>& words) {
  std::string text{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::size_t width_of(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char byte) {
    // counts all bytes except continuation bytes
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

std::string wrapped_text(const std::string& text, std::size_t columns, const std::string& prefix) {
  const std::size_t indent = width_of(prefix);
  std::string lines{};
  std::string line = prefix;
  std::size_t used = 0;  // of the line, without its prefix
  std::string word{};
  const auto end_line = [&] {
    if (used > 0 || lines.empty()) lines += line;  // avoids lines of blanks only
    lines += '\n';
    line.assign(indent, ' ');
    used = 0;
  };
  const auto end_word = [&] {
    if (word.empty()) return;
    const std::size_t width = width_of(word);
    if (used > 0 && indent + used + 1 + width > columns) end_line();
    if (used > 0) {
      line += ' ';
      ++used;
    }
    line += word;
    used += width;
    word.clear();
  };
  for (const char character : text) {
    if (character != ' ' && character != '\n') {
      word += character;
      continue;
    }
    end_word();
    if (character == '\n') end_line();
  }
  end_word();
  return used > 0 || lines.empty() ? lines + line : lines;
}

}  // namespace asperity
