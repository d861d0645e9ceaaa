// The page on which a surface is felt, and the blank screen between two surfaces.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& feel_page();

}  // namespace asperity
