// The page of a question that is answered by one of several options (pictures, letters or words), or by several in words.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& choice_page();

}  // namespace asperity
