// Divides a text into its characters and its placeholders, and writes the values in their place.

#include "protocols/texts/placeholders.h"

#include <array>
#include <cctype>
#include <cstddef>
#include <variant>

#include "protocols/design/wording.h"

namespace asperity {

namespace {

constexpr int kFirstWord = 2;
constexpr std::array<std::string_view, 11> kEnglish{
    "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};
constexpr std::array<std::string_view, 11> kGerman{
    "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn", "elf", "zwölf"};

using Piece = std::variant<std::string, Placeholder>;

Placeholder placeholder_of(std::string_view inside, bool is_closed) {
  Placeholder found{.is_closed = is_closed};
  std::size_t bar = inside.find('|');
  found.name = inside.substr(0, bar);
  while (bar != std::string_view::npos) {
    const std::size_t next = inside.find('|', bar + 1);
    found.forms.emplace_back(inside.substr(bar + 1, next - bar - 1));
    bar = next;
  }
  return found;
}

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces{};
  std::string characters{};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '{' || text.substr(i, 2) == "{{") {
      characters += text[i];
      if (text[i] == '{') ++i;
      continue;
    }
    const std::size_t end = text.find_first_of("{}", i + 1);
    const bool is_closed = end != std::string_view::npos && text[end] == '}';
    pieces.emplace_back(std::move(characters));
    characters.clear();
    pieces.emplace_back(placeholder_of(text.substr(i + 1, end - i - 1), is_closed));
    i = end == std::string_view::npos ? text.size() : is_closed ? end : end - 1;
  }
  pieces.emplace_back(std::move(characters));
  return pieces;
}

std::string as_written(const Placeholder& placeholder) {
  std::string text = '{' + placeholder.name;
  for (const std::string& form : placeholder.forms) text += '|' + form;
  return placeholder.is_closed ? text + '}' : text;
}

/// After the end of another one, or of a paragraph; "e.g. " and "z. B. " end none.
bool begins_sentence(std::string_view before) {
  const std::size_t last = before.find_last_not_of(" \n");
  if (last == std::string_view::npos) return true;
  if (before.substr(last).find("\n\n") != std::string_view::npos) return true;
  if (before[last] == '!' || before[last] == '?') return true;
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const bool is_one_letter =
      last > 0 && is_letter(before[last - 1]) && (last == 1 || !is_letter(before[last - 2]));
  return before[last] == '.' && !is_one_letter;
}

std::string_view joint_of_list(std::string_view language) {
  if (is_language(language, "en")) return " and ";
  return is_language(language, "de") ? " und " : ", ";
}

std::string text_of(const DesignValue& value, std::string_view before, std::string_view language) {
  if (!value.names.empty()) return listed_words(value.names, joint_of_list(language));
  const std::string_view word = number_word(value.number, language);
  std::string text = word.empty() ? std::to_string(value.number) : std::string(word);
  if (value.is_largest) {
    text = (is_language(language, "en")   ? "at most "
            : is_language(language, "de") ? "höchstens "
                                          : "≤ ") +
           text;
  }
  if (begins_sentence(before)) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text;
}

}  // namespace

bool is_language(std::string_view tag, std::string_view language) {
  return tag.starts_with(language) &&
         (tag.size() == language.size() || tag[language.size()] == '-');
}

std::string_view number_word(int number, std::string_view language) {
  const auto place = static_cast<std::size_t>(number - kFirstWord);
  if (number < kFirstWord || place >= kEnglish.size()) return {};
  if (is_language(language, "en")) return kEnglish[place];
  return is_language(language, "de") ? kGerman[place] : std::string_view{};
}

std::vector<Placeholder> placeholders_in(std::string_view text) {
  std::vector<Placeholder> found{};
  for (Piece& piece : pieces_of(text)) {
    if (auto* const placeholder = std::get_if<Placeholder>(&piece)) {
      found.push_back(std::move(*placeholder));
    }
  }
  return found;
}

std::string with_values(std::string_view text, const DesignValues& values,
                        std::string_view language) {
  std::string made{};
  for (const Piece& piece : pieces_of(text)) {
    const auto* const placeholder = std::get_if<Placeholder>(&piece);
    if (placeholder == nullptr) {
      made += std::get<std::string>(piece);
      continue;
    }
    const auto value = values.find(placeholder->name);
    if (value == values.end() || !placeholder->is_closed ||
        (!placeholder->forms.empty() && placeholder->forms.size() != 2)) {
      made += as_written(*placeholder);
    } else if (placeholder->forms.empty()) {
      made += text_of(value->second, made, language);
    } else {
      made += placeholder->forms[value->second.number == 1 ? 0 : 1];
    }
  }
  return made;
}

}  // namespace asperity
