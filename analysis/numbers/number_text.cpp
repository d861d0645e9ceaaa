// Numbers for messages, by to_chars: std::to_string would follow the locale.

#include "analysis/numbers/number_text.h"

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
  const std::string_view whole(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
  const bool is_less_than_nothing =
      whole.starts_with('-') && whole.find_first_not_of("-0.") == std::string_view::npos;
  return std::string(is_less_than_nothing ? whole.substr(1) : whole);
}

std::string counted(std::size_t number, std::string_view one, std::string_view several) {
  return std::to_string(number) + ' ' + std::string(number == 1 ? one : several);
}

}  // namespace asperity
