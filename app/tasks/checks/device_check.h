// Checks whether a session can run on its device, and whether it is the device of the session so far.

#pragma once

#include <optional>

#include "app/tasks/checks/session_check.h"
#include "device/haptic_device.h"
#include "protocols/design/protocol.h"

namespace asperity {

SessionCheck device_check(const CheckInputs& inputs, const Protocol& protocol);

/// What the device declares of itself; empty for an attached one that has not been opened.
std::optional<DeviceCapability> capability_of(const CheckInputs& inputs, const Protocol& protocol);

bool has_motors(const DeviceCapability& device);

}  // namespace asperity
