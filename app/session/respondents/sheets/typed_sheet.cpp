// Reads the typed text on confirmation, and refuses one that does not answer the question.

#include "app/session/respondents/sheets/typed_sheet.h"

#include <optional>
#include <utility>

#include "app/session/respondents/typed_answer.h"

namespace asperity {

SheetResult TypedSheet::take(const ParticipantInput& input) {
  switch (input.kind) {
    case ParticipantInput::Kind::text:
      return confirm(input.text);
    case ParticipantInput::Kind::confirm:
      return confirm({});
    case ParticipantInput::Kind::device_button:
      if (!confirms_by_button(input)) return SheetUnchanged{};
      return SheetRefused{{.what = ParticipantMessage::What::typed_needed}};
    default:
      return wish_of(input, surfaces_);
  }
}

SheetResult TypedSheet::confirm(const std::string& typed) const {
  TypedAnswer read = typed_answer(question_, typed);
  if (auto* const refusal = std::get_if<ParticipantMessage>(&read)) {
    return SheetRefused{std::move(*refusal)};
  }
  std::optional<Answer> answer = std::get<std::optional<Answer>>(std::move(read));
  return answer ? only_answer(*std::move(answer)) : GivenAnswers{};
}

}  // namespace asperity
