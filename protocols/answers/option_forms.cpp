// Stores one item per chosen option, and marks it as correct or incorrect where the question determines it.

#include "protocols/answers/option_forms.h"

#include <algorithm>
#include <optional>

#include "protocols/answers/question.h"

namespace asperity {

namespace {

/// Whether `answer` is the correct response of an item; nothing where the question does not determine it.
std::optional<bool> is_correct(const Question& question, int item, const std::string& answer) {
  const auto place = static_cast<std::size_t>(item - 1);
  if (place >= question.correct.size()) return {};
  return answer == question.correct[place];
}

AnsweredItem chosen_item(const Question& question, int item, std::size_t option) {
  const std::string& value = question.options.at(option).value;
  return {.item = item, .answer = value, .correct = is_correct(question, item, value)};
}

}  // namespace

std::vector<AnsweredItem> items_of(const Question& question, const ChoiceForm&,
                                   const ChosenOption& answer) {
  return {chosen_item(question, 1, answer.option)};
}

std::vector<AnsweredItem> items_of(const Question& question, const MultipleChoiceForm&,
                                   const ChosenOptions& answer) {
  std::vector<AnsweredItem> items{};
  for (const std::size_t option : answer.options) {
    items.push_back(chosen_item(question, static_cast<int>(option) + 1, option));
  }
  return items;
}

std::vector<AnsweredItem> items_of(const Question& question, const AssignmentForm&,
                                   const AssignedOptions& answer) {
  std::vector<AnsweredItem> items{};
  for (const std::size_t option : answer.options) {
    items.push_back(chosen_item(question, static_cast<int>(items.size()) + 1, option));
  }
  return items;
}

std::vector<std::string> problems_with_option(const Question& question,
                                              const AnsweredItem& stored) {
  std::vector<std::string> problems{};
  if (!question.option_of(stored.answer)) {
    problems.emplace_back(
        "the response is not among the options of the question; restore the study from a copy");
  }
  if (is_correct(question, stored.item, stored.answer) != stored.correct) {
    problems.emplace_back(
        "the response is not marked correct or incorrect as in the planned trial; restore the "
        "study from a copy");
  }
  return problems;
}

std::string label_of_option(const Question& question, const std::string& value) {
  const std::optional<std::size_t> option = question.option_of(value);
  return option ? question.options[*option].label : "?";
}

}  // namespace asperity
