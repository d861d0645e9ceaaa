// Words for diagnostics.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// "a", "b" or "c"
std::string one_of(const std::vector<std::string>& names);
/// The name that is close to what was written, if one is.
std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names);
/// `; did you mean "x"?` where one of the names is close to what was written, else nothing.
std::string did_you_mean(std::string_view written, const std::vector<std::string>& names);
/// In quotation marks, shortened.
std::string in_quotes(std::string_view text);
/// The shortest digits that read back as the same number.
std::string digits(double value);

/// "there is no WHAT "name"; did you mean …" or "…; declared: "a" or "b"", of the names that a map declares.
std::string unknown_name(std::string_view what, const std::string& name,
                         const std::vector<std::string>& declared);
template <class Map>
std::string unknown_name(std::string_view what, const std::string& name, const Map& declared) {
  std::vector<std::string> names{};
  for (const auto& [key, value] : declared) names.push_back(key);
  return unknown_name(what, name, names);
}

}  // namespace asperity
