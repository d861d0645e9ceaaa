#include "app/findings/reading_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "analysis/number_text.h"

namespace asperity {

namespace {

constexpr int kReadingDigits = 4;
constexpr const char* kThinSpace = "\u202F";

std::string with_digits(double value, std::chars_format format, int digits) {
  std::array<char, 48> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
  return {text.data(), result.ptr};
}

struct Prefix {
  const char* text = "";
  double factor = 1.0;
};

/// The prefix that leaves one to three digits before the point; none for units other than metres,
/// seconds and those derived from them.
Prefix prefix_of(double value, std::string_view unit) {
  constexpr std::array<Prefix, 4> kPrefixes{Prefix{"", 1.0}, Prefix{"m", 1e-3}, Prefix{"µ", 1e-6},
                                            Prefix{"n", 1e-9}};
  const bool takes_one = unit == "s" || unit == "m" || unit == "m/s";
  if (!takes_one || value == 0.0) return {};
  for (const Prefix& prefix : kPrefixes) {
    if (std::abs(value) >= 0.9995 * prefix.factor) return prefix;
  }
  return kPrefixes.back();
}

}  // namespace

std::string reading_number(double value) {
  if (value == std::round(value) && std::abs(value) < 1e9) return fixed(value, 0);
  const bool in_powers = std::abs(value) < 1e-4 || std::abs(value) >= 1e9;
  return in_powers ? with_digits(value, std::chars_format::scientific, 1)
                   : with_digits(value, std::chars_format::general, kReadingDigits);
}

std::string reading_p_cell(double p) {
  if (p < 0.001) return "< .001";
  const std::string digits = fixed(p, 3);
  if (digits == "1.000") return "> .999";
  return digits.starts_with("0.") ? digits.substr(1) : digits;
}

std::string reading_p(double p) {
  const std::string cell = reading_p_cell(p);
  return (cell.starts_with('.') ? "p = " : "p ") + cell;
}

std::string reading_percent(double share) {
  // From two decimals of the proportion, so that tables, which print these, agree.
  std::string digits = fixed(share, 2);
  digits.erase(digits.find('.'), 1);
  int percent = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), percent);
  const std::string whole = std::to_string(percent);
  const bool hides = (whole == "0" && share > 0.0) || (whole == "100" && share < 1.0);
  if (!hides) return whole + " %";
  const std::string decimal = fixed(100.0 * share, 1);
  if (decimal == "0.0") return "< 0.1 %";
  return decimal == "100.0" ? "> 99.9 %" : decimal + " %";
}

std::string reading_signed(double value, int decimals) {
  const std::string text = fixed(std::abs(value), decimals);
  const bool is_nothing = text.find_first_of("123456789") == std::string::npos;
  return (value < 0.0 && !is_nothing ? "−" : "") + text;
}

std::string reading_bounded(double value, int decimals) {
  std::string text = reading_signed(value, decimals);
  const std::size_t digits = text.find_first_of("0123456789");
  if (text.compare(digits, 2, "0.") == 0) text.erase(digits, 1);
  return text;
}

std::string reading_points(double difference) { return reading_signed(100.0 * difference, 1); }

std::string reading_quantity(double value, const std::string& unit) {
  const Prefix prefix = prefix_of(value, unit);
  const double shown = value / prefix.factor;
  const std::string number =
      std::abs(shown) >= 1000.0 || shown == std::round(shown) ? fixed(shown, 0)
      : std::abs(shown) < 1e-3 ? with_digits(shown, std::chars_format::scientific, 1)
                               : with_digits(shown, std::chars_format::general, 3);
  if (unit.empty() || unit == "1") return number;
  return number + ' ' + prefix.text + unit;
}

std::string reading_count(std::uint64_t count) {
  const std::string digits = std::to_string(count);
  if (digits.size() < 5) return digits;
  std::string text{};
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += kThinSpace;
    text += digits[i];
  }
  return text;
}

std::string count_in_words(std::uint64_t count) {
  constexpr std::array<const char*, 10> kWords{"no",   "one", "two",   "three", "four",
                                               "five", "six", "seven", "eight", "nine"};
  return count < kWords.size() ? kWords[count] : reading_count(count);
}

}  // namespace asperity
