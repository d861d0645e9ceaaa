// The answer to a trial's question as it is typed at a terminal: one dialogue per form of answer.

#pragma once

#include <memory>
#include <string>
#include <variant>

#include "protocols/answers/trial_question.h"
#include "protocols/design/trial.h"

namespace asperity {

/// Another line is needed: `complaint` states why the typed one does not count, or is empty.
struct NextLine {
  std::string complaint{};
};

/// Asks line by line until the answer is complete.
class AnswerDialogue {
 public:
  virtual ~AnswerDialogue() = default;
  AnswerDialogue(const AnswerDialogue&) = delete;
  AnswerDialogue& operator=(const AnswerDialogue&) = delete;

  /// What stands before the next line that is typed: "Your answer: ".
  virtual std::string prompt() const = 0;
  virtual std::variant<NextLine, Answer> take(const std::string& typed) = 0;
  /// Stated when the participant feels a surface again instead, which discards what was typed; or empty.
  virtual std::string note_on_discarding() const { return {}; }

 protected:
  AnswerDialogue() = default;
};

/// For the question of a trial, which must outlive the dialogue.
std::unique_ptr<AnswerDialogue> dialogue_for(const Trial& trial);

}  // namespace asperity
