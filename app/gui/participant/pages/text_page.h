// The page of a text in the participant's words.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& text_page();

}  // namespace asperity
