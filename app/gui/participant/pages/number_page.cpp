// Combines the number pad with the controls of a question, and sends the typed number on confirmation.

#include "app/gui/participant/pages/number_page.h"

#include <variant>

#include "app/gui/participant/pages/number_pad.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

const NumberForm& form_of(const Scene& scene) { return std::get<NumberForm>(scene.form); }

NumberSign sign_of(const NumberForm& form) {
  const bool may_be_negative = !form.is_estimate && (!form.minimum || *form.minimum < 0.0);
  return may_be_negative ? NumberSign::minus : NumberSign::none;
}

/// What was typed cannot become a number: nothing is confirmed until it is corrected.
bool holds_no_number(const Scene& scene, const ParticipantDraft& draft) {
  return is_no_number(draft.number, sign_of(form_of(scene)));
}

QString range_text(const PageFrame& frame, const NumberForm& form) {
  if (form.is_estimate) return frame.said(phrase("ParticipantLayout", "Any number above 0"));
  const auto number = [](double value) {
    return QString::number(value, 'g', 12).replace('-', "−").toStdString();
  };
  if (form.minimum && form.maximum) {
    return frame.said(phrase("ParticipantLayout", "From %1 to %2")
                          .with(number(*form.minimum), number(*form.maximum)));
  }
  if (form.minimum)
    return frame.said(phrase("ParticipantLayout", "%1 or more").with(number(*form.minimum)));
  if (form.maximum)
    return frame.said(phrase("ParticipantLayout", "%1 or less").with(number(*form.maximum)));
  return {};
}

class NumberPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const NumberForm& form = form_of(frame.scene());
    const NumberTexts texts{
        .range = range_text(frame, form),
        .unit = frame.text_from(form.unit),
        .no_number = frame.said(
            form.is_estimate
                ? phrase("ParticipantLayout", "This is not a number above 0. Please correct it.")
                : phrase("ParticipantLayout", "This is not a number. Please correct it."))};
    lay_out_number(frame, texts, sign_of(form));
  }

  void add_controls(PageFrame& frame) const override {
    const ParticipantDraft& draft = frame.inputs().draft;
    add_question_controls(
        frame, *this, !is_empty(frame.scene(), draft) && !holds_no_number(frame.scene(), draft));
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    // A minus is written where there can be none: it is seen, and said to be wrong.
    const NumberSign sign = form_of(scene).is_estimate ? NumberSign::none : NumberSign::minus;
    if (auto action = key_of_number(key, typed, sign)) return action;
    return key_of_question(scene, key, typed);
  }

  Typing typing(const Scene&) const override { return Typing::number; }
  bool is_private() const override { return true; }

  bool is_empty(const Scene&, const ParticipantDraft& draft) const override {
    return draft.number.isEmpty();
  }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    switch (action.what) {
      case Action::What::write:
      case Action::What::erase:
        write_number(action, sign_of(form_of(scene)), draft.number);
        return {.shows_answer = true};
      case Action::What::confirm:
        if (holds_no_number(scene, draft)) return {};
        return {.told = ParticipantInput{.kind = ParticipantInput::Kind::text,
                                         .text = draft.number.toStdString()}};
      case Action::What::choose:
      case Action::What::surface:
      case Action::What::next:
      case Action::What::mark:
      case Action::What::step:
      case Action::What::select:
      case Action::What::turn_to:
        break;
    }
    return ParticipantPage::act(scene, action, draft);
  }
};

}  // namespace

const ParticipantPage& number_page() {
  static const NumberPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
