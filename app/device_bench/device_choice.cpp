// What a session may run on: what the program has itself, and what is attached.

#include "app/device_bench/device_choice.h"

#include <stdexcept>

#include "app/words/shell_word.h"
#include "device/drivers.h"
#include "device/simulated_models.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

constexpr const char* kSimulated = "simulated";
constexpr const char* kMouse = "mouse";

}  // namespace

std::vector<DeviceChoice> devices_without_hardware() {
  std::vector<DeviceChoice> choices{{.device = kSimulated, .kind = DeviceKind::simulated}};
  for (const std::string& model : simulated_models()) {
    choices.push_back({.device = std::string(kSimulated) + ':' + model,
                       .kind = DeviceKind::simulated,
                       .model = model});
  }
  choices.push_back({.device = kMouse, .kind = DeviceKind::pointer});
  return choices;
}

std::vector<DeviceChoice> device_choices(const std::vector<SurveyedDriver>& surveyed) {
  std::vector<DeviceChoice> choices = devices_without_hardware();
  for (const SurveyedDriver& driver : surveyed) {
    if (driver.id == kSimulated || driver.id == kMouse) continue;
    for (const AttachedDevice& found : driver.survey.attached) {
      // The serial number stays the device's own when it is plugged in elsewhere.
      const std::string& tag = found.serial.empty() ? found.place : found.serial;
      choices.push_back({.device = driver.id + (tag.empty() ? "" : ":" + tag),
                         .kind = DeviceKind::attached,
                         .driver = driver.name,
                         .model = found.model,
                         .remark = found.remark,
                         .blocker = found.blocker});
    }
    if (!driver.survey.blocker.empty()) {
      choices.push_back({.device = driver.id,
                         .kind = DeviceKind::attached,
                         .driver = driver.name,
                         .blocker = driver.survey.blocker});
    }
  }
  return choices;
}

std::string as_command_options(const DriverOptions& options) {
  std::string words{};
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) words += ' ' + std::string(option) + ' ' + shell_word(value);
  };
  add("--firmware", options.firmware.string());
  add("--library", options.library.string());
  add("--service", options.service);
  return words;
}

void require_device(const std::string& option, const std::string& device) {
  const auto refuse = [&](const std::string& reason) {
    throw std::runtime_error(option + ' ' + device + ": " + reason);
  };
  try {
    if (simulated_settings(device)) return;
  } catch (const std::exception& error) {
    refuse(message_of(error));
  }
  const DriverRegistry drivers = built_in_drivers();
  if (drivers.find(device.substr(0, device.find(':'))) != nullptr) return;
  std::string names{};
  for (const Driver& driver : drivers.drivers()) names += (names.empty() ? "" : ", ") + driver.id;
  refuse("there is no such device; choose one of: " + names);
}

WhichDevice which_device(const std::string& device) {
  const std::size_t colon = device.find(':');
  WhichDevice which{.name = device.substr(0, colon)};
  if (const auto simulated = simulated_settings(device)) {
    if (simulated->stands_for) which.model = simulated->stands_for->model;
  } else if (colon != std::string::npos) {
    // Or a place, "usb 1-3": serial numbers have no blanks.
    const std::string one = device.substr(colon + 1);
    if (one.find(' ') == std::string::npos) which.serial = one;
  }
  return which;
}

}  // namespace asperity
