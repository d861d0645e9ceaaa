// Replaces the placeholders %1 … by translated arguments, and capitalises a sentence unless a name begins it.

#include "analysis/words/phrase.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace asperity {

namespace {

/// The index of the argument of a placeholder at `at`: 2 for "%3".
std::optional<std::size_t> place_at(const std::string& words, std::size_t at) {
  if (at >= words.size() || words[at] != '%' || at + 1 >= words.size()) return {};
  const char digit = words[at + 1];
  if (digit < '1' || digit > '9') return {};
  return static_cast<std::size_t>(digit - '1');
}

/// For ASCII and for the accented letters of Latin-1, which have two bytes in UTF-8 (ä, é, ø).
void make_capital(std::string& text) {
  if (text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  } else if (text.size() > 1 && text[0] == '\xC3' && text[1] >= '\xA0' && text[1] <= '\xBE' &&
             text[1] != '\xB7') {  // ÷
    text[1] = static_cast<char>(text[1] - '\x20');
  }
}

}  // namespace

Phrase Phrase::filled(std::vector<Phrase> arguments) const {
  Phrase full = *this;
  full.arguments_ = std::move(arguments);
  return full;
}

Phrase Phrase::coded(const char* code) const {
  Phrase named = *this;
  named.code_ = code;
  return named;
}

Phrase Phrase::as_sentence() const {
  Phrase sentence = *this;
  sentence.is_sentence_ = true;
  return sentence;
}

std::string Phrase::english() const {
  return translated([](const char*, const char* words) { return std::string(words); });
}

bool Phrase::begins_with_a_name(const LookUp& look_up) const {
  const std::string words = context_ == nullptr ? words_ : look_up(context_, words_.c_str());
  const std::optional<std::size_t> place = place_at(words, 0);
  if (!place || *place >= arguments_.size()) return false;
  const Phrase& first = arguments_[*place];
  return first.context_ == nullptr || first.begins_with_a_name(look_up);
}

std::string Phrase::translated(const LookUp& look_up) const {
  const std::string words = context_ == nullptr ? words_ : look_up(context_, words_.c_str());
  std::string text{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::optional<std::size_t> place = place_at(words, i);
    // A label or message may contain a per cent sign: it is not a placeholder without an argument
    // for it.
    if (place && *place < arguments_.size()) {
      const Phrase& argument = arguments_[*place];
      text += argument.is_verbatim() ? look_up(nullptr, argument.words_.c_str())
                                     : argument.translated(look_up);
      ++i;
    } else {
      text += words[i];
    }
  }
  if (is_sentence_ && !text.empty()) {
    if (!begins_with_a_name(look_up)) make_capital(text);
    if (text.back() != '.' && text.back() != '!' && text.back() != '?') text += '.';
  }
  return text;
}

}  // namespace asperity
