// The page of a question that is answered by a number above 0.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& number_page();

}  // namespace asperity
