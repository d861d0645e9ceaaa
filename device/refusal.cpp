// Throws std::invalid_argument with the field, its value and the permitted values.

#include "device/refusal.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace asperity {

void refuse(std::string_view field, double value, std::string_view right) {
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  throw std::invalid_argument(std::string(field) + " is " +
                              std::string(digits.data(), written.ptr) + "; it must be " +
                              std::string(right) + ".");
}

void require_positive(std::string_view field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    refuse(field, value, "positive and finite");
  }
}

void require_not_negative(std::string_view field, double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    refuse(field, value, "at least 0 and finite");
  }
}

}  // namespace asperity
