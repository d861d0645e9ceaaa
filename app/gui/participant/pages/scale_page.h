// The page of scales: the labelled points of one as a list, or the lines of one or more in rows.

#pragma once

#include "app/gui/participant/pages/participant_page.h"

namespace asperity {

const ParticipantPage& scale_page();

}  // namespace asperity
