// The sheet of a number: what was typed is an answer when it is a number above 0.

#pragma once

#include <cstddef>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

class NumberSheet final : public AnswerSheet {
 public:
  explicit NumberSheet(const Trial& trial) : surfaces_(trial.presentations.size()) {}

  SheetResult take(const ParticipantInput& input) override;
  /// What is typed stands in the window alone until it is confirmed.
  void mark(ParticipantScene& scene) const override { scene.can_confirm = false; }

 private:
  std::size_t surfaces_ = 0;
};

}  // namespace asperity
