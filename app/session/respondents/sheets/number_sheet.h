// Checks a typed number: an answer is a number above 0.

#pragma once

#include <cstddef>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

class NumberSheet final : public AnswerSheet {
 public:
  explicit NumberSheet(const Trial& trial) : surfaces_(trial.presentations.size()) {}

  SheetResult take(const ParticipantInput& input) override;
  /// The typed text is shown only by the window until it is confirmed.
  void mark(ParticipantScene& scene) const override { scene.can_confirm = false; }

 private:
  std::size_t surfaces_ = 0;
};

}  // namespace asperity
