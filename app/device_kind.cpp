// What kind of device a name stands for.

#include "app/device_kind.h"

#include "device/simulated_models.h"

namespace asperity {

DeviceKind kind_of_device(const std::string& device) {
  if (simulated_settings(device)) return DeviceKind::simulated;
  return device == "mouse" ? DeviceKind::pointer : DeviceKind::attached;
}

}  // namespace asperity
