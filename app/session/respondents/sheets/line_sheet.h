// Stores a line while it is drawn.

#pragma once

#include <cstddef>
#include <optional>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// A line that begins at its left end (LineForm). There is no line at first, so that no length suggests an answer.
///
/// A pointer puts the right end where it presses. A key extends or shortens the line by a hundredth of the longest one;
/// the first one begins with the shortest line. The device's first button extends it by a twentieth, and after the longest
/// line begins again, or requests to feel a surface again where that is permitted; another button confirms.
class LineSheet final : public AnswerSheet {
 public:
  LineSheet(const Trial& trial, const Question& question)
      : surfaces_(trial.presentations.size()),
        is_optional_(question.optional),
        may_feel_again_(trial.arrangement.allows_revisits()) {}

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  SheetResult set(int step);
  SheetResult extend_by_button();
  SheetResult confirm() const;

  std::optional<int> step_{};
  std::size_t surfaces_ = 0;
  bool is_optional_ = false;
  bool may_feel_again_ = false;
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity
