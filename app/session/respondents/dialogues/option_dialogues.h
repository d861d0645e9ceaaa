// Reads an answer given as the numbers of options: a choice, or an assignment.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {

class ChoiceDialogue final : public AnswerDialogue {
 public:
  explicit ChoiceDialogue(const TrialQuestion& question) : options_(question.options.size()) {}

  std::string prompt() const override { return "Your answer: "; }
  std::variant<NextLine, Answer> take(const std::string& typed) override;

 private:
  std::size_t options_ = 0;
};

/// Asks for the option of one surface after another.
class AssignmentDialogue final : public AnswerDialogue {
 public:
  AssignmentDialogue(const Trial& trial, const TrialQuestion& question)
      : trial_(trial), options_(question.options.size()) {}

  std::string prompt() const override;
  std::variant<NextLine, Answer> take(const std::string& typed) override;
  std::string note_on_discarding() const override;

 private:
  const Trial& trial_;
  std::size_t options_ = 0;
  AssignedOptions assigned_{};
};

}  // namespace asperity
