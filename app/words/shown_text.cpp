// Walks over UTF-8 without checking it: a control character has one, two or three bytes.

#include "app/words/shown_text.h"

#include <cstddef>
#include <cstdint>

namespace asperity {

namespace {

/// A character that begins at `at`, as far as it can be a control character.
struct Character {
  std::uint32_t number = 0;
  std::size_t bytes = 1;
};

Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  if (byte(0) == 0xC2 && (byte(1) & 0xC0U) == 0x80) return {byte(1), 2};
  if (byte(0) == 0xE2 && (byte(1) & 0xC0U) == 0x80 && (byte(2) & 0xC0U) == 0x80) {
    return {0x2000U | (byte(1) & 0x3FU) << 6U | (byte(2) & 0x3FU), 3};
  }
  // Of other characters only that they are not controls matters.
  return byte(0) < 0x80 ? Character{byte(0), 1} : Character{0xFFFD, 1};
}

bool is_control(std::uint32_t number) {
  return number < 0x20 || (number >= 0x7F && number < 0xA0) ||
         (number >= 0x2028 && number <= 0x202E) || (number >= 0x2066 && number <= 0x2069);
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
