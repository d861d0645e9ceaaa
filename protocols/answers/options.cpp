// Compares values with the options of the question, and marks them as correct or incorrect.

#include "protocols/answers/options.h"

#include <algorithm>

namespace asperity {

std::optional<bool> is_correct(const TrialQuestion& question, int item, const std::string& answer) {
  const auto place = static_cast<std::size_t>(item - 1);
  if (place >= question.correct.size()) return {};
  return answer == question.correct[place];
}

AnsweredItem chosen_item(const TrialQuestion& question, int item, std::size_t option) {
  const std::string& value = question.options.at(option).value;
  return {.item = item, .answer = value, .correct = is_correct(question, item, value)};
}

std::vector<std::string> problems_with_option(const TrialQuestion& question,
                                              const AnsweredItem& stored) {
  std::vector<std::string> problems{};
  const bool is_option =
      std::any_of(question.options.begin(), question.options.end(),
                  [&stored](const Option& option) { return option.value == stored.answer; });
  if (!is_option)
    problems.emplace_back(
        "the response is not among the options of the trial; restore the study from a copy");
  if (is_correct(question, stored.item, stored.answer) != stored.correct) {
    problems.emplace_back(
        "the response is not marked correct or incorrect as in the planned trial; restore the "
        "study from a copy");
  }
  return problems;
}

std::string label_of_option(const TrialQuestion& question, const std::string& value) {
  const auto option = std::find_if(question.options.begin(), question.options.end(),
                                   [&value](const Option& each) { return each.value == value; });
  return option == question.options.end() ? "?" : option->label;
}

}  // namespace asperity
