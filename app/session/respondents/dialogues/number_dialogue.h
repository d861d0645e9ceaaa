// Reads a number above 0.

#pragma once

#include <string>
#include <variant>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {

class NumberDialogue final : public AnswerDialogue {
 public:
  std::string prompt() const override { return "Your number: "; }
  std::variant<NextLine, Answer> take(const std::string& typed) override;
};

}  // namespace asperity
