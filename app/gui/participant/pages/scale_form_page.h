// The page of a question about the session that is answered by a point on a scale.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& scale_form_page();

}  // namespace asperity
