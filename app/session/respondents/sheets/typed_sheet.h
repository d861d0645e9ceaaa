// Checks an answer that is typed: a number or a text.

#pragma once

#include <cstddef>
#include <string>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// A confirmation by a button of the device is refused: what is typed is only in the window until then, and would be lost.
class TypedSheet final : public AnswerSheet {
 public:
  TypedSheet(const Trial& trial, const Question& question)
      : question_(question), surfaces_(trial.presentations.size()) {}

  SheetResult take(const ParticipantInput& input) override;
  /// The typed text is shown only by the window until it is confirmed.
  void mark(ParticipantScene& scene) const override { scene.can_confirm = false; }

 private:
  SheetResult confirm(const std::string& typed) const;

  Question question_{};
  std::size_t surfaces_ = 0;
};

}  // namespace asperity
