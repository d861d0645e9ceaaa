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

/// The kind of the device with a name as in `RunInputs::device`. Errors: as simulated_settings.
DeviceKind kind_of_device(const std::string& device);

/// Errors: std::runtime_error for a device that no virtual participant can hold: one that is not simulated; as
/// kind_of_device.
void require_virtual_hand_on(const std::string& device);

/// The display name: the name of the driver; "simulated in place of Novint Falcon with mass_kg=0.2" or "simulated with
/// mass_kg=0.2".
std::string called(const DeviceCapability& device);

}  // namespace asperity
