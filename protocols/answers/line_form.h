// A drawn line whose length is the estimate of a magnitude.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocols/answers/number_range.h"

namespace asperity {

struct AnsweredItem;
struct Question;

/// The answer is the length of a line, which the participant draws from its left end; no number is shown.
///
/// A length is a proportion of the width of the participant's screen: the longest line has the proportion `longest`, and
/// the line is drawn in thousandths of it (steps 1 to kSteps), so that no length is 0.
struct LineForm {
  static constexpr std::string_view kName = "line";
  static constexpr int kSteps = 1000;

  double longest = 0.8;  ///< above 0; up to 0.9, which leaves margins at both sides

  double length_of(int step) const noexcept { return longest * step / kSteps; }
  NumberRange numbers() const noexcept { return {0.0, longest}; }
  bool can_be_stored_as(const std::string& text) const;
  bool operator==(const LineForm&) const = default;
};

struct DrawnLength {
  int step = 0;  ///< from 1 to LineForm::kSteps
};

std::vector<AnsweredItem> items_of(const Question& question, const LineForm& form,
                                   const DrawnLength& answer);

}  // namespace asperity
