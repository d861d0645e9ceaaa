#include "app/session/respondents/sheets/answer_sheet.h"

#include "app/session/respondents/sheets/assignment_sheet.h"
#include "app/session/respondents/sheets/choice_sheet.h"
#include "app/session/respondents/sheets/number_sheet.h"

namespace asperity {

namespace {

std::unique_ptr<AnswerSheet> sheet_of(const ChoiceForm&, const Trial& trial) {
  return std::make_unique<ChoiceSheet>(trial);
}
std::unique_ptr<AnswerSheet> sheet_of(const AssignmentForm&, const Trial& trial) {
  return std::make_unique<AssignmentSheet>(trial);
}
std::unique_ptr<AnswerSheet> sheet_of(const NumberForm&, const Trial& trial) {
  return std::make_unique<NumberSheet>(trial);
}

}  // namespace

std::unique_ptr<AnswerSheet> sheet_for(const Trial& trial) {
  return std::visit([&trial](const auto& form) { return sheet_of(form, trial); },
                    trial.question.form);
}

}  // namespace asperity
