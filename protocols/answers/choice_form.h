// One of several options.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct TrialQuestion;

/// The answer is one option.
struct ChoiceForm {
  static constexpr std::string_view kName = "choice";
};

struct ChosenOption {
  std::size_t option = 0;  ///< index in TrialQuestion::options
};

constexpr int items_of(const ChoiceForm&, int) noexcept { return 1; }
std::vector<AnsweredItem> items_of(const TrialQuestion& question, const ChoiceForm&,
                                   const ChosenOption& answer);
std::vector<std::string> problems_with(const TrialQuestion& question, const ChoiceForm&,
                                       const AnsweredItem& stored);
std::string label_of(const TrialQuestion& question, const ChoiceForm&, const std::string& stored);

}  // namespace asperity
