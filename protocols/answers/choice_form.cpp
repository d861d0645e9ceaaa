// Stores the chosen option as the only item.

#include "protocols/answers/choice_form.h"

#include "protocols/answers/options.h"

namespace asperity {

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const ChoiceForm&,
                                   const ChosenOption& answer) {
  return {chosen_item(question, 1, answer.option)};
}

std::vector<std::string> problems_with(const TrialQuestion& question, const ChoiceForm&,
                                       const AnsweredItem& stored) {
  return problems_with_option(question, stored);
}

std::string label_of(const TrialQuestion& question, const ChoiceForm&, const std::string& stored) {
  return label_of_option(question, stored);
}

}  // namespace asperity
