// Numbers for messages, by to_chars: std::to_string would follow the locale.

#include "analysis/numbers/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

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

namespace {

/// The digits at the beginning of `text`, which are removed from it.
std::string_view taken_digits(std::string_view& text) {
  const std::string_view digits =
      text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size()));
  text.remove_prefix(digits.size());
  return digits;
}

/// The exponent after the "e" with which `text` begins, 0 without one; nullopt if it is not valid.
std::optional<int> exponent_of(std::string_view text) {
  constexpr std::size_t kMostDigits = 4;
  if (text.empty()) return 0;
  if (text.front() != 'e' && text.front() != 'E') return {};
  text.remove_prefix(1);
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const std::string_view digits = taken_digits(text);
  if (digits.empty() || digits.size() > kMostDigits || !text.empty()) return {};
  int exponent = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  return is_negative ? -exponent : exponent;
}

/// 0.DIGITS · 10^`point` with the point among the digits or near them, otherwise with an exponent, as ECMAScript writes
/// numbers.
std::string decimal_text(std::string digits, int point) {
  constexpr int kMostZerosBefore = 5;
  constexpr int kLongestInteger = 21;
  const int count = static_cast<int>(digits.size());
  if (point < -kMostZerosBefore || point > kLongestInteger) {
    if (count > 1) digits.insert(1, ".");
    return digits + 'e' + std::to_string(point - 1);
  }
  if (point <= 0) return "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (point >= count) return digits + std::string(static_cast<std::size_t>(point - count), '0');
  return digits.insert(static_cast<std::size_t>(point), ".");
}

}  // namespace

std::optional<std::string> shifted_decimal(std::string_view number, int places) {
  std::string_view rest = number;
  const bool is_negative = rest.starts_with('-');
  if (is_negative) rest.remove_prefix(1);
  const std::string_view whole = taken_digits(rest);
  if (whole.empty() || (whole.size() > 1 && whole.front() == '0')) return {};
  std::string_view fraction{};
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    fraction = taken_digits(rest);
    if (fraction.empty()) return {};
  }
  const std::optional<int> exponent = exponent_of(rest);
  if (!exponent) return {};
  if (places == 0) return std::string(number);
  std::string digits = std::string(whole) + std::string(fraction);
  const std::size_t first = digits.find_first_not_of('0');
  if (first == std::string::npos) return "0";
  digits.erase(digits.find_last_not_of('0') + 1);
  digits.erase(0, first);
  const int point = static_cast<int>(whole.size()) - static_cast<int>(first) + *exponent + places;
  return (is_negative ? "-" : "") + decimal_text(std::move(digits), point);
}

std::string counted(std::size_t number, std::string_view one, std::string_view several) {
  return std::to_string(number) + ' ' + std::string(number == 1 ? one : several);
}

}  // namespace asperity
