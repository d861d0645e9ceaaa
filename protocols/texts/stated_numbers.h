// Declares the search for statements about a design in a text: numbers before nouns, and words for parts that may be missing.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// "eight scales" in a text.
struct StatedNumber {
  std::string_view name{};  ///< of the number of the design (design_numbers.h): "scales"
  int number = 0;
  std::string words{};         ///< as they are written
  bool begins_clause = false;  ///< no word is before it: "Two surfaces are the same."
  bool is_about = false;       ///< "about 200 trials"
  std::string sentence{};      ///< in which it stands
};

/// The numbers that a text in English or German states of its design: digits, or one to twenty in words, before one of the nouns
/// of a fixed list, with at most two adjectives between them. Left out are ranges ("two to four", "2–4"), decimals, limits ("at
/// least two"), ordinals ("the first two", "every 20 trials"), conditions ("if two"), and one where it is an article or a pronoun. Empty in other languages. A
/// placeholder is no number.
std::vector<StatedNumber> numbers_stated_in(std::string_view text, std::string_view language);

/// The first of the phrases that the text contains and does not negate ("no pictures"), as it is written; empty without one. Phrases are in lower case; a word that
/// ends with "*" stands for all words with this beginning.
std::string phrase_in(std::string_view text, std::span<const std::string_view> phrases);

}  // namespace asperity
