// Introduces each form, and hands the typed lines to the reader of typed answers.

#include "app/session/respondents/dialogues/answer_dialogue.h"

#include <algorithm>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/overloaded.h"
#include "app/session/respondents/typed_answer.h"

namespace asperity {

namespace {

/// The numbers of the points with their labels.
std::string points_of(const ScaleForm& scale) {
  std::string lines{};
  const auto add = [&](int step, const std::string& label) {
    lines += "  " + number_text(scale.value_at(step)) + (label.empty() ? "" : "  " + label) + '\n';
  };
  if (scale.labels_every_point()) {
    for (int step = 0; step <= scale.steps(); ++step) {
      add(step, scale.labels[static_cast<std::size_t>(step)]);
    }
    return lines;
  }
  add(0, scale.labels.empty() ? std::string() : scale.labels.front());
  lines += "  …\n";
  add(scale.steps(), scale.labels.empty() ? std::string() : scale.labels.back());
  return lines;
}

std::string numbers_up_to(std::size_t options) { return "from 1 to " + std::to_string(options); }

/// At a terminal options have numbers, and other ways of answering than in a window.
std::string complaint_of(const Question& question, const ParticipantMessage& message) {
  using What = ParticipantMessage::What;
  const std::string numbers = numbers_up_to(question.options.size());
  if (question.is_answered_by<ChoiceForm>()) return "Please enter a number " + numbers + '.';
  if (question.is_answered_by<MultipleChoiceForm>()) {
    return "Please enter one or more numbers " + numbers + '.';
  }
  if (message.what == What::line_needed) {
    return "Please draw a line of 1 to " + std::to_string(kLongestTypedLine) + " signs \"-\".";
  }
  const auto* const scale = std::get_if<ScaleForm>(&question.form);
  std::string text = text_of(message);
  if (scale != nullptr && scale->points > 0) {
    text.insert(text.size() - 1,
                ", in steps of " + number_text(scale->value_at(1) - scale->value_at(0)));
  }
  return text;
}

}  // namespace

std::string AnswerDialogue::introduction() const {
  return std::visit(Overloaded{[](const ScaleForm& scale) { return points_of(scale); },
                               [](const LineForm&) {
                                 return "  " + std::string(kLongestTypedLine, '-') +
                                        "  (the longest line)\n";
                               },
                               [](const MultipleChoiceForm&) {
                                 return std::string(
                                     "Enter the numbers of all that apply, separated by blanks.\n");
                               },
                               [](const auto&) { return std::string(); }},
                    question_.form);
}

std::string AnswerDialogue::prompt() const {
  if (question_.is_answered_by<LineForm>()) return "Your line: ";
  const auto* const number = std::get_if<NumberForm>(&question_.form);
  if (number != nullptr && number->is_estimate) return "Your number: ";
  return "Your answer" +
         (number == nullptr || number->unit.empty() ? "" : " (" + number->unit + ")") + ": ";
}

std::variant<NextLine, std::optional<Answer>> AnswerDialogue::take(const std::string& typed) {
  TypedAnswer read = typed_answer(question_, typed);
  if (const auto* const refusal = std::get_if<ParticipantMessage>(&read)) {
    return NextLine{complaint_of(question_, *refusal)};
  }
  return std::get<std::optional<Answer>>(std::move(read));
}

std::string AssignmentDialogue::prompt() const {
  return "Surface " + surfaces_[assigned_.options.size()].code + " is picture: ";
}

std::variant<NextLine, std::optional<Answer>> AssignmentDialogue::take(const std::string& typed) {
  const std::optional<std::size_t> number = whole_number(typed);
  if (!number || *number < 1 || *number > question_.options.size()) {
    return NextLine{"Please enter a number " + numbers_up_to(question_.options.size()) + '.'};
  }
  if (std::ranges::find(assigned_.options, *number - 1) != assigned_.options.end()) {
    return NextLine{"That picture is already assigned. Please choose another one."};
  }
  assigned_.options.push_back(*number - 1);
  if (assigned_.options.size() < surfaces_.size()) return NextLine{};
  return Answer(assigned_);
}

std::string AssignmentDialogue::note_on_discarding() const {
  return assigned_.options.empty() ? std::string()
                                   : "After that, please assign all pictures again.";
}

std::unique_ptr<AnswerDialogue> dialogue_for(const Question& question,
                                             std::span<const PlannedPresentation> surfaces) {
  if (question.is_answered_by<AssignmentForm>()) {
    return std::make_unique<AssignmentDialogue>(question, surfaces);
  }
  return std::make_unique<AnswerDialogue>(question);
}

}  // namespace asperity
