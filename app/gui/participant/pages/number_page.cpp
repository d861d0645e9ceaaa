// Combines the number pad with the controls of a trial, and sends the typed number on confirmation.

#include "app/gui/participant/pages/number_page.h"

#include "app/gui/participant/pages/number_pad.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

class NumberPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const NumberTexts texts{
        .range = frame.said(phrase("ParticipantLayout", "Any number above 0")),
        .no_number = frame.said(
            phrase("ParticipantLayout", "This is not a number above 0. Please correct it."))};
    lay_out_number(frame, texts, NumberSign::none);
  }

  void add_controls(PageFrame& frame) const override {
    const QString& typed = frame.inputs().draft.number;
    add_question_controls(frame, !typed.isEmpty() && !is_no_number(typed, NumberSign::none));
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    if (auto action = key_of_number(key, typed, NumberSign::none)) return action;
    return key_of_question(scene, key, typed);
  }

  Typing typing(const Scene&) const override { return Typing::number; }
  bool is_private() const override { return true; }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    switch (action.what) {
      case Action::What::write:
      case Action::What::erase:
        write_number(action, NumberSign::none, draft.number);
        return {.shows_answer = true};
      case Action::What::confirm:
        // Nothing is confirmed until it is corrected.
        if (is_no_number(draft.number, NumberSign::none)) return {};
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
