// Compares the stimuli of a session with the measured properties of its device.

#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "app/tasks/checks/session_check.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// The first line is about the profile of the device in the study, each further one ("rehearsal") about one kind of
/// stimuli beyond it. The same comparison as that of the session, which refuses what is refused here. `progress`
/// receives the progress of the comparison, 0 to 1; it ends early when `stop` is requested.
std::vector<SessionCheck> calibration_checks(const CheckInputs& inputs, const Protocol& protocol,
                                             const ModelRegistry& models,
                                             const std::stop_token& stop,
                                             const std::function<void(double)>& progress);

}  // namespace asperity
