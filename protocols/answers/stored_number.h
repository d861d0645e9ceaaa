// Reads a number from the text of a stored answer.

#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace asperity {

/// The number that a whole text is; nothing where it is not one.
inline std::optional<double> stored_number(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || read != end) return {};
  return number;
}

}  // namespace asperity
