// Parses the typed text on confirmation, and refuses one that is ambiguous or not above 0.

#include "app/session/respondents/sheets/number_sheet.h"

#include "app/session/respondents/form_answer.h"

namespace asperity {

SheetResult NumberSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::surface:
      if (!index_of(input.number, surfaces_)) return SheetUnchanged{};
      return WishToFeelAgain{};
    case ParticipantInput::Kind::next:
      return WishToFeelAgain{};
    case ParticipantInput::Kind::text:
      if (const std::optional<double> number = estimate_in(input.text)) {
        return only_answer(GivenNumber{*number});
      }
      if (is_unclear_estimate(input.text)) {
        return SheetRefused{
            {.what = ParticipantMessage::What::estimate_unclear, .code = trimmed(input.text)}};
      }
      break;
    case ParticipantInput::Kind::confirm:
    case ParticipantInput::Kind::device_button:  // a button cannot enter a number
      break;
    case ParticipantInput::Kind::option:
    case ParticipantInput::Kind::assign:
    case ParticipantInput::Kind::mark:
    case ParticipantInput::Kind::step:
    case ParticipantInput::Kind::select:
    case ParticipantInput::Kind::click:
    case ParticipantInput::Kind::released:
      return SheetUnchanged{};
  }
  return SheetRefused{{.what = ParticipantMessage::What::estimate_needed}};
}

}  // namespace asperity
