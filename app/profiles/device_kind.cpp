// Recognises simulated devices by their settings and "mouse" by its name; others are attached.

#include "app/profiles/device_kind.h"

#include <stdexcept>
#include <string_view>

#include "device/simulated_models.h"

namespace asperity {

DeviceKind kind_of_device(const std::string& device) {
  if (simulated_settings(device)) return DeviceKind::simulated;
  return device == "mouse" ? DeviceKind::pointer : DeviceKind::attached;
}

void require_virtual_hand_on(const std::string& device) {
  if (kind_of_device(device) == DeviceKind::simulated) return;
  throw std::runtime_error(
      "a virtual participant cannot hold the device \"" + device +
      "\"; leave out --device, or use simulated or one of its models, such as simulated:falcon");
}

std::string called(const DeviceCapability& device) {
  if (device.model.starts_with(kInPlaceOf)) return device.name + ' ' + device.model;
  const std::string_view given = properties_given_in(device);
  return given.empty() ? device.name : device.name + " with " + std::string(given);
}

}  // namespace asperity
