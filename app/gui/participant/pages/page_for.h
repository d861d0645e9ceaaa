// Chooses the page of a scene: the only place that knows all of them.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& page_for(const ParticipantScene& scene);

}  // namespace asperity
