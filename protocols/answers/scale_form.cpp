// Converts between steps, values and stored texts, and finds the label of a step.

#include "protocols/answers/scale_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/stored_number.h"
#include "protocols/answers/trial_question.h"

namespace asperity {

namespace {

/// The step whose value is stored as this text.
std::optional<int> stored_step(const ScaleForm& form, const std::string& text) {
  const std::optional<double> number = stored_number(text);
  const std::optional<int> step = number ? form.step_near(*number) : std::nullopt;
  return step && number_text(form.value_at(*step)) == text ? step : std::nullopt;
}

}  // namespace

std::optional<int> ScaleForm::step_near(double value) const noexcept {
  if (!(value >= minimum && value <= maximum)) return {};
  return static_cast<int>(std::lround((value - minimum) / (maximum - minimum) * steps()));
}

std::optional<int> ScaleForm::step_of(double typed) const noexcept {
  constexpr double kSame = 1e-6;  // of the distance of two points
  const std::optional<int> step = step_near(typed);
  if (!step || points == 0) return step;
  const double apart = value_at(1) - value_at(0);
  return std::abs(typed - value_at(*step)) < kSame * apart ? step : std::nullopt;
}

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const ScaleForm& form,
                                   const ScalePoint& answer) {
  if (answer.step < 0 || answer.step > form.steps()) {
    throw std::out_of_range("the scale of the question " + question.name + " has no step " +
                            std::to_string(answer.step) + "; it must be from 0 to " +
                            std::to_string(form.steps()));
  }
  const double value = form.value_at(answer.step);
  return {{.answer = number_text(value), .number = value}};
}

std::vector<std::string> problems_with(const TrialQuestion&, const ScaleForm& form,
                                       const AnsweredItem& stored) {
  if (stored_step(form, stored.answer) && stored_number(stored.answer) == stored.number) return {};
  return {
      "the response is not a point of the scale, or differs from the number stored with it; "
      "restore the study from a copy"};
}

std::string label_of(const TrialQuestion&, const ScaleForm& form, const std::string& stored) {
  const std::optional<int> step = stored_step(form, stored);
  if (!step || !form.labels_every_point()) return stored;
  return stored + " (" + form.labels[static_cast<std::size_t>(*step)] + ")";
}

}  // namespace asperity
