#include "app/phrase.h"

#include <cstddef>
#include <utility>

namespace asperity {

namespace {

/// "%3" at `at` is 2: the place in the arguments.
std::optional<std::size_t> place_at(const std::string& words, std::size_t at) {
  if (at >= words.size() || words[at] != '%' || at + 1 >= words.size()) return {};
  const char digit = words[at + 1];
  if (digit < '1' || digit > '9') return {};
  return static_cast<std::size_t>(digit - '1');
}

/// Of ASCII and of the letters with accents that two bytes of UTF-8 hold in Latin-1 (ä, é, ø).
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
    // A label or message may have a per cent sign: it is no place where there is nothing for it.
    if (place && *place < arguments_.size()) {
      const Phrase& argument = arguments_[*place];
      const bool is_the_same = argument.context_ == nullptr && argument.arguments_.empty();
      text +=
          is_the_same ? look_up(nullptr, argument.words_.c_str()) : argument.translated(look_up);
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

std::optional<std::vector<std::string>> Phrase::places_in(const std::string& text) const {
  std::vector<std::string> between{""};  // the words before, between and after the places
  std::vector<std::size_t> places{};
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (const std::optional<std::size_t> place = place_at(words_, i)) {
      places.push_back(*place);
      between.emplace_back();
      ++i;
    } else {
      between.back() += words_[i];
    }
  }
  if (!text.starts_with(between.front())) return {};
  std::size_t read = between.front().size();
  std::vector<std::string> found(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string& after = between[i + 1];
    const bool is_last = i + 1 == places.size();
    const std::size_t end = !is_last                ? text.find(after, read)
                            : text.ends_with(after) ? text.size() - after.size()
                                                    : std::string::npos;
    if (end == std::string::npos || end < read) return {};
    found.at(places[i]) = text.substr(read, end - read);
    read = end + after.size();
  }
  if (read != text.size()) return {};
  return found;
}

Phrase phrase_of(const std::exception& error) {
  if (const auto* phrased = dynamic_cast<const PhrasedError*>(&error)) return phrased->said();
  return std::string(error.what());
}

}  // namespace asperity
