// Stores the number as text and number, and accepts a stored one that is above 0 and equal in both.

#include "protocols/answers/number_form.h"

#include <optional>

#include "analysis/numbers/number_text.h"
#include "protocols/answers/stored_number.h"
#include "protocols/answers/trial_question.h"

namespace asperity {

std::vector<AnsweredItem> items_of(const TrialQuestion&, const NumberForm&,
                                   const GivenNumber& answer) {
  return {{.answer = number_text(answer.number), .number = answer.number}};
}

std::vector<std::string> problems_with(const TrialQuestion&, const NumberForm&,
                                       const AnsweredItem& stored) {
  const std::optional<double> number = stored_number(stored.answer);
  if (number && *number > 0.0 && number == stored.number) return {};
  return {
      "the response is not a number above 0, or differs from the number stored with it; restore "
      "the study from a copy"};
}

std::string label_of(const TrialQuestion&, const NumberForm&, const std::string& stored) {
  return stored;
}

}  // namespace asperity
