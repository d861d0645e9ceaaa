// Reads the answer to a question at a terminal: one line, or one for each surface of an assignment.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "protocols/answers/question.h"
#include "protocols/design/trial.h"

namespace asperity {

/// Another line is needed: `complaint` states why the typed one is not accepted, or is empty.
struct NextLine {
  std::string complaint{};
};

/// Asks for one line after another until the answer is complete.
class AnswerDialogue {
 public:
  /// The question must outlive the dialogue.
  explicit AnswerDialogue(const Question& question) : question_(question) {}
  virtual ~AnswerDialogue() = default;
  AnswerDialogue(const AnswerDialogue&) = delete;
  AnswerDialogue& operator=(const AnswerDialogue&) = delete;

  /// Lines shown once below the question, each with its end of line: the meaning of what can be
  /// typed; or empty.
  std::string introduction() const;
  /// The prompt of the next line: "Your answer: ".
  virtual std::string prompt() const;
  /// The answer, nothing where the question is left empty, or the request for another line.
  virtual std::variant<NextLine, std::optional<Answer>> take(const std::string& typed);
  /// Shown when the participant feels a surface again instead, which discards the typed answer; or
  /// empty.
  virtual std::string note_on_discarding() const { return {}; }

 protected:
  const Question& question_;
};

/// Asks for the option of one surface after another.
class AssignmentDialogue final : public AnswerDialogue {
 public:
  AssignmentDialogue(const Question& question, std::span<const PlannedPresentation> surfaces)
      : AnswerDialogue(question), surfaces_(surfaces) {}

  std::string prompt() const override;
  std::variant<NextLine, std::optional<Answer>> take(const std::string& typed) override;
  std::string note_on_discarding() const override;

 private:
  std::span<const PlannedPresentation> surfaces_{};
  AssignedOptions assigned_{};
};

/// The dialogue for a question; question and surfaces must outlive it. `surfaces`: those of the trial.
std::unique_ptr<AnswerDialogue> dialogue_for(const Question& question,
                                             std::span<const PlannedPresentation> surfaces = {});

}  // namespace asperity
