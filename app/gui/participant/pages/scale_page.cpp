// Delegates layout, drawing, keys and pointer to the functions of scales, and adds the controls of a trial.

#include "app/gui/participant/pages/scale_page.h"

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "app/gui/participant/pages/scale_lines.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

class ScalePage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override { lay_out_scales(frame, frame.scene().scales); }

  void add_controls(PageFrame& frame) const override {
    add_question_controls(frame, *this, frame.scene().can_confirm);
  }

  void draw(ParticipantBrush& brush, const ParticipantItem& item) const override {
    if (item.kind == ParticipantItem::Kind::scale) {
      draw_scale(brush, item);
    } else {
      brush.draw(item);
    }
  }

  std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                                 const QString& typed) const override {
    if (auto action = key_of_scales(scene.scales, key, typed)) return action;
    return key_of_question(scene, key, typed);
  }

  std::optional<double> position_at(const ParticipantItem& item, QPointF at) const override {
    return position_on_scale(item, at);
  }
};

}  // namespace

const ParticipantPage& scale_page() {
  static const ScalePage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
