// Where everything stands in the participant's picture.

#pragma once

#include <vector>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

/// The picture of a scene: one page of it, where its words do not fit on one. No letter is smaller
/// than `smallest_text_px`; in a window with room all are larger. What has many words is divided,
/// between sentences where that is possible, and has items that turn the page; the last page has what
/// answers the scene. Options of a form too are divided where they find no room on one page. Everything
/// fits without scrolling in a window of 17 × 19 of the smallest letters' heights and more, which is
/// half of a screen of 1093 × 614 px.
std::vector<ParticipantItem> lay_out(const ParticipantScene& scene,
                                     const ParticipantLayoutInputs& inputs);

}  // namespace asperity
