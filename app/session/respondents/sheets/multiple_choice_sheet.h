// Stores the options that are chosen of several.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/session/respondents/sheets/answer_sheet.h"

namespace asperity {

/// An option that is chosen once more is no longer chosen.
///
/// The device's first button points at one option after another, with the tone of each. A confirmation by button chooses the
/// option that it points at, or no longer chooses it, and a further one confirms the answer. Where surfaces may be felt again,
/// that request follows the last option.
class MultipleChoiceSheet final : public AnswerSheet {
 public:
  MultipleChoiceSheet(const Trial& trial, const Question& question);

  SheetResult take(const ParticipantInput& input) override;
  void mark(ParticipantScene& scene) const override;
  void forget_feeling_again() override { points_at_feeling_again_ = false; }

 private:
  void toggle(std::size_t option);
  SheetResult point();
  SheetResult confirm_by_button();
  SheetResult confirm() const;

  std::vector<bool> chosen_{};  ///< by option
  std::size_t surfaces_ = 0;
  bool is_optional_ = false;
  bool may_feel_again_ = false;
  std::optional<std::size_t> pointed_{};  ///< the last option that the button pointed at
  bool is_pointing_ = false;              ///< a confirmation by button is about that option
  bool points_at_feeling_again_ = false;
};

}  // namespace asperity
