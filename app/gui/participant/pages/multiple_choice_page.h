// The page of a choice of one or more options in words.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& multiple_choice_page();

}  // namespace asperity
