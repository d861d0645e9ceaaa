#include "app/profiles/device_kind.h"

#include "device/simulated_models.h"

namespace asperity {

DeviceKind kind_of_device(const std::string& device) {
  if (simulated_settings(device)) return DeviceKind::simulated;
  return device == "mouse" ? DeviceKind::pointer : DeviceKind::attached;
}

std::string called(const DeviceCapability& device) {
  return device.model.starts_with(kInPlaceOf) ? device.name + ' ' + device.model : device.name;
}

}  // namespace asperity
