// Runs the servo loop without a surface: no force is sent, and the rate is kept.

#pragma once

#include "app/tasks/checks/session_check.h"
#include "device/drivers.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Whether the loop can run now: not on a device that is absent or has not been opened.
bool can_be_tried(const CheckInputs& inputs);

struct LoopChecks {
  SessionCheck zero{};
  SessionCheck rate{};
};
/// Both results of one run of some 0.3 s, or of the last trial of an attached device.
LoopChecks loop_checks(const CheckInputs& inputs, const Protocol& protocol,
                       const DriverRegistry& drivers);

}  // namespace asperity
