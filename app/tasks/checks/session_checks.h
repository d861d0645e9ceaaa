// The checklist before a session: whether it can start, and what the experimenter should know.

#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "app/tasks/checks/session_check.h"
#include "device/drivers.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Runs all checks, in the order in which problems should be fixed: "protocol", "protocol_warnings" (only
/// if there are any), "participant", "study", "disk",
/// "stimuli", "device", "calibration", "rehearsal" (one line for each kind of stimuli beyond the device's profile in
/// the study), "force_zero", "rate", "screens", "masking_noise". If the protocol cannot be read, its line is the only
/// one.
///
/// In real time the servo loop runs for some 0.3 s, on a device that the program has itself. An attached device is not
/// opened: without `tried` the lines "force_zero" and "rate" are missing, and "device" has the state `stop`.
/// `drivers` are those of the session. When `stop` is requested, the remaining checks are left out. `progress` receives
/// the progress of the comparison with the device, 0 to 1. Problems are returned and never thrown.
std::vector<SessionCheck> check_session(const CheckInputs& inputs, const ModelRegistry& models,
                                        const std::stop_token& stop,
                                        const std::function<void(double)>& progress = {},
                                        const DriverRegistry& drivers = built_in_drivers());

}  // namespace asperity
