// Stores the length as a number, and accepts only lengths of whole steps.

#include "protocols/answers/line_form.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/stored_number.h"
#include "protocols/answers/trial_question.h"

namespace asperity {

std::vector<AnsweredItem> items_of(const TrialQuestion& question, const LineForm& form,
                                   const DrawnLength& answer) {
  if (answer.step < 1 || answer.step > LineForm::kSteps) {
    throw std::out_of_range("the line of the question " + question.name + " has no step " +
                            std::to_string(answer.step) + "; it must be from 1 to " +
                            std::to_string(LineForm::kSteps));
  }
  const double length = form.length_of(answer.step);
  return {{.answer = number_text(length), .number = length}};
}

std::vector<std::string> problems_with(const TrialQuestion&, const LineForm& form,
                                       const AnsweredItem& stored) {
  const std::optional<double> length = stored_number(stored.answer);
  if (length && *length > 0.0 && *length <= form.longest && length == stored.number) {
    const int step = static_cast<int>(std::lround(*length / form.longest * LineForm::kSteps));
    if (number_text(form.length_of(step)) == stored.answer) return {};
  }
  return {
      "the response is not the length of a line that could be drawn, or differs from the number "
      "stored with it; restore the study from a copy"};
}

std::string label_of(const TrialQuestion&, const LineForm&, const std::string& stored) {
  return stored;
}

}  // namespace asperity
