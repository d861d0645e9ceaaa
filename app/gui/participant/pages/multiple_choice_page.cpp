// Lists the options, marks the chosen ones in the draft, and sends their numbers on confirmation.

#include "app/gui/participant/pages/multiple_choice_page.h"

#include <algorithm>

#include <QtCore/QStringList>

#include "app/gui/participant/pages/option_list.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

/// Chooses an option, or no longer chooses it.
void toggle(int option, std::vector<int>& chosen) {
  const auto place = std::lower_bound(chosen.begin(), chosen.end(), option);
  if (place != chosen.end() && *place == option) {
    chosen.erase(place);
  } else {
    chosen.insert(place, option);
  }
}

/// As `typed_answer` reads them.
std::string numbers_of(const std::vector<int>& options) {
  QStringList numbers{};
  for (const int option : options) numbers.append(QString::number(option));
  return numbers.join(' ').toStdString();
}

class MultipleChoicePage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const QString note = frame.said(phrase("ParticipantLayout", "Choose all that apply."));
    lay_out_options(frame, {.question = frame.scene_text() + '\n' + note,
                            .options = options_in_words(frame.scene()),
                            .chosen = frame.inputs().draft.options});
  }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, !is_empty(frame.scene(), frame.inputs().draft));
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    return key_of_question(scene, key, typed);
  }
  bool takes_two_digits() const override { return false; }

  bool is_empty(const Scene&, const ParticipantDraft& draft) const override {
    return draft.options.empty();
  }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    if (action.what == Action::What::choose) {
      toggle(action.number, draft.options);
      return {};  // the page of the picture with this option stays in view
    }
    if (action.what == Action::What::confirm) {
      return {.told = ParticipantInput{.kind = ParticipantInput::Kind::text,
                                       .text = numbers_of(draft.options)}};
    }
    return ParticipantPage::act(scene, action, draft);
  }
};

}  // namespace

const ParticipantPage& multiple_choice_page() {
  static const MultipleChoicePage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
