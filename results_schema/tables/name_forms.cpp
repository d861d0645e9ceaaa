// Compares names letter by letter, a letter being a character with the marks that follow it.

#include "results_schema/tables/name_forms.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <unordered_map>

namespace asperity {
namespace {

/// A character and the marks after it, in UTF-8.
struct Letter {
  std::string_view bytes{};
  bool has_marks = false;

  bool is_ascii() const { return bytes.size() == 1; }
};

/// Of valid UTF-8.
std::size_t bytes_of_character(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

char32_t character_of(std::string_view bytes) {
  constexpr unsigned char kFirstBits[] = {0x7F, 0x1F, 0x0F, 0x07};
  char32_t character = static_cast<unsigned char>(bytes.front()) &
                       kFirstBits[std::min<std::size_t>(bytes.size(), 4) - 1];
  for (const char byte : bytes.substr(1)) {
    character = character << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
  }
  return character;
}

/// What Unicode's form NFD writes after a letter: accents of Latin, Greek and Cyrillic, the later parts of a Korean
/// syllable, marks of Arabic and of Japanese kana.
bool is_mark(char32_t character) {
  return (character >= 0x0300 && character <= 0x036F) ||
         (character >= 0x1160 && character <= 0x11FF) ||
         (character >= 0x0653 && character <= 0x0655) || character == 0x3099 || character == 0x309A;
}

std::vector<Letter> letters_of(std::string_view name) {
  std::vector<Letter> letters{};
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t bytes = std::min(bytes_of_character(name[at]), name.size() - at);
    if (!letters.empty() && is_mark(character_of(name.substr(at, bytes)))) {
      Letter& letter = letters.back();
      letter = {{letter.bytes.data(), letter.bytes.size() + bytes}, true};
    } else {
      letters.push_back({name.substr(at, bytes)});
    }
    at += bytes;
  }
  return letters;
}

/// The same for all names that differ in their accented letters only.
std::string without_accented_letters(const std::vector<Letter>& letters) {
  std::string rest{};
  for (const Letter& letter : letters) rest += letter.is_ascii() ? letter.bytes.front() : '\0';
  return rest;
}

bool are_forms_of_one_letter(const Letter& one, const Letter& other) {
  return one.bytes == other.bytes ||
         (one.has_marks != other.has_marks && !one.is_ascii() && !other.is_ascii());
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> names_in_two_forms(
    const std::vector<std::string>& names) {
  std::unordered_map<std::string, std::vector<std::size_t>> alike{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<Letter> letters = letters_of(names[i]);
    if (std::all_of(letters.begin(), letters.end(),
                    [](const Letter& each) { return each.is_ascii(); })) {
      continue;
    }
    std::vector<std::size_t>& earlier = alike[without_accented_letters(letters)];
    for (const std::size_t before : earlier) {
      const std::vector<Letter> there = letters_of(names[before]);
      if (names[before] != names[i] && std::equal(letters.begin(), letters.end(), there.begin(),
                                                  there.end(), are_forms_of_one_letter)) {
        return std::pair(before, i);
      }
    }
    earlier.push_back(i);
  }
  return std::nullopt;
}

std::string label_form(std::string_view label) {
  const auto is_digit = [label](std::size_t i) {
    return i < label.size() && label[i] >= '0' && label[i] <= '9';
  };
  std::string form{};
  for (std::size_t i = 0; i < label.size(); ++i) {
    const bool begins_number = is_digit(i) && (i == 0 || !is_digit(i - 1));
    if (begins_number) {
      while (label[i] == '0' && is_digit(i + 1)) ++i;
    }
    const char letter = label[i];
    form += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return form;
}

}  // namespace asperity
