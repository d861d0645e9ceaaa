// Determines the kind of device from its name.

#pragma once

#include <string>

#include "device/device_capability.h"

namespace asperity {

enum class DeviceKind {
  simulated,  ///< held by the virtual hand; models a real device or none
  pointer,    ///< the mouse pointer of a window: moves, and gives no force
  attached,   ///< hardware
};

/// The kind of the device with a name as in `RunInputs::device`. Errors: std::runtime_error for a
/// "simulated:MODEL" that does not exist.
DeviceKind kind_of_device(const std::string& device);

/// The display name: the name of the driver, and "simulated in place of Novint Falcon".
std::string called(const DeviceCapability& device);

}  // namespace asperity
