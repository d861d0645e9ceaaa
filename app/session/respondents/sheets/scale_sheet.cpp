// Keeps a step for each scale of the page and the current scale; a confirmation needs all marks.

#include "app/session/respondents/sheets/scale_sheet.h"

#include <algorithm>
#include <cmath>

namespace asperity {

ScaleSheet::ScaleSheet(const Trial& trial, std::span<const Question> page)
    : surfaces_(trial.presentations.size()), may_feel_again_(trial.arrangement.allows_revisits()) {
  for (const Question& question : page) {
    marks_.push_back(
        {.form = std::get<ScaleForm>(question.form), .is_optional = question.optional});
  }
}

SheetResult ScaleSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::mark: {
      const std::optional<std::size_t> scale = index_of(input.number, marks_.size());
      if (!scale) return SheetUnchanged{};
      const int steps = marks_[*scale].form.steps();
      return set(*scale, static_cast<int>(std::lround(input.position * steps)), input);
    }
    case ParticipantInput::Kind::option:
      return choose_point(input);
    case ParticipantInput::Kind::step:
      return move(input);
    case ParticipantInput::Kind::select:
      return select(input);
    case ParticipantInput::Kind::confirm:
      return confirm(input);
    case ParticipantInput::Kind::device_button:
      return confirms_by_button(input) ? confirm(input) : step_by_button(input);
    default:
      return wish_of(input, surfaces_);
  }
}

SheetResult ScaleSheet::set(std::size_t scale, int step, const ParticipantInput& input) {
  Mark& mark = marks_[scale];
  mark.step = std::clamp(step, 0, mark.form.steps());
  mark.counts = true;
  mark.changed_ns = input.time_ns;
  current_ = scale;
  points_at_feeling_again_ = false;
  return SheetChanged{};
}

SheetResult ScaleSheet::choose_point(const ParticipantInput& input) {
  const ScaleForm& form = marks_[current_].form;
  if (form.points == 0 || !index_of(input.number, static_cast<std::size_t>(form.points))) {
    return SheetUnchanged{};
  }
  const SheetResult result = set(current_, input.number - 1, input);
  current_ = next_without_answer().value_or(current_);
  return result;
}

SheetResult ScaleSheet::move(const ParticipantInput& input) {
  Mark& mark = marks_[current_];
  const int stride = mark.form.points > 0 ? 1 : mark.form.steps() / 100;
  if (mark.step) return set(current_, *mark.step + stride * input.number, input);
  mark.step = mark.form.steps() / 2;
  return SheetChanged{};
}

SheetResult ScaleSheet::select(const ParticipantInput& input) {
  const auto count = static_cast<int>(marks_.size());
  const int wanted = (static_cast<int>(current_) + input.number) % count;
  current_ = static_cast<std::size_t>((wanted + count) % count);
  points_at_feeling_again_ = false;
  return SheetChanged{};
}

SheetResult ScaleSheet::step_by_button(const ParticipantInput& input) {
  const Mark& mark = marks_[current_];
  const int steps = mark.form.steps();
  const int stride = mark.form.points > 0 ? 1 : steps / 10;
  const bool is_at_end = mark.step && *mark.step + stride > steps;
  if (is_at_end && !points_at_feeling_again_ && may_feel_again_ && current_ + 1 == marks_.size()) {
    points_at_feeling_again_ = true;
    return PointedAtFeelingAgain{};
  }
  const int step = !mark.step || is_at_end ? 0 : *mark.step + stride;
  set(current_, step, input);
  return SheetChanged{.cue = Cue::option, .number = step / stride + 1};
}

std::optional<std::size_t> ScaleSheet::next_without_answer() const noexcept {
  for (std::size_t i = 1; i <= marks_.size(); ++i) {
    const std::size_t scale = (current_ + i) % marks_.size();
    if (!marks_[scale].counts) return scale;
  }
  return {};
}

SheetResult ScaleSheet::confirm(const ParticipantInput& input) {
  if (points_at_feeling_again_) return WishToFeelAgain{};
  const bool is_left_empty = std::ranges::all_of(
      marks_, [](const Mark& mark) { return mark.is_optional && !mark.counts; });
  if (is_left_empty) return GivenAnswers{};
  if (const std::optional<std::size_t> open = next_without_answer()) {
    // A button has no other way to the next scale.
    const bool moves_on = input.kind == ParticipantInput::Kind::device_button &&
                          marks_[current_].counts && *open != current_;
    current_ = *open;
    if (moves_on) return SheetChanged{.cue = Cue::next, .needs_new_reading = true};
    return SheetRefused{
        {.what = ParticipantMessage::What::mark_first, .number = static_cast<int>(marks_.size())}};
  }
  GivenAnswers answers{};
  for (const Mark& mark : marks_) {
    answers.push_back({ScalePoint{mark.step.value()}, {}});
    if (marks_.size() > 1) answers.back().given_ns = mark.changed_ns;
  }
  return answers;
}

void ScaleSheet::mark(ParticipantScene& scene) const {
  scene.can_confirm = !next_without_answer() || points_at_feeling_again_;
  for (std::size_t i = 0; i < scene.scales.size() && i < marks_.size(); ++i) {
    scene.scales[i].step = marks_[i].step;
    scene.scales[i].counts = marks_[i].counts;
    scene.scales[i].current = i == current_;
  }
}

}  // namespace asperity
