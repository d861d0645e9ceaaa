// Stores the length as a number, and accepts only lengths of whole steps.

#include "protocols/answers/line_form.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/question.h"
#include "protocols/answers/stored_number.h"

namespace asperity {

std::vector<AnsweredItem> items_of(const Question& question, const LineForm& form,
                                   const DrawnLength& answer) {
  if (answer.step < 1 || answer.step > LineForm::kSteps) {
    throw std::out_of_range("the line of the question " + question.name + " has no step " +
                            std::to_string(answer.step) + "; it must be from 1 to " +
                            std::to_string(LineForm::kSteps));
  }
  const double length = form.length_of(answer.step);
  return {{.answer = number_text(length), .number = length}};
}

bool LineForm::can_be_stored_as(const std::string& text) const {
  const std::optional<double> length = stored_number(text);
  if (!length || *length <= 0.0 || *length > longest) return false;
  const int step = static_cast<int>(std::lround(*length / longest * kSteps));
  return number_text(length_of(step)) == text;
}

}  // namespace asperity
