// Reads a line in a terminal: its length is the number of signs typed.

#pragma once

#include <string>
#include <variant>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {

/// A terminal of kColumns columns stands for the longest line; its width on the screen is unknown.
class LineDialogue final : public AnswerDialogue {
 public:
  static constexpr std::size_t kColumns = 50;

  std::string introduction() const override;
  std::string prompt() const override { return "Your line: "; }
  std::variant<NextLine, Answer> take(const std::string& typed) override;
};

}  // namespace asperity
