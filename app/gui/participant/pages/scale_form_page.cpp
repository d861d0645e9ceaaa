// Shows the draft as a scale of one row, whose mark is moved as in a trial until it is confirmed.

#include "app/gui/participant/pages/scale_form_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/number_text.h"
#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/scale_lines.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

/// The scale with the mark of the draft, which the session does not know before it is confirmed.
std::array<Scene::Scale, 1> drafted(const Scene& scene, const ParticipantDraft& draft) {
  return {Scene::Scale{.form = scene.question->scale,
                       .step = draft.step,
                       .counts = draft.step_counts,
                       .current = true}};
}

/// The effect of an arrow, as in a trial (ScaleSheet): the first one shows a mark in the middle that is not an answer, and
/// later ones move it, by a point or by a hundredth of the line.
void move_mark(const ScaleForm& scale, int strides, ParticipantDraft& draft) {
  if (!draft.step) {
    draft.step = scale.steps() / 2;
    return;
  }
  const int stride = scale.points > 0 ? 1 : scale.steps() / 100;
  draft.step = std::clamp(*draft.step + strides * stride, 0, scale.steps());
  draft.step_counts = true;
}

class ScaleFormPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    lay_out_scales(frame, drafted(frame.scene(), frame.inputs().draft));
  }

  void add_controls(PageFrame& frame) const override {
    const bool is_marked = frame.inputs().draft.step_counts;
    const bool skips = frame.scene().question->optional && !is_marked;
    frame.add_control(frame.said(skips ? phrase("ParticipantLayout", "Skip")
                                       : phrase("ParticipantLayout", "Confirm")),
                      frame.return_key(), {.what = Action::What::confirm}, skips || is_marked);
  }

  void draw(ParticipantBrush& brush, const ParticipantItem& item) const override {
    if (item.kind == ParticipantItem::Kind::scale) {
      draw_scale(brush, item);
    } else {
      brush.draw(item);
    }
  }

  std::optional<Action> action_of_key(const Scene& scene, int key,
                                      const QString& typed) const override {
    if (is_return(key)) return Action{.what = Action::What::confirm};
    return key_of_scales(drafted(scene, {}), key, typed);
  }

  bool is_private() const override { return true; }

  bool would_leave_out(const Scene& scene, const ParticipantDraft& draft) const override {
    return scene.question->optional && !draft.step_counts;
  }

  ActionEffect act(const Scene& scene, const Action& action,
                   ParticipantDraft& draft) const override {
    const ScaleForm& scale = scene.question->scale;
    switch (action.what) {
      case Action::What::mark:
        draft.step = static_cast<int>(std::lround(action.position * scale.steps()));
        draft.step_counts = true;
        return {.shows_answer = true};
      case Action::What::choose:
        draft.step = action.number - 1;
        draft.step_counts = true;
        return {.shows_answer = true};
      case Action::What::step:
        move_mark(scale, action.number, draft);
        return {.shows_answer = true};
      case Action::What::confirm:
        return {.told = ParticipantInput{.kind = ParticipantInput::Kind::text,
                                         .text = draft.step_counts
                                                     ? number_text(scale.value_at(*draft.step))
                                                     : std::string()}};
      case Action::What::surface:
      case Action::What::next:
      case Action::What::select:
      case Action::What::write:
      case Action::What::erase:
      case Action::What::turn_to:
        break;
    }
    return {};
  }

  std::optional<double> position_at(const ParticipantItem& item, QPointF at) const override {
    return position_on_scale(item, at);
  }
};

}  // namespace

const ParticipantPage& scale_form_page() {
  static const ScaleFormPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
