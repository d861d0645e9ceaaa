// Chooses options by number and by button; a confirmation needs one of them.

#include "app/session/respondents/sheets/multiple_choice_sheet.h"

#include <utility>

namespace asperity {

MultipleChoiceSheet::MultipleChoiceSheet(const Trial& trial, const Question& question)
    : chosen_(question.options.size()),
      surfaces_(trial.presentations.size()),
      is_optional_(question.optional),
      may_feel_again_(trial.arrangement.allows_revisits()) {}

SheetResult MultipleChoiceSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::option: {
      const std::optional<std::size_t> option = index_of(input.number, chosen_.size());
      if (!option) return SheetUnchanged{};
      toggle(*option);
      return SheetChanged{};
    }
    case ParticipantInput::Kind::confirm:
      return confirm();
    case ParticipantInput::Kind::device_button:
      return confirms_by_button(input) ? confirm_by_button() : point();
    default:
      return wish_of(input, surfaces_);
  }
}

void MultipleChoiceSheet::toggle(std::size_t option) {
  chosen_[option] = !chosen_[option];
  is_pointing_ = false;
  points_at_feeling_again_ = false;
}

SheetResult MultipleChoiceSheet::point() {
  if (chosen_.empty()) return SheetUnchanged{};
  points_at_feeling_again_ =
      may_feel_again_ && !points_at_feeling_again_ && pointed_ == chosen_.size() - 1;
  is_pointing_ = !points_at_feeling_again_;
  if (points_at_feeling_again_) return PointedAtFeelingAgain{};
  pointed_ = pointed_ ? (*pointed_ + 1) % chosen_.size() : 0;
  return SheetChanged{.cue = Cue::option, .number = static_cast<int>(*pointed_) + 1};
}

SheetResult MultipleChoiceSheet::confirm_by_button() {
  if (!is_pointing_) return confirm();
  toggle(*pointed_);
  // The tone of the question: the next confirmation applies to the whole answer.
  return SheetChanged{.cue = Cue::question, .needs_new_reading = true};
}

SheetResult MultipleChoiceSheet::confirm() const {
  if (points_at_feeling_again_) return WishToFeelAgain{};
  ChosenOptions chosen{};
  for (std::size_t option = 0; option < chosen_.size(); ++option) {
    if (chosen_[option]) chosen.options.push_back(option);
  }
  if (!chosen.options.empty()) return only_answer(std::move(chosen));
  if (is_optional_) return GivenAnswers{};
  return SheetRefused{{.what = ParticipantMessage::What::options_needed}};
}

void MultipleChoiceSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = points_at_feeling_again_;
  for (std::size_t option = 0; option < scene.choices.size(); ++option) {
    scene.choices[option].chosen = chosen_[option];
    scene.choices[option].pointed_at = is_pointing_ && pointed_ == option;
    scene.can_confirm = scene.can_confirm || chosen_[option];
  }
}

}  // namespace asperity
