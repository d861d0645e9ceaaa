// Selects the sheet by the form of the answer.

#include "app/session/respondents/sheets/answer_sheet.h"

#include "app/session/respondents/sheets/assignment_sheet.h"
#include "app/session/respondents/sheets/choice_sheet.h"
#include "app/session/respondents/sheets/line_sheet.h"
#include "app/session/respondents/sheets/multiple_choice_sheet.h"
#include "app/session/respondents/sheets/scale_sheet.h"
#include "app/session/respondents/sheets/typed_sheet.h"

namespace asperity {

namespace {

std::unique_ptr<AnswerSheet> sheet_of(const ChoiceForm&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<ChoiceSheet>(trial, page.front());
}
std::unique_ptr<AnswerSheet> sheet_of(const AssignmentForm&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<AssignmentSheet>(trial, page.front());
}
std::unique_ptr<AnswerSheet> sheet_of(const LineForm&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<LineSheet>(trial, page.front());
}
std::unique_ptr<AnswerSheet> sheet_of(const ScaleForm&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<ScaleSheet>(trial, page);
}
std::unique_ptr<AnswerSheet> sheet_of(const MultipleChoiceForm&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<MultipleChoiceSheet>(trial, page.front());
}
/// Of the forms whose answers are typed.
template <class Form>
std::unique_ptr<AnswerSheet> sheet_of(const Form&, const Trial& trial,
                                      std::span<const Question> page) {
  return std::make_unique<TypedSheet>(trial, page.front());
}

}  // namespace

SheetResult AnswerSheet::wish_of(const ParticipantInput& input, std::size_t surfaces) {
  const bool names_surface =
      input.kind == ParticipantInput::Kind::surface && index_of(input.number, surfaces);
  if (names_surface || input.kind == ParticipantInput::Kind::next) return WishToFeelAgain{};
  return SheetUnchanged{};
}

std::unique_ptr<AnswerSheet> sheet_for(const Trial& trial, std::span<const Question> page) {
  return std::visit([&](const auto& form) { return sheet_of(form, trial, page); },
                    page.front().form);
}

}  // namespace asperity
