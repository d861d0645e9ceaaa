// A page of words only: a text, a rest, the eye mask, feedback, a pause, the end.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& words_page();

}  // namespace asperity
