// Reads the answer to a question of a trial at a terminal: one dialogue per form of answer.

#pragma once

#include <memory>
#include <string>
#include <variant>

#include "protocols/answers/trial_question.h"
#include "protocols/design/trial.h"

namespace asperity {

/// Another line is needed: `complaint` states why the typed one is not accepted, or is empty.
struct NextLine {
  std::string complaint{};
};

/// Asks for one line after another until the answer is complete.
class AnswerDialogue {
 public:
  virtual ~AnswerDialogue() = default;
  AnswerDialogue(const AnswerDialogue&) = delete;
  AnswerDialogue& operator=(const AnswerDialogue&) = delete;

  /// Lines shown once below the question, each with its end of line: the meaning of what can be
  /// typed; or empty.
  virtual std::string introduction() const { return {}; }
  /// The prompt of the next line: "Your answer: ".
  virtual std::string prompt() const = 0;
  virtual std::variant<NextLine, Answer> take(const std::string& typed) = 0;
  /// Shown when the participant feels a surface again instead, which discards the typed answer; or
  /// empty.
  virtual std::string note_on_discarding() const { return {}; }

 protected:
  AnswerDialogue() = default;
};

/// The dialogue for a question of a trial; both must outlive it.
std::unique_ptr<AnswerDialogue> dialogue_for(const Trial& trial, const TrialQuestion& question);

}  // namespace asperity
