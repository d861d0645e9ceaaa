// The pictures that the questions of a plan show.

#pragma once

#include <functional>
#include <map>
#include <vector>

#include <QtCore/QString>

#include "app/gui/participant/participant_layout.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// Study-relative, by the side at which they are shown. `side_px` is the side on the screen of a side
/// in the layout.
std::map<int, std::vector<QString>> pictures_of_plan(const Plan& plan,
                                                     ParticipantLayoutInputs inputs,
                                                     const std::function<int(double)>& side_px);

}  // namespace asperity
