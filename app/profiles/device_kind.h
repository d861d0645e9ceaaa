// What kind of device a name stands for.

#pragma once

#include <string>

#include "device/device_capability.h"

namespace asperity {

enum class DeviceKind {
  simulated,  ///< held by the virtual hand, in place of a real device or of none
  pointer,    ///< the mouse of a window: moves, and gives no force
  attached,   ///< hardware
};

/// Of what `RunInputs::device` names. Errors: std::runtime_error for a "simulated:MODEL" that there is not.
DeviceKind kind_of_device(const std::string& device);

/// As people tell it from others: its driver's name, and "simulated in place of Novint Falcon".
std::string called(const DeviceCapability& device);

}  // namespace asperity
