// What there is to know of a device.

#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

namespace asperity {

/// A property of a device that can be declared or measured. docs/formats/device_profile.md has what device-test measures of each.
enum class DeviceTrait {
  workspace,
  peak_force,
  continuous_force,
  rate,
  latency,
  position_step,
  position_noise,
  friction,
  damping,
  moving_mass,
  resonance,
  stiffness,         ///< of the stiffest spring that it holds
  force_resolution,  ///< the weakest force that moves it
};

inline constexpr std::array kDeviceTraits{
    DeviceTrait::workspace,        DeviceTrait::peak_force,
    DeviceTrait::continuous_force, DeviceTrait::rate,
    DeviceTrait::latency,          DeviceTrait::position_step,
    DeviceTrait::position_noise,   DeviceTrait::friction,
    DeviceTrait::damping,          DeviceTrait::moving_mass,
    DeviceTrait::resonance,        DeviceTrait::stiffness,
    DeviceTrait::force_resolution,
};

/// As files have it: "moving_mass".
constexpr std::string_view name_of(DeviceTrait trait) noexcept {
  switch (trait) {
    case DeviceTrait::workspace:
      return "workspace";
    case DeviceTrait::peak_force:
      return "peak_force";
    case DeviceTrait::continuous_force:
      return "continuous_force";
    case DeviceTrait::rate:
      return "rate";
    case DeviceTrait::latency:
      return "latency";
    case DeviceTrait::position_step:
      return "position_step";
    case DeviceTrait::position_noise:
      return "position_noise";
    case DeviceTrait::friction:
      return "friction";
    case DeviceTrait::damping:
      return "damping";
    case DeviceTrait::moving_mass:
      return "moving_mass";
    case DeviceTrait::resonance:
      return "resonance";
    case DeviceTrait::stiffness:
      return "stiffness";
    case DeviceTrait::force_resolution:
      return "force_resolution";
  }
  return "";
}

/// Those of `traits` that are not among `others`, in their order.
inline std::vector<DeviceTrait> traits_without(std::span<const DeviceTrait> traits,
                                               std::span<const DeviceTrait> others) {
  std::vector<DeviceTrait> left{};
  std::copy_if(traits.begin(), traits.end(), std::back_inserter(left), [&](DeviceTrait trait) {
    return std::find(others.begin(), others.end(), trait) == others.end();
  });
  return left;
}

}  // namespace asperity
