// Moves a current surface from one without an option to the next; an option can be given only once.

#include "app/session/respondents/sheets/assignment_sheet.h"

namespace asperity {

AssignmentSheet::AssignmentSheet(const Trial& trial, const Question& question)
    : options_(question.options.size()),
      may_feel_again_(trial.arrangement.allows_revisits()),
      given_(trial.presentations.size()) {
  for (const PlannedPresentation& planned : trial.presentations) codes_.push_back(planned.code);
}

SheetResult AssignmentSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::option: {
      const std::optional<std::size_t> option = index_of(input.number, options_);
      if (!option) return SheetUnchanged{};
      assign(*option, current_);
      return SheetChanged{};
    }
    case ParticipantInput::Kind::assign:
      return take_assignment(input);
    case ParticipantInput::Kind::surface: {
      const std::optional<std::size_t> surface = index_of(input.number, given_.size());
      if (!surface) return SheetUnchanged{};
      if (may_feel_again_) return WishToFeelAgain{};
      current_ = *surface;
      pointed_.reset();
      points_at_feeling_again_ = false;
      return SheetChanged{};
    }
    case ParticipantInput::Kind::confirm:
      return confirm();
    case ParticipantInput::Kind::device_button:
      return confirms_by_button(input) ? confirm() : point();
    default:
      return wish_of(input, given_.size());
  }
}

SheetResult AssignmentSheet::take_assignment(const ParticipantInput& input) {
  const std::optional<std::size_t> option = index_of(input.number, options_);
  if (!option) return SheetUnchanged{};
  if (const std::optional<std::size_t> surface = index_of(input.surface, given_.size())) {
    assign(*option, *surface);
    return SheetChanged{};
  }
  if (input.surface != 0) return SheetUnchanged{};
  take_back(*option);
  return SheetChanged{};
}

void AssignmentSheet::assign(std::size_t option, std::size_t surface) {
  take_back(option);
  given_.at(surface) = option;
  pointed_.reset();
  current_ = surface;
  advance();
}

void AssignmentSheet::take_back(std::size_t option) {
  for (std::optional<std::size_t>& given : given_) {
    if (given == option) given.reset();
  }
  points_at_feeling_again_ = false;
}

void AssignmentSheet::advance() {
  const std::size_t next = (current_ + 1) % given_.size();
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const std::size_t surface = (next + i) % given_.size();
    if (given_[surface]) continue;
    current_ = surface;
    return;
  }
  current_ = next;
}

SheetResult AssignmentSheet::point() {
  if (options_ == 0) return SheetUnchanged{};
  points_at_feeling_again_ = may_feel_again_ && pointed_ == options_ - 1;
  if (points_at_feeling_again_) {
    pointed_.reset();
    return PointedAtFeelingAgain{};
  }
  pointed_ = pointed_ ? (*pointed_ + 1) % options_ : 0;
  return SheetChanged{.cue = Cue::option, .number = static_cast<int>(*pointed_) + 1};
}

SheetResult AssignmentSheet::confirm() {
  if (points_at_feeling_again_) return WishToFeelAgain{};
  if (pointed_) {
    assign(*pointed_, current_);
    // The cue names what the next confirmation applies to: the current surface, or the whole
    // assignment.
    if (!first_without_option())
      return SheetChanged{.cue = Cue::question, .needs_new_reading = true};
    return SheetChanged{
        .cue = Cue::surface, .number = static_cast<int>(current_) + 1, .needs_new_reading = true};
  }
  if (const std::optional<std::size_t> missing = first_without_option()) {
    return SheetRefused{
        {.what = ParticipantMessage::What::assign_first, .code = codes_.at(*missing)}};
  }
  AssignedOptions assigned{};
  for (const std::optional<std::size_t>& given : given_) assigned.options.push_back(given.value());
  return only_answer(std::move(assigned));
}

std::optional<std::size_t> AssignmentSheet::first_without_option() const noexcept {
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (!given_[i]) return i;
  }
  return {};
}

void AssignmentSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = !first_without_option() || points_at_feeling_again_;
  scene.assigning = current_;
  for (std::size_t option = 0; option < scene.choices.size(); ++option) {
    ParticipantScene::Choice& choice = scene.choices[option];
    choice.chosen = pointed_ == option;
    choice.assigned_to.clear();
    for (std::size_t surface = 0; surface < given_.size(); ++surface) {
      if (given_[surface] == option) choice.assigned_to = scene.surfaces.at(surface).code;
    }
  }
}

}  // namespace asperity
