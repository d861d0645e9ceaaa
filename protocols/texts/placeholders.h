// Declares the placeholders in texts that participants read: {trials} is replaced by the number of the design.
//
// {name} becomes the value, {name|form|form} the first form where the value is 1 and otherwise the second, and {{ a brace.
// Which names there are: design_numbers.h. A text is read for the participant's own plan; the file keeps the placeholder.

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// What a placeholder stands for.
struct DesignValue {
  int number = 0;
  /// A rule can end a track or a practice earlier: the text states the number with "at most".
  bool is_largest = false;
  /// In place of the number: "A", "B" and "C".
  std::vector<std::string> names{};
};

/// By the name of the placeholder.
using DesignValues = std::map<std::string, DesignValue, std::less<>>;

/// One placeholder of a text.
struct Placeholder {
  std::string name{};
  std::vector<std::string> forms{};  ///< empty, or those that the text states
  bool is_closed = true;             ///< otherwise the text ends before the closing brace
};

/// All of a text, in its order.
std::vector<Placeholder> placeholders_in(std::string_view text);

/// The text with the values. Numbers from 2 to 12 are words in English and German and begin a sentence with a capital; others
/// are digits. A placeholder without a value, or with another number of forms than two, stays as it is written.
std::string with_values(std::string_view text, const DesignValues& values,
                        std::string_view language);

/// Two to twelve in the language of a BCP 47 tag, empty for other numbers and languages.
std::string_view number_word(int number, std::string_view language);

/// Whether a BCP 47 tag is of this language: "de" of "de" and "de-AT".
bool is_language(std::string_view tag, std::string_view language);

}  // namespace asperity
