// Makes room for the text field, and sends what it contains on confirmation.

#include "app/gui/participant/pages/text_page.h"

#include <algorithm>

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

class TextPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const bool answers = frame.question_over(
        frame.scene_text(), [&frame](double height) { return height >= frame.em(104.0); });
    frame.need_pages(frame.question_pages() + 1);
    if (!answers) return;
    QRectF field = frame.column();
    field.setHeight(std::min(field.height(), frame.em(280.0)));
    frame.add({.kind = ParticipantItem::Kind::field,
               .rect = field,
               .text = frame.inputs().draft.text,
               .size_px = frame.letters(frame.kText)});
  }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, !is_empty(frame.scene(), frame.inputs().draft));
  }

  // All other keys write the text.
  std::optional<Action> action_of_key(const Scene&, int key, const QString&) const override {
    if (is_return(key)) return Action{.what = Action::What::confirm};
    return {};
  }

  Typing typing(const Scene&) const override { return Typing::text; }
  bool is_private() const override { return true; }

  bool is_empty(const Scene&, const ParticipantDraft& draft) const override {
    return draft.text.trimmed().isEmpty();
  }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    if (action.what != Action::What::confirm) return ParticipantPage::act(scene, action, draft);
    return {.told = ParticipantInput{.kind = ParticipantInput::Kind::text,
                                     .text = draft.text.trimmed().toStdString()}};
  }
};

}  // namespace

const ParticipantPage& text_page() {
  static const TextPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
