#include "protocols/answers/scale_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "analysis/number_text.h"
#include "protocols/answers/stored_number.h"
#include "protocols/answers/trial_question.h"

namespace asperity {

namespace {

/// The value of a step; the right end has `maximum`, which rounding could exceed.
double value_of(const ScaleForm& form, int step) {
  return step == form.steps() ? form.maximum : form.value_at(step);
}

/// The step whose value is stored as this text.
std::optional<int> stored_step(const ScaleForm& form, const std::string& text) {
  const std::optional<double> number = stored_number(text);
  if (!number || *number < form.minimum || *number > form.maximum) return {};
  const double steps = (*number - form.minimum) / (form.maximum - form.minimum) * form.steps();
  const int step = static_cast<int>(std::lround(steps));
  return number_text(value_of(form, step)) == text ? std::optional(step) : std::nullopt;
}

}  // namespace

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const ScaleForm& form,
                                   const ScalePoint& answer) {
  if (answer.step < 0 || answer.step > form.steps()) {
    throw std::out_of_range("the scale of the question " + question.name + " has no step " +
                            std::to_string(answer.step));
  }
  const double value = value_of(form, answer.step);
  return {{.answer = number_text(value), .number = value}};
}

std::vector<std::string> problems_with(const TrialQuestion&, const ScaleForm& form,
                                       const AnsweredItem& stored) {
  if (stored_step(form, stored.answer) && stored_number(stored.answer) == stored.number) return {};
  return {"the response is not a point of the scale, or differs from the number stored with it"};
}

std::string label_of(const TrialQuestion&, const ScaleForm& form, const std::string& stored) {
  const std::optional<int> step = stored_step(form, stored);
  if (!step || !form.labels_every_point()) return stored;
  return stored + " (" + form.labels[static_cast<std::size_t>(*step)] + ")";
}

}  // namespace asperity
