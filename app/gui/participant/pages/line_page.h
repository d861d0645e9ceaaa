// The page on which a line is drawn as the answer.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

/// The question over a field in which the line begins at the left and ends where it is pressed or where arrows move its
/// end. No number is shown.
const ParticipantPage& line_page();

}  // namespace asperity
