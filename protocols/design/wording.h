// Declares the wording of diagnostics.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The names as a list: "a", "b" or "c".
std::string one_of(const std::vector<std::string>& names);
/// "30, 45 and 60"; `joint` is before the last one.
std::string listed_words(const std::vector<std::string>& words, std::string_view joint = " and ");
/// The name that is most similar to `written`, if one is similar enough.
std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names);
/// `; did you mean "x"?` if one of the names is similar to `written`, otherwise empty.
std::string did_you_mean(std::string_view written, const std::vector<std::string>& names);
/// The text in quotation marks, shortened.
std::string in_quotes(std::string_view text);
/// The shortest decimal text that reads back as the same number.
std::string digits(double value);

/// "there is no WHAT "name"; did you mean …" or "…; declared: "a" or "b"", with the names that a map declares.
std::string unknown_name(std::string_view what, const std::string& name,
                         const std::vector<std::string>& declared);
template <class Map>
std::string unknown_name(std::string_view what, const std::string& name, const Map& declared) {
  std::vector<std::string> names{};
  for (const auto& [key, value] : declared) names.push_back(key);
  return unknown_name(what, name, names);
}

}  // namespace asperity
