// A number above 0: the estimate of a magnitude.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct TrialQuestion;

/// The answer is a number above 0, on a scale that the participant chooses.
struct NumberForm {
  static constexpr std::string_view kName = "number";
};

struct GivenNumber {
  double number = 0.0;
};

constexpr int items_of(const NumberForm&, int) noexcept { return 1; }
std::vector<AnsweredItem> items_of(const TrialQuestion& question, const NumberForm&,
                                   const GivenNumber& answer);
std::vector<std::string> problems_with(const TrialQuestion& question, const NumberForm&,
                                       const AnsweredItem& stored);
std::string label_of(const TrialQuestion& question, const NumberForm&, const std::string& stored);

}  // namespace asperity
