// Numbers for messages, by to_chars: std::to_string would follow the locale.

#include "analysis/number_text.h"

#include <array>
#include <charconv>

namespace asperity {

std::string number_text(double number) {
  std::array<char, 32> text{};  // the longest, such as -2.2250738585072014e-308, has 24
  const auto result = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), result.ptr};
}

std::string fixed(double number, int decimals) {
  std::array<char, 64> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), number,
                                    std::chars_format::fixed, decimals);
  return {text.data(), result.ptr};
}

}  // namespace asperity
