// The drivers of this program: what each finds attached, and how one of the found is opened.

#include "device/drivers.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "device/closing_process.h"
#include "device/device_claim.h"
#include "device/falcon/falcon_device.h"
#include "device/force_dimension/force_dimension_device.h"
#include "device/inverse3/inverse3_device.h"
#include "device/openhaptics/openhaptics_device.h"
#include "device/pause.h"
#include "device/pointer_device.h"
#include "device/replay_device.h"
#include "device/simulated_models.h"
#include "device/spacemouse/spacemouse_device.h"
#include "device/units_in_use.h"

namespace asperity {
namespace {

bool is_driver_id(const std::string& id) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !id.empty() && is_letter(id.front()) && std::all_of(id.begin(), id.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

Driver simulated_driver() {
  return {.id = "simulated",
          .name = "Simulated device",
          .summary =
              "A probe held by a virtual hand, for rehearsal and tests: no participant feels it.",
          .find =
              [](const DriverOptions&) {
                std::string names;
                for (const std::string& model : simulated_models()) {
                  names += (names.empty() ? "simulated:" : ", simulated:") + model;
                }
                return DriverSurvey{
                    .attached = {{.model = "simulated hand and probe",
                                  .remark = "It can simulate these devices: " + names + "."}}};
              },
          .open = [](const std::string& model,
                     const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            if (options.hand == nullptr) {
              throw std::invalid_argument(
                  "the simulated device needs a virtual hand to hold it, and there is none; choose "
                  "another device");
            }
            return std::make_unique<SimulatedDevice>(
                *options.hand,
                model.empty() ? options.simulated : as_model(model, options.simulated));
          }};
}

// The lock under which one looks or opens, once nobody else does; not held where the stop came first.
std::unique_lock<std::mutex> alone_until(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kBetweenTrials(10);
  std::unique_lock alone(UnitInUse::looking(), std::defer_lock);
  while (!alone.try_lock() && !stop.stop_requested()) pause(stop, kBetweenTrials);
  return alone;
}

// "serial 042 at usb 1-2"
std::string tag_of(const AttachedDevice& device) {
  const std::string serial = device.serial.empty() ? "" : "serial " + device.serial;
  const std::string place = device.place.empty() ? "" : "at " + device.place;
  return serial + (serial.empty() || place.empty() ? "" : " ") + place;
}

std::string tags_of(const std::vector<AttachedDevice>& devices) {
  std::string tags;
  for (const AttachedDevice& device : devices) tags += (tags.empty() ? "" : "; ") + tag_of(device);
  return tags;
}

// What goes with a device that another process closes where this program is killed.
struct ForClosing {
  std::unique_ptr<DeviceClaim> claim{};  // released last
  std::optional<ClosingProcess> process{};
};

// Whether devices of the driver are opened, even to read their serial numbers, only with its claim.
bool needs_claim(const Driver& driver, const DriverOptions& options) {
  return driver.is_closed_by_another_process && !options.closing_program.empty();
}

std::string driven_by_another(const Driver& driver) {
  return "another process of this program drives a device of the driver \"" + driver.id +
         "\": end that process, then ";
}

std::unique_ptr<DeviceClaim> claim_within(std::chrono::seconds longest, const Driver& driver,
                                          const std::stop_token& stop) {
  return DeviceClaim::take_until(std::chrono::steady_clock::now() + longest, driver.id, stop);
}

[[noreturn]] void nothing_was_opened() {
  throw OpeningStopped(
      "no device was opened: opening was stopped on request; open the device again to use it");
}

// Opens a device that another process closes where this program is killed.
std::unique_ptr<HapticDevice> open_for_closing(const Driver& driver, const std::string& which,
                                               const DriverOptions& options) {
  // This process has the claim, and the driver states which device is in use.
  if (!UnitInUse::of(driver.id).empty()) return driver.open(which, options);
  auto closing = std::make_shared<ForClosing>();
  closing->claim = claim_within(std::chrono::seconds(5), driver, options.stop);
  if (options.stop.stop_requested()) nothing_was_opened();
  if (closing->claim == nullptr) {
    throw std::runtime_error("the device cannot be opened, because " + driven_by_another(driver) +
                             "open the device again");
  }
  std::unique_ptr<HapticDevice> device = driver.open(which, options);
  // The name that has opened it: a serial number opens only the default one of OpenHaptics' devices.
  const std::string same = which.empty() ? device->capability().serial : which;
  closing->process.emplace(options.closing_program, driver.id + (same.empty() ? "" : ":" + same),
                           driver.id, options.library);
  device->keep(std::move(closing));
  return device;
}

// A search by another process, which may open devices, ends within a second.
DriverSurvey survey_with_claim(const Driver& driver, const DriverOptions& options) {
  std::unique_ptr<DeviceClaim> claim{};
  if (needs_claim(driver, options) && UnitInUse::of(driver.id).empty()) {
    claim = claim_within(std::chrono::seconds(1), driver, options.stop);
    if (claim == nullptr) {
      return {.blocker = "No device was searched for, because " + driven_by_another(driver) +
                         "search again."};
    }
  }
  return driver.find(options);
}

}  // namespace

void DriverRegistry::add(Driver driver) {
  if (!is_driver_id(driver.id)) {
    throw std::invalid_argument(
        "id of a driver is \"" + driver.id +
        "\"; it must consist of letters a to z, digits and _, and begin with a letter");
  }
  if (find(driver.id) != nullptr) {
    throw std::invalid_argument("there are two drivers \"" + driver.id +
                                "\"; each needs its own id");
  }
  drivers_.push_back(std::move(driver));
}

const Driver* DriverRegistry::find(std::string_view id) const& noexcept {
  for (const Driver& driver : drivers_) {
    if (driver.id == id) return &driver;
  }
  return nullptr;
}

std::unique_ptr<HapticDevice> DriverRegistry::open(const std::string& name,
                                                   const DriverOptions& options) const {
  const std::size_t colon = name.find(':');
  const std::string id = name.substr(0, colon);
  const Driver* driver = find(id);
  if (driver == nullptr) {
    std::string ids;
    for (const Driver& one : drivers_) ids += (ids.empty() ? "" : ", ") + one.id;
    throw std::runtime_error("there is no device \"" + id + "\"; choose one of: " + ids);
  }
  std::unique_lock alone = alone_until(options.stop);
  if (!alone.owns_lock()) nothing_was_opened();
  DriverOptions told = options;
  told.alone = &alone;
  const std::string which = colon == std::string::npos ? "" : name.substr(colon + 1);
  std::unique_ptr<HapticDevice> device = needs_claim(*driver, options)
                                             ? open_for_closing(*driver, which, told)
                                             : driver->open(which, told);
  if (options.stop.stop_requested()) {
    throw OpeningStopped(
        "the device \"" + name +
        "\" was closed: opening it was stopped on request; open it again to use it");
  }
  return device;
}

DriverSurvey DriverRegistry::survey(const Driver& driver, const DriverOptions& options) const {
  const std::unique_lock alone = alone_until(options.stop);
  DriverSurvey survey{};
  if (alone.owns_lock()) survey = survey_with_claim(driver, options);
  // What a driver found by then may be half of what is there, or a service that was not waited for.
  if (options.stop.stop_requested()) {
    throw LookStopped("the search for devices of the driver \"" + driver.id +
                      "\" was stopped on request; search again to find them");
  }
  return survey;
}

DriverRegistry built_in_drivers() {
  DriverRegistry registry;
  registry.add(simulated_driver());
  registry.add(falcon_driver());
  registry.add(force_dimension_driver());
  registry.add(openhaptics_driver());
  registry.add(inverse3_driver());
  registry.add(spacemouse_driver());
  registry.add(pointer_driver());
  registry.add(replay_driver());
  return registry;
}

std::optional<VelocityWindow> velocity_window_of(std::string_view driver, std::string_view model) {
  if (const auto simulated = settings_of_model(model)) return simulated->sensor.velocity;
  const DriverRegistry drivers = built_in_drivers();
  const Driver* const found = drivers.find(driver);
  return found == nullptr ? std::nullopt : found->velocity;
}

AttachedDevice choose_attached(const std::string& product,
                               const std::vector<AttachedDevice>& attached,
                               const std::string& which) {
  if (attached.empty()) {
    throw std::runtime_error("no " + product +
                             " is attached: plug it in, and check that it has power");
  }
  std::vector<AttachedDevice> fitting;
  std::copy_if(attached.begin(), attached.end(), std::back_inserter(fitting),
               [&which](const AttachedDevice& device) {
                 return which.empty() || device.serial == which || device.place == which;
               });
  if (fitting.empty()) {
    throw std::runtime_error("no " + product + " has the serial number or place \"" + which +
                             "\"; choose one that is attached: " + tags_of(attached));
  }
  if (fitting.size() > 1) {
    throw std::runtime_error(std::to_string(fitting.size()) + " devices are attached (" + product +
                             "); name one by its serial number or place: " + tags_of(fitting));
  }
  if (!fitting.front().is_usable()) throw std::runtime_error(fitting.front().blocker);
  return fitting.front();
}

}  // namespace asperity
