// Sets the length by pointer, or changes it in strides by key and button.

#include "app/session/respondents/sheets/line_sheet.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kStride = LineForm::kSteps / 100;       // of a key
constexpr int kButtonStride = LineForm::kSteps / 20;  // of a button of the device

}  // namespace

SheetResult LineSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::mark:
      if (!index_of(input.number, 1)) return SheetUnchanged{};
      return set(static_cast<int>(std::lround(input.position * LineForm::kSteps)));
    case ParticipantInput::Kind::step:
      return set(step_.value_or(0) + kStride * input.number);
    case ParticipantInput::Kind::confirm:
      return confirm();
    case ParticipantInput::Kind::device_button:
      return confirms_by_button(input) ? confirm() : extend_by_button();
    default:
      return wish_of(input, surfaces_);
  }
}

SheetResult LineSheet::set(int step) {
  step_ = std::clamp(step, 1, LineForm::kSteps);
  points_at_feeling_again_ = false;
  return SheetChanged{};
}

SheetResult LineSheet::extend_by_button() {
  const bool is_longest = step_.value_or(0) + kButtonStride > LineForm::kSteps;
  if (is_longest && !points_at_feeling_again_ && may_feel_again_) {
    points_at_feeling_again_ = true;
    return PointedAtFeelingAgain{};
  }
  return set(is_longest ? kButtonStride : step_.value_or(0) + kButtonStride);
}

SheetResult LineSheet::confirm() const {
  if (points_at_feeling_again_) return WishToFeelAgain{};
  if (!step_ && is_optional_) return GivenAnswers{};
  if (!step_) return SheetRefused{{.what = ParticipantMessage::What::line_needed}};
  return only_answer(DrawnLength{*step_});
}

void LineSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = step_.has_value() || points_at_feeling_again_;
  scene.line_step = step_;
}

}  // namespace asperity
