// Writes the numbers of warnings.

#include "app/session/rehearsal/rehearsal_warning.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

/// What arithmetic may add to a limit that is just met.
constexpr double kLeftByArithmetic = 1e-6;

double second_digit_of(double value) { return std::pow(10.0, std::floor(std::log10(value)) - 1.0); }

}  // namespace

std::string in_three_digits(double value) {
  const double size = std::abs(value);
  if (size >= 100.0 || size == 0.0) return fixed(value, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(size)));
  return fixed(value, std::clamp(decimals, 0, 12));
}

double two_digits_up(double value) {
  const double digit = second_digit_of(value);
  return digit * std::ceil(value / digit - kLeftByArithmetic);
}

double two_digits_down(double value) {
  const double digit = second_digit_of(value);
  return digit * std::floor(value / digit + kLeftByArithmetic);
}

}  // namespace asperity
