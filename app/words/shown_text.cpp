// Walks over UTF-8. A byte that belongs to no character is taken as a character of Latin-1, because a terminal may obey it.

#include "app/words/shown_text.h"

#include <cstddef>
#include <cstdint>

namespace asperity {

namespace {

struct Character {
  std::uint32_t number = 0;
  std::size_t bytes = 1;
};

/// How many bytes the character that begins with this byte has; 1 for a byte that begins none.
std::size_t length_of(std::uint32_t first) {
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 1;
}

Character character_at(std::string_view text, std::size_t at) {
  const std::uint32_t first = static_cast<unsigned char>(text[at]);
  const std::size_t bytes = length_of(first);
  if (bytes == 1 || at + bytes > text.size()) return {first, 1};
  std::uint32_t number = first & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const std::uint32_t next = static_cast<unsigned char>(text[at + i]);
    if ((next & 0xC0U) != 0x80) return {first, 1};
    number = number << 6U | (next & 0x3FU);
  }
  return {number, bytes};
}

/// Controls of ASCII and of Latin-1, line separators, and what changes the direction of writing.
bool is_control(std::uint32_t number) {
  return number < 0x20 || (number >= 0x7F && number < 0xA0) || number == 0x061C ||
         number == 0x200E || number == 0x200F || (number >= 0x2028 && number <= 0x202E) ||
         (number >= 0x2066 && number <= 0x2069);
}

std::string shown(std::string_view text, std::string_view unchanged) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string all{};
  all.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Character character = character_at(text, at);
    if (is_control(character.number) && unchanged.find(text[at]) == std::string_view::npos) {
      all += "\\u";
      for (const unsigned shift : {12U, 8U, 4U, 0U}) {
        all += kDigits[character.number >> shift & 0xFU];
      }
    } else {
      all += text.substr(at, character.bytes);
    }
    at += character.bytes;
  }
  return all;
}

}  // namespace

std::string shown_in_a_line(std::string_view text) { return shown(text, {}); }

std::string shown_in_lines(std::string_view text) { return shown(text, "\n\t"); }

}  // namespace asperity
