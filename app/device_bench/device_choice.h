// What a session may run on: what the program has itself, and what is attached.

#pragma once

#include <string>
#include <vector>

#include "app/device_bench/device_survey.h"
#include "app/profiles/device_kind.h"
#include "app/profiles/device_profile.h"

namespace asperity {

/// One line of a list to choose from.
struct DeviceChoice {
  std::string
      device{};  ///< as RunInputs::device takes it; by serial number or place where there is one
  DeviceKind kind = DeviceKind::simulated;
  std::string driver{};   ///< of what is attached, SurveyedDriver::name
  std::string model{};    ///< of what is attached; what the simulated one stands for, "falcon"
  std::string remark{};   ///< a sentence about a usable one, or empty
  std::string blocker{};  ///< a sentence: why it cannot be used now; empty: it can

  bool is_usable() const noexcept { return blocker.empty(); }
};

/// The simulated devices first, then the mouse, then what the drivers found; a driver that cannot work at
/// all is a line without model.
std::vector<DeviceChoice> device_choices(const std::vector<SurveyedDriver>& surveyed);
/// Those that are there whatever is attached.
std::vector<DeviceChoice> devices_without_hardware();

/// The options of a driver, as a command takes them: " --library FILE"; empty without options.
std::string as_command_options(const DriverOptions& options);

/// Checks what --device names, without opening it.
/// Errors: std::runtime_error with a sentence that begins with `option` and names what is wrong: no such driver, model or
/// property, or a value that a simulated device does not take.
void require_device(const std::string& option, const std::string& device);

/// Whose profile belongs to what `device` names, as far as the name says.
/// Errors: as kind_of_device.
WhichDevice which_device(const std::string& device);

}  // namespace asperity
