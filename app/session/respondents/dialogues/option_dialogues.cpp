// Accepts the number of an option; an assignment takes one number for each surface in turn.

#include "app/session/respondents/dialogues/option_dialogues.h"

#include <algorithm>

#include "app/session/respondents/form_answer.h"

namespace asperity {

namespace {

/// The index of the option that was typed as a number from 1.
std::optional<std::size_t> option_typed(const std::string& typed, std::size_t options) {
  const std::optional<std::size_t> number = whole_number(typed);
  if (!number || *number < 1 || *number > options) return {};
  return *number - 1;
}

NextLine number_needed(std::size_t options) {
  return {"Please enter a number from 1 to " + std::to_string(options) + "."};
}

}  // namespace

std::variant<NextLine, Answer> ChoiceDialogue::take(const std::string& typed) {
  const std::optional<std::size_t> option = option_typed(typed, options_);
  if (!option) return number_needed(options_);
  return Answer(ChosenOption{*option});
}

std::string AssignmentDialogue::prompt() const {
  return "Surface " + trial_.presentations.at(assigned_.options.size()).code + " is picture: ";
}

std::variant<NextLine, Answer> AssignmentDialogue::take(const std::string& typed) {
  const std::optional<std::size_t> option = option_typed(typed, options_);
  if (!option) return number_needed(options_);
  if (std::find(assigned_.options.begin(), assigned_.options.end(), *option) !=
      assigned_.options.end()) {
    return NextLine{"That picture is already assigned. Please choose another one."};
  }
  assigned_.options.push_back(*option);
  if (assigned_.options.size() < trial_.presentations.size()) return NextLine{};
  return Answer(assigned_);
}

std::string AssignmentDialogue::note_on_discarding() const {
  return assigned_.options.empty() ? std::string()
                                   : "After that, please assign all pictures again.";
}

}  // namespace asperity
