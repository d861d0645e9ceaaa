// Which of Force Dimension's devices is which, and what each can do.

#pragma once

#include <optional>

#include "device/device_capability.h"

namespace asperity {

/// A model as the SDK's system type tells it; its serial number is left empty. Nothing for a system
/// type that we do not know.
///
/// The force, and the radius of the workspace about its centre, are those that CHAI3D 3.2 drives the models with
/// (src/devices/CDeltaDevices.cpp); they have not been compared with the maker's own pages. Position resolution and
/// continuous force are not told (0). For lambda.7, which CHAI3D does not know, they are those of sigma.7.
struct DhdModel {
  DeviceCapability capability{};
  bool has_wrist = false;  ///< senses orientation
  bool has_gripper = false;
};
std::optional<DhdModel> dhd_model_of(int system_type);

}  // namespace asperity
