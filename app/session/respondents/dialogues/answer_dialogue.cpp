#include "app/session/respondents/dialogues/answer_dialogue.h"

#include "app/session/respondents/dialogues/number_dialogue.h"
#include "app/session/respondents/dialogues/option_dialogues.h"

namespace asperity {

namespace {

std::unique_ptr<AnswerDialogue> dialogue_of(const ChoiceForm&, const Trial& trial) {
  return std::make_unique<ChoiceDialogue>(trial);
}
std::unique_ptr<AnswerDialogue> dialogue_of(const AssignmentForm&, const Trial& trial) {
  return std::make_unique<AssignmentDialogue>(trial);
}
std::unique_ptr<AnswerDialogue> dialogue_of(const NumberForm&, const Trial&) {
  return std::make_unique<NumberDialogue>();
}

}  // namespace

std::unique_ptr<AnswerDialogue> dialogue_for(const Trial& trial) {
  return std::visit([&trial](const auto& form) { return dialogue_of(form, trial); },
                    trial.question.form);
}

}  // namespace asperity
