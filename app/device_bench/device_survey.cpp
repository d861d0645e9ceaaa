// What every driver finds on this computer.

#include "app/device_bench/device_survey.h"

#include <algorithm>
#include <system_error>

namespace asperity {

namespace {

constexpr const char* kUdevRule = "70-asperity.rules";

/// Where it is in a folder above the program: as `cmake --install` has put it, or in the source from which the program was
/// built; its name where there is none.
std::string udev_rule_of_this_program() {
  std::error_code unseen{};
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unseen);
  for (std::filesystem::path above = program.parent_path(); above.has_relative_path();
       above = above.parent_path()) {
    for (const char* folder : {"lib/udev/rules.d", "device/udev"}) {
      const std::filesystem::path rule = above / folder / kUdevRule;
      if (std::filesystem::exists(rule, unseen)) return rule.string();
    }
  }
  return kUdevRule;
}

}  // namespace

std::vector<SurveyedDriver> survey_devices(const DriverRegistry& drivers,
                                           const DriverOptions& options) {
  return survey_devices(drivers, [&options](const std::string&) { return options; });
}

std::vector<SurveyedDriver> survey_devices(
    const DriverRegistry& drivers,
    const std::function<DriverOptions(const std::string& driver)>& options_of) {
  std::vector<SurveyedDriver> surveyed{};
  for (const Driver& driver : drivers.drivers()) {
    surveyed.push_back({.id = driver.id,
                        .name = driver.name.empty() ? driver.id : driver.name,
                        .summary = driver.summary,
                        .has_motors = driver.has_motors,
                        .survey = drivers.survey(driver, options_of(driver.id))});
  }
  return surveyed;
}

std::vector<std::filesystem::path> udev_folders() {
  return {"/etc/udev/rules.d", "/run/udev/rules.d", "/usr/local/lib/udev/rules.d",
          "/usr/lib/udev/rules.d", "/lib/udev/rules.d"};
}

Phrase missing_udev_rule(const std::vector<std::filesystem::path>& folders) {
  const bool is_there =
      std::any_of(folders.begin(), folders.end(), [](const std::filesystem::path& folder) {
        std::error_code unseen{};
        return std::filesystem::exists(folder / kUdevRule, unseen);
      });
  if (is_there) return {};
  return phrase("DeviceSurvey",
                "The udev rules file %1 is not installed: only root can open USB devices. Copy %2 "
                "into /etc/udev/rules.d, then unplug the device and plug it in again "
                "(docs/devices.md).")
      .with(kUdevRule, udev_rule_of_this_program());
}

}  // namespace asperity
