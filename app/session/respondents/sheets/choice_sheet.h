// Stores a choice while it is composed: the option chosen last.

#pragma once

#include <cstddef>
#include <optional>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// The chosen option of an optional question is withdrawn when it is chosen once more.
///
/// The device's first button steps through the options and chooses the selected one. Where surfaces
/// may be felt again, that request follows the last option, and no option is chosen then.
class ChoiceSheet final : public AnswerSheet {
 public:
  ChoiceSheet(const Trial& trial, const Question& question);

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  std::optional<int> chosen_surface() const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  SheetResult point();
  SheetResult confirm() const;

  std::size_t options_ = 0;
  std::size_t surfaces_ = 0;
  bool is_optional_ = false;
  bool may_feel_again_ = false;
  bool options_are_surfaces_ = false;
  std::optional<std::size_t> chosen_{};
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity
