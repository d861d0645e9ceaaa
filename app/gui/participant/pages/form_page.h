// The page of a question about the participant or the session: options, a number, or a text.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& form_page();

}  // namespace asperity
