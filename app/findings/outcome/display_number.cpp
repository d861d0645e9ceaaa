// Formats with std::to_chars, whatever the locale; prefixes leave one to three digits before the point.

#include "app/findings/outcome/display_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/number_text.h"

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

/// The prefix that leaves one to three digits before the point; none for units other than metres, seconds, those derived from
/// them, and pascals.
Prefix prefix_of(double value, std::string_view unit) {
  constexpr std::array<Prefix, 4> kSmall{Prefix{"", 1.0}, Prefix{"m", 1e-3}, Prefix{"µ", 1e-6},
                                         Prefix{"n", 1e-9}};
  constexpr std::array<Prefix, 4> kLarge{Prefix{"G", 1e9}, Prefix{"M", 1e6}, Prefix{"k", 1e3},
                                         Prefix{"", 1.0}};
  const bool takes_small = unit == "s" || unit == "m" || unit == "m/s";
  if ((!takes_small && unit != "Pa") || value == 0.0) return {};
  const auto& prefixes = takes_small ? kSmall : kLarge;
  for (const Prefix& prefix : prefixes) {
    if (std::abs(value) >= 0.9995 * prefix.factor) return prefix;
  }
  return prefixes.back();
}

std::string display_digits(double value) {
  if (value == std::round(value) && std::abs(value) < 1e9) return fixed(value, 0);
  const bool in_powers = std::abs(value) < 1e-4 || std::abs(value) >= 1e9;
  return in_powers ? with_digits(value, std::chars_format::scientific, 1)
                   : with_digits(value, std::chars_format::general, kReadingDigits);
}

/// With a minus sign instead of the hyphen.
std::string with_minus(std::string number) {
  return number.starts_with('-') ? (number == "-0" ? "0" : "−" + number.substr(1)) : number;
}

constexpr std::string_view kNoBreak = "\u00A0";

bool begins_with_number(std::string_view word) {
  for (const std::string_view sign : {"−", "-", "±", "+", "."}) {
    if (word.starts_with(sign)) word.remove_prefix(sign.size());
  }
  return !word.empty() && word.front() >= '0' && word.front() <= '9';
}

bool is_relation(std::string_view word) {
  constexpr std::array<std::string_view, 7> kRelations{"=", "<", ">", "≤", "≥", "≈", "±"};
  return std::find(kRelations.begin(), kRelations.end(), word) != kRelations.end();
}

/// Whether the word, without the punctuation after it, is a unit as reports write them.
bool is_unit(std::string_view word) {
  constexpr std::array<std::string_view, 31> kUnits{
      "%",   "N",   "mN",    "m",   "cm",  "mm", "µm",  "nm",  "s",   "ms",   "µs",
      "ns",  "min", "h",     "Hz",  "kHz", "kg", "g",   "N/m", "m/s", "mm/s", "µm/s",
      "rad", "dB",  "dB(A)", "dBA", "bit", "Pa", "kPa", "MPa", "GPa"};
  if (std::find(kUnits.begin(), kUnits.end(), word) != kUnits.end()) return true;
  const std::size_t end = word.find_last_not_of(",.;:)]");
  return end != std::string_view::npos && end + 1 < word.size() &&
         std::find(kUnits.begin(), kUnits.end(), word.substr(0, end + 1)) != kUnits.end();
}

/// The end of the brackets that are opened at `open`, if they contain only numbers; otherwise `open`.
std::size_t end_of_numbers(std::string_view text, std::size_t open) {
  const std::size_t close = text.find(text[open] == '[' ? ']' : ')', open);
  if (close == std::string_view::npos) return open;
  std::string_view inner = text.substr(open + 1, close - open - 1);
  bool has_digit = false;
  while (!inner.empty()) {
    std::size_t length = 0;
    for (const std::string_view sign : {"−", "∞", "\u202F"}) {
      if (inner.starts_with(sign)) length = sign.size();
    }
    if (length == 0 &&
        std::string_view("0123456789.,;-+<>% e").find(inner.front()) != std::string_view::npos) {
      length = 1;
    }
    if (length == 0) return open;
    has_digit = has_digit || (inner.front() >= '0' && inner.front() <= '9');
    inner.remove_prefix(length);
  }
  return has_digit ? close : open;
}

}  // namespace

std::string display_number(double value) { return with_minus(display_digits(value)); }

std::string display_whole(std::int64_t value) { return with_minus(std::to_string(value)); }

std::string with_numbers_unbroken(const std::string& text) {
  std::vector<bool> is_inside(text.size(), false);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '[' && text[i] != '(') continue;
    for (const std::size_t end = end_of_numbers(text, i); i < end; ++i) is_inside[i] = true;
  }
  const std::string_view all = text;
  const auto word_after = [all](std::size_t space) {
    return all.substr(space + 1, std::min(all.find(' ', space + 1), all.size()) - space - 1);
  };
  std::string unbroken{};
  std::size_t word = 0;  // where the word before the space begins
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != ' ') {
      unbroken += text[i];
      continue;
    }
    const std::string_view before = all.substr(word, i - word);
    const std::string_view after = word_after(i);
    const std::size_t after_sign = i + 1 + after.size();
    const bool ends_with_digit = !before.empty() && before.back() >= '0' && before.back() <= '9';
    const bool is_joined = is_inside[i] || (is_relation(before) && begins_with_number(after)) ||
                           (is_relation(after) && after_sign < text.size() &&
                            begins_with_number(word_after(after_sign))) ||
                           (ends_with_digit && is_unit(after)) ||
                           (before == "N" && after.starts_with("s/m"));
    if (is_joined) {
      unbroken += kNoBreak;
    } else {
      unbroken += ' ';
    }
    word = i + 1;
  }
  return unbroken;
}

std::string display_p_cell(double p) {
  if (p < 0.001) return "< .001";
  const std::string digits = fixed(p, 3);
  if (digits == "1.000") return "> .999";
  return digits.starts_with("0.") ? digits.substr(1) : digits;
}

std::string display_p(double p) {
  const std::string cell = display_p_cell(p);
  return (cell.starts_with('.') ? "p = " : "p ") + cell;
}

std::string display_percent(double share) {
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

std::string display_signed(double value, int decimals) {
  const std::string text = fixed(std::abs(value), decimals);
  const bool is_nothing = text.find_first_of("123456789") == std::string::npos;
  return (value < 0.0 && !is_nothing ? "−" : "") + text;
}

int decimals_of(double size) {
  constexpr int kFewest = 2;
  constexpr int kMost = 5;
  if (!(size > 0.0) || !std::isfinite(size)) return kFewest;
  constexpr double kRounding = 1e-9;  // of a width that is a power of ten but for it
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(size) + kRounding)), kFewest, kMost);
}

int decimals_of_height(double size_um, int coarse) {
  constexpr double kCoarse_um = 10.0;
  constexpr int kMost = 9;
  if (!(size_um > 0.0 && size_um < kCoarse_um)) return coarse;
  return std::min(2 - static_cast<int>(std::floor(std::log10(size_um))), kMost);
}

std::string display_bounded(double value, int decimals) {
  std::string text = display_signed(value, decimals);
  const std::size_t digits = text.find_first_of("0123456789");
  if (text.compare(digits, 2, "0.") == 0) text.erase(digits, 1);
  return text;
}

std::string stated_quantity(double value, const std::string& unit) {
  const Prefix prefix = prefix_of(value, unit);
  // Twelve digits: 50 µm is not 50.00000000000001 µm.
  const std::string digits = with_digits(value / prefix.factor, std::chars_format::general, 12);
  const std::string whole_unit = unit == "1" ? std::string() : prefix.text + unit;
  return with_minus(digits) + (whole_unit.empty() ? "" : ' ' + whole_unit);
}

std::string display_points(double difference) { return display_signed(100.0 * difference, 1); }

std::string display_quantity(double value, const std::string& unit) {
  const Prefix prefix = prefix_of(value, unit);
  const double shown = value / prefix.factor;
  const std::string number =
      with_minus(std::abs(shown) >= 1000.0 || shown == std::round(shown) ? fixed(shown, 0)
                 : std::abs(shown) < 1e-3 ? with_digits(shown, std::chars_format::scientific, 1)
                                          : with_digits(shown, std::chars_format::general, 3));
  if (unit.empty() || unit == "1") return number;
  return number + ' ' + prefix.text + unit;
}

std::string display_count(std::uint64_t count) {
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
  return count < kWords.size() ? kWords[count] : display_count(count);
}

}  // namespace asperity
