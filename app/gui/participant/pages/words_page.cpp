// Centres the text, with the remaining time of a rest and a control that continues.

#include "app/gui/participant/pages/words_page.h"

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/trial_controls.h"

namespace asperity {

namespace {

using Action = ParticipantAction;
using Scene = ParticipantScene;

QString minutes_and_seconds(int seconds) {
  return QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
}

class WordsPage final : public ParticipantPage {
 public:
  void lay_out(PageFrame& frame) const override {
    const Scene& scene = frame.scene();
    const int rest_left_s = frame.inputs().rest_left_s;
    QString below{};
    if (scene.kind == Scene::Kind::rest && rest_left_s > 0) {
      below = frame.said(phrase("ParticipantLayout", "You can continue in %1")
                             .with(minutes_and_seconds(rest_left_s).toStdString()));
    } else if (scene.kind == Scene::Kind::rest) {
      below = frame.said(phrase("ParticipantLayout", "You can continue when you are ready."));
    }
    QString text = frame.scene_text();
    if (scene.kind == Scene::Kind::paused && scene.text.empty()) {
      text = frame.said(
          phrase("ParticipantLayout", "One moment, please. You may release the handle."));
    } else if (scene.kind == Scene::Kind::ended && scene.text.empty()) {
      text = frame.said(phrase("ParticipantLayout", "Thank you. You may release the handle."));
    }
    frame.words(text, below);
  }

  void add_controls(PageFrame& frame) const override {
    const Scene& scene = frame.scene();
    if (!can_confirm(scene)) return;
    const bool is_mask = scene.kind == Scene::Kind::mask_on || scene.kind == Scene::Kind::mask_off;
    const bool is_ready = scene.kind != Scene::Kind::rest || frame.inputs().rest_left_s <= 0;
    frame.add_control(is_mask ? frame.said(phrase("ParticipantLayout", "Done"))
                              : frame.said(phrase("ParticipantLayout", "Continue")),
                      frame.return_key(), {.what = Action::What::confirm}, is_ready);
  }

  std::optional<Action> action_of_key(const Scene& scene, int key, const QString&) const override {
    if (is_return(key) && can_confirm(scene)) return Action{.what = Action::What::confirm};
    return {};
  }

 private:
  /// The others end by themselves.
  static bool can_confirm(const Scene& scene) {
    return scene.kind == Scene::Kind::text || scene.kind == Scene::Kind::rest ||
           scene.kind == Scene::Kind::mask_on || scene.kind == Scene::Kind::mask_off;
  }
};

}  // namespace

const ParticipantPage& words_page() {
  static const WordsPage kScenePage{};
  return kScenePage;
}

}  // namespace asperity
