// Stores one item per surface, with the option that was assigned to it.

#include "protocols/answers/assignment_form.h"

#include "protocols/answers/options.h"

namespace asperity {

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const AssignmentForm&,
                                   const AssignedOptions& answer) {
  std::vector<AnsweredItem> items{};
  for (const std::size_t option : answer.options) {
    items.push_back(chosen_item(question, static_cast<int>(items.size()) + 1, option));
  }
  return items;
}

std::vector<std::string> problems_with(const TrialQuestion& question, const AssignmentForm&,
                                       const AnsweredItem& stored) {
  return problems_with_option(question, stored);
}

std::string label_of(const TrialQuestion& question, const AssignmentForm&,
                     const std::string& stored) {
  return label_of_option(question, stored);
}

}  // namespace asperity
