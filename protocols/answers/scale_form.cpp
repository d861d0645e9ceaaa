// Converts between steps, values and stored texts, and finds the label of a step.

#include "protocols/answers/scale_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/question.h"
#include "protocols/answers/stored_number.h"

namespace asperity {

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

std::vector<AnsweredItem> items_of(const Question& question, const ScaleForm& form,
                                   const ScalePoint& answer) {
  if (answer.step < 0 || answer.step > form.steps()) {
    throw std::out_of_range("the scale of the question " + question.name + " has no step " +
                            std::to_string(answer.step) + "; it must be from 0 to " +
                            std::to_string(form.steps()));
  }
  const double value = form.value_at(answer.step);
  return {{.answer = number_text(value), .number = value}};
}

std::optional<int> ScaleForm::stored_step(const std::string& text) const {
  const std::optional<double> number = stored_number(text);
  const std::optional<int> step = number ? step_near(*number) : std::nullopt;
  return step && number_text(value_at(*step)) == text ? step : std::nullopt;
}

std::string ScaleForm::label_of(const std::string& stored) const {
  const std::optional<int> step = stored_step(stored);
  if (!step || !labels_every_point()) return stored;
  return stored + " (" + labels[static_cast<std::size_t>(*step)] + ")";
}

}  // namespace asperity
