// Declares the wording of diagnostics.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/words/phrase_lists.h"

namespace asperity {

/// The names as a list, in English: "a", "b" or "c". A sentence that is a phrase has joined_by_or(quoted(names)).
std::string one_of(const std::vector<std::string>& names);
/// "30, 45 and 60"; `joint` is before the last one.
std::string listed_words(const std::vector<std::string>& words, std::string_view joint = " and ");
/// The context of the names of keys, in quotation marks: a form shows their labels instead (app/gui/base/form_words.h).
inline constexpr const char* kNamesOfKeys = "NamesOfKeys";
Phrase key_name(std::string_view key);
/// The context of the words that choices of the tables of keys offer: a form shows their names.
inline constexpr const char* kWordsOfKeys = "WordsOfKeys";
/// In quotation marks.
Phrase word_name(std::string_view word);
/// The context of places of keys, JSON pointers: a form shows the labels that lead to the key.
inline constexpr const char* kPlacesOfKeys = "PlacesOfKeys";
Phrase place_name(std::string_view pointer);
/// The context of examples in JSON, with the words that lead to them: forms leave them out.
inline constexpr const char* kJsonOfFile = "JsonOfFile";
/// ", with JSON" at the end of a clause.
Phrase with_json(const std::string& json);
/// ", such as JSON".
Phrase such_as_json(const std::string& json);
/// Each in quotation marks.
std::vector<Phrase> quoted(const std::vector<std::string>& names);
std::vector<Phrase> key_names(const std::vector<std::string>& keys);
/// The context of the texts of the tables of keys.
inline constexpr const char* kTextsOfKeys = "Keys";
/// A text of the tables of keys: a label, a meaning, the problem of a condition.
Phrase phrase_of_key(std::string_view text);

/// The name that is most similar to `written`, if one is similar enough.
std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names);
/// `; did you mean "x"?` if one of the names is similar to `written`, otherwise empty.
std::string did_you_mean(std::string_view written, const std::vector<std::string>& names);
/// "PROBLEM; did you mean "x"?", or the problem alone if none of the names is similar to `written`.
Phrase with_guess(const Phrase& problem, std::string_view written,
                  const std::vector<std::string>& names);
/// PROBLEM with what to write instead of `name`: a similar name, or one of those that are declared.
Phrase with_declared_names(const Phrase& problem, const std::string& name,
                           const std::vector<std::string>& declared);
/// The text in quotation marks, shortened.
std::string in_quotes(std::string_view text);
/// The shortest decimal text that reads back as the same number.
std::string digits(double value);

/// "there is no WHAT "name"; did you mean …" or "…; use "a" or "b"", with the names that are declared, or that a map declares.
/// `what` is one of the words in wording.cpp.
Phrase unknown_name(std::string_view what, const std::string& name,
                    const std::vector<std::string>& declared);
template <class Map>
Phrase unknown_name(std::string_view what, const std::string& name, const Map& declared) {
  std::vector<std::string> names{};
  for (const auto& [key, value] : declared) names.push_back(key);
  return unknown_name(what, name, names);
}

}  // namespace asperity
