// Accepts a number, and asks again for one that is not above 0 or has an ambiguous separator.

#include "app/session/respondents/dialogues/number_dialogue.h"

#include "app/session/respondents/form_answer.h"
#include "app/session/respondents/participant_scene.h"

namespace asperity {

std::variant<NextLine, Answer> NumberDialogue::take(const std::string& typed) {
  if (const std::optional<double> number = estimate_in(typed)) return Answer(GivenNumber{*number});
  return NextLine{
      text_of(is_unclear_estimate(typed)
                  ? ParticipantMessage{.what = ParticipantMessage::What::estimate_unclear,
                                       .code = trimmed(typed)}
                  : ParticipantMessage{.what = ParticipantMessage::What::estimate_needed})};
}

}  // namespace asperity
