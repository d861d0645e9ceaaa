// A number: an amount within limits, or the estimate of a magnitude.

#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/answers/number_range.h"

namespace asperity {

struct AnsweredItem;
struct Question;

/// The answer is a number within the limits.
struct NumberForm {
  static constexpr std::string_view kName = "number";

  std::optional<double> minimum{};
  std::optional<double> maximum{};
  std::string unit{};        ///< may be empty
  bool is_estimate = false;  ///< of a magnitude: above 0, on a scale that the participant chooses

  bool accepts(double number) const noexcept {
    return std::isfinite(number) && !(is_estimate && number <= 0.0) &&
           !(minimum && number < *minimum) && !(maximum && number > *maximum);
  }
  NumberRange numbers() const noexcept { return {minimum, maximum}; }
  bool can_be_stored_as(const std::string& text) const;
  bool operator==(const NumberForm&) const = default;
};

struct GivenNumber {
  double number = 0.0;
};

std::vector<AnsweredItem> items_of(const Question& question, const NumberForm&,
                                   const GivenNumber& answer);

}  // namespace asperity
