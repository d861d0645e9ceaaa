// What every driver finds on this computer.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "device/drivers.h"

namespace asperity {

struct SurveyedDriver {
  std::string id{};
  std::string name{};  ///< never empty
  std::string summary{};
  bool has_motors = true;  ///< Driver::has_motors
  DriverSurvey survey{};
};

/// Asks each driver in turn. May take seconds; a device that a session uses is left alone.
std::vector<SurveyedDriver> survey_devices(const DriverRegistry& drivers,
                                           const DriverOptions& options);
/// The same with options that depend on the driver: two makers have two libraries.
std::vector<SurveyedDriver> survey_devices(
    const DriverRegistry& drivers,
    const std::function<DriverOptions(const std::string& driver)>& options_of);

/// Those in which udev looks for rules.
std::vector<std::filesystem::path> udev_folders();
/// Where none of `folders` has the program's rule, and devices on USB are open to root alone: what to copy where.
/// Empty where one has it.
Phrase missing_udev_rule(const std::vector<std::filesystem::path>& folders = udev_folders());

}  // namespace asperity
