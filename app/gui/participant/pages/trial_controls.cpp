// Declares the actions of Return and Space in a trial, and adds the controls that show them.

#include "app/gui/participant/pages/trial_controls.h"

#include <cstddef>

#include <QtCore/Qt>

#include "app/gui/participant/pages/page_frame.h"
#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

namespace {

using Action = ParticipantAction;

QString upper(const std::string& text) { return QString::fromStdString(text).toUpper(); }

QString text_of_feeling_again(const PageFrame& frame) {
  const std::vector<ParticipantScene::Surface>& surfaces = frame.scene().surfaces;
  if (const std::optional<int> wished = frame.scene().wished_surface) {
    const ParticipantScene::Surface& surface = surfaces.at(static_cast<std::size_t>(*wished - 1));
    return frame.said((surface.felt ? phrase("ParticipantLayout", "Feel %1 again")
                                    : phrase("ParticipantLayout", "Feel %1"))
                          .with(surface.code));
  }
  const std::optional<int> picked = frame.inputs().draft.surface;
  const bool names_it = picked && static_cast<std::size_t>(*picked) <= surfaces.size();
  // Where controls have little room their size stays the same.
  if (!names_it || !frame.is_wide()) {
    return frame.said(phrase("ParticipantLayout", "Feel again"));
  }
  return frame.said(phrase("ParticipantLayout", "Feel %1 again")
                        .with(surfaces[static_cast<std::size_t>(*picked - 1)].code));
}

}  // namespace

bool is_return(int key) noexcept { return key == Qt::Key_Return || key == Qt::Key_Enter; }

std::optional<ParticipantAction> key_of_trial(const ParticipantScene& scene, int key,
                                              const QString& typed, SurfaceKeys surfaces) {
  if (key == Qt::Key_Space && !scene.surfaces.empty()) return Action{.what = Action::What::next};
  if (typed.isEmpty()) return {};
  for (std::size_t i = 0; i < scene.choices.size(); ++i) {
    if (upper(scene.choices[i].key) == typed) {
      return Action{.what = Action::What::choose, .number = static_cast<int>(i) + 1};
    }
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const bool can_be_meant = surfaces == SurfaceKeys::all || scene.surfaces[i].can_go;
    if (can_be_meant && upper(scene.surfaces[i].code) == typed) {
      return Action{.what = Action::What::surface, .number = static_cast<int>(i) + 1};
    }
  }
  bool is_number = false;
  const int number = typed.toInt(&is_number);
  if (!is_number || number < 1) return {};
  const bool has_letters = static_cast<std::size_t>(number) <= scene.choices.size() &&
                           scene.choices[static_cast<std::size_t>(number - 1)].text.empty();
  if (has_letters || scene.choices.empty()) {
    return Action{.what = Action::What::choose, .number = number};
  }
  return {};
}

std::optional<ParticipantAction> key_of_question(const ParticipantScene& scene, int key,
                                                 const QString& typed, SurfaceKeys surfaces) {
  if (is_return(key)) return Action{.what = Action::What::confirm};
  return key_of_trial(scene, key, typed, surfaces);
}

void add_question_controls(PageFrame& frame, const ParticipantPage& page, bool is_ready) {
  const ParticipantScene& scene = frame.scene();
  const bool skips = scene.optional && page.is_empty(scene, frame.inputs().draft);
  frame.add_control(frame.said(skips ? phrase("ParticipantLayout", "Skip")
                                     : phrase("ParticipantLayout", "Confirm")),
                    frame.return_key(), {.what = Action::What::confirm}, skips || is_ready);
  if (!scene.can_switch) return;
  // A blank is part of a text.
  const bool has_key = page.typing(scene) != ParticipantPage::Typing::text;
  frame.add_control(text_of_feeling_again(frame), has_key ? frame.space_key() : QString(),
                    {.what = Action::What::next}, false);
}

}  // namespace asperity
