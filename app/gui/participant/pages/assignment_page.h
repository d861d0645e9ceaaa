// The page of a question that is answered by giving each surface a picture.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& assignment_page();

}  // namespace asperity
