// Lays the page of a scene out again until the number of its screen pages no longer changes.

#include "app/gui/participant/participant_layout.h"

#include <algorithm>

#include <QtCore/Qt>

#include "app/gui/participant/pages/page_for.h"
#include "app/gui/participant/pages/page_frame.h"

namespace asperity {

namespace {

/// An arrow moves the mark of a scale, and among the letters of a field for text.
bool arrow_turns(const PageFrame& frame, const ParticipantPage& page) {
  const bool has_field =
      frame.page() == frame.pages() && page.typing(frame.scene()) == ParticipantPage::Typing::text;
  return !has_field && !page.action_of_key(frame.scene(), Qt::Key_Left, {});
}

void begin_page(PageFrame& frame, const ParticipantPage& page, int number) {
  frame.begin_page(number);
  if (number == frame.pages()) page.add_controls(frame);
  frame.add_turning_controls(arrow_turns(frame, page));
}

}  // namespace

std::vector<ParticipantItem> lay_out(const ParticipantScene& scene,
                                     const ParticipantLayoutInputs& inputs) {
  PageFrame frame(scene, inputs);
  const ParticipantPage& page = page_for(scene);
  if (scene.kind == ParticipantScene::Kind::blank) {
    // The ground stays empty but for a cue, where it stands in other scenes.
    begin_page(frame, page, 1);
    frame.clear();
    frame.end_controls(frame.controls_top());
    frame.cue();
    return frame.take_items();
  }
  for (;;) {
    const int pages = frame.pages();
    const int answer_page = frame.answer_page();
    // On every page of a text the words have the same room: that which the fullest row of controls
    // leaves.
    double top = inputs.size.height();
    for (const int number : {1, std::min(2, pages), pages}) {
      begin_page(frame, page, number);
      top = std::min(top, frame.controls_top());
    }
    frame.clear();
    const int last = answer_page > 0 ? answer_page : pages;
    begin_page(frame, page, inputs.page == 0 ? last : std::clamp(inputs.page, 1, pages));
    frame.end_controls(top);
    page.lay_out(frame);
    frame.cue();
    // More pages take more room for the controls that turn them, never less: it comes to an end.
    if (frame.pages() == pages && frame.answer_page() == answer_page) return frame.take_items();
    frame.clear();
  }
}

}  // namespace asperity
