// Accepts options by number and steps through them by button; a confirmation needs a choice.

#include "app/session/respondents/sheets/choice_sheet.h"

namespace asperity {

ChoiceSheet::ChoiceSheet(const Trial& trial, const Question& question)
    : options_(question.options.size()),
      surfaces_(trial.presentations.size()),
      is_optional_(question.optional),
      may_feel_again_(trial.arrangement.allows_revisits()),
      options_are_surfaces_(!question.options.empty() && !question.options.front().picture &&
                            question.options.front().text.empty()) {}

std::optional<int> ChoiceSheet::chosen_surface() const {
  if (!options_are_surfaces_ || !chosen_ || *chosen_ >= surfaces_) return {};
  return static_cast<int>(*chosen_) + 1;
}

SheetResult ChoiceSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::option: {
      const std::optional<std::size_t> option = index_of(input.number, options_);
      if (!option) return SheetUnchanged{};
      chosen_ = is_optional_ && chosen_ == option ? std::nullopt : option;
      points_at_feeling_again_ = false;
      return SheetChanged{};
    }
    case ParticipantInput::Kind::confirm:
      return confirm();
    case ParticipantInput::Kind::device_button:
      return confirms_by_button(input) ? confirm() : point();
    default:
      return wish_of(input, surfaces_);
  }
}

SheetResult ChoiceSheet::point() {
  if (options_ == 0) return SheetUnchanged{};
  points_at_feeling_again_ = may_feel_again_ && chosen_ == options_ - 1;
  if (points_at_feeling_again_) {
    chosen_.reset();
    return PointedAtFeelingAgain{};
  }
  chosen_ = chosen_ ? (*chosen_ + 1) % options_ : 0;
  return SheetChanged{.cue = Cue::option, .number = static_cast<int>(*chosen_) + 1};
}

SheetResult ChoiceSheet::confirm() const {
  if (points_at_feeling_again_) return WishToFeelAgain{};
  if (chosen_) return only_answer(ChosenOption{*chosen_});
  if (is_optional_) return GivenAnswers{};
  return SheetRefused{{.what = ParticipantMessage::What::choose_first}};
}

void ChoiceSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = chosen_ || points_at_feeling_again_;
  for (std::size_t option = 0; option < scene.choices.size(); ++option) {
    scene.choices[option].chosen = chosen_ == option;
    scene.choices[option].assigned_to.clear();
  }
}

}  // namespace asperity
