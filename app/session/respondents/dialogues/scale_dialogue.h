// Reads a point on a scale, as its number.

#pragma once

#include <string>
#include <variant>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {

class ScaleDialogue final : public AnswerDialogue {
 public:
  explicit ScaleDialogue(const ScaleForm& form) : form_(form) {}

  /// The numbers of the points with their labels.
  std::string introduction() const override;
  std::string prompt() const override { return "Your answer: "; }
  std::variant<NextLine, Answer> take(const std::string& typed) override;

 private:
  ScaleForm form_{};
};

}  // namespace asperity
