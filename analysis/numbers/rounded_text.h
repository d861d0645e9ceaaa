// Computed numbers without the rounding errors in their last digits.

#pragma once

#include <array>
#include <charconv>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {

/// With so many significant digits, 1 to 17.
inline double with_digits(double value, int digits) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::scientific, digits - 1);
  std::from_chars(text.data(), written.ptr, value);
  return value;
}

/// With 12 significant digits: 1.5 for 1.5000000000000007.
inline double without_rounding_errors(double value) { return with_digits(value, 12); }

inline std::string rounded_text(double value) {
  return number_text(without_rounding_errors(value));
}

}  // namespace asperity
