// A drawn line whose length is the estimate of a magnitude.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct TrialQuestion;

/// The answer is the length of a line, which the participant draws from its left end; no number is shown.
///
/// A length is a proportion of the width of the participant's screen: the longest line has the proportion `longest`, and
/// the line is drawn in thousandths of it (steps 1 to kSteps), so that no length is 0.
struct LineForm {
  static constexpr std::string_view kName = "line";
  static constexpr int kSteps = 1000;

  double longest = 0.8;  ///< above 0; up to 0.9, which leaves margins at both sides

  double length_of(int step) const noexcept { return longest * step / kSteps; }
  bool operator==(const LineForm&) const = default;
};

struct DrawnLength {
  int step = 0;  ///< from 1 to LineForm::kSteps
};

constexpr int items_of(const LineForm&, int) noexcept { return 1; }
std::vector<AnsweredItem> items_of(const TrialQuestion& question, const LineForm& form,
                                   const DrawnLength& answer);
std::vector<std::string> problems_with(const TrialQuestion& question, const LineForm& form,
                                       const AnsweredItem& stored);
/// The stored proportion.
std::string label_of(const TrialQuestion& question, const LineForm& form,
                     const std::string& stored);

}  // namespace asperity
