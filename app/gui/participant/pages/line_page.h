// The page on which a line is drawn as the answer.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

/// The question over a field in which the line begins at the left and ends where it is pressed or where arrows move its
/// end. The field shows neither a number nor the end of the longest line.
const ParticipantPage& line_page();

}  // namespace asperity
