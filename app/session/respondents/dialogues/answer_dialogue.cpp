// Selects the dialogue by the form of the answer.

#include "app/session/respondents/dialogues/answer_dialogue.h"

#include "app/session/respondents/dialogues/line_dialogue.h"
#include "app/session/respondents/dialogues/number_dialogue.h"
#include "app/session/respondents/dialogues/option_dialogues.h"
#include "app/session/respondents/dialogues/scale_dialogue.h"

namespace asperity {

namespace {

std::unique_ptr<AnswerDialogue> dialogue_of(const ChoiceForm&, const Trial&,
                                            const TrialQuestion& question) {
  return std::make_unique<ChoiceDialogue>(question);
}
std::unique_ptr<AnswerDialogue> dialogue_of(const AssignmentForm&, const Trial& trial,
                                            const TrialQuestion& question) {
  return std::make_unique<AssignmentDialogue>(trial, question);
}
std::unique_ptr<AnswerDialogue> dialogue_of(const NumberForm&, const Trial&, const TrialQuestion&) {
  return std::make_unique<NumberDialogue>();
}
std::unique_ptr<AnswerDialogue> dialogue_of(const LineForm&, const Trial&, const TrialQuestion&) {
  return std::make_unique<LineDialogue>();
}
std::unique_ptr<AnswerDialogue> dialogue_of(const ScaleForm& form, const Trial&,
                                            const TrialQuestion&) {
  return std::make_unique<ScaleDialogue>(form);
}

}  // namespace

std::unique_ptr<AnswerDialogue> dialogue_for(const Trial& trial, const TrialQuestion& question) {
  return std::visit([&](const auto& form) { return dialogue_of(form, trial, question); },
                    question.form);
}

}  // namespace asperity
