// The sheet of a choice: one option, the last one chosen.

#pragma once

#include <cstddef>
#include <optional>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// The device's first button steps through the options and chooses the one it points at. Where surfaces
/// may be felt again, that wish comes after the last option, and nothing is chosen then.
class ChoiceSheet final : public AnswerSheet {
 public:
  explicit ChoiceSheet(const Trial& trial);

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  SheetResult point();
  SheetResult confirm() const;

  std::size_t options_ = 0;
  std::size_t surfaces_ = 0;
  bool may_feel_again_ = false;
  std::optional<std::size_t> chosen_{};
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity
