// Stores the number as text and number.

#include "protocols/answers/number_form.h"

#include "analysis/numbers/number_text.h"
#include "protocols/answers/question.h"
#include "protocols/answers/stored_number.h"

namespace asperity {

bool NumberForm::can_be_stored_as(const std::string& text) const {
  const std::optional<double> number = stored_number(text);
  return number && accepts(*number);
}

std::vector<AnsweredItem> items_of(const Question&, const NumberForm&, const GivenNumber& answer) {
  return {{.answer = number_text(answer.number), .number = answer.number}};
}

}  // namespace asperity
