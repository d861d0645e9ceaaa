// What every driver finds on this computer.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "device/drivers.h"

namespace asperity {

struct SurveyedDriver {
  std::string id{};
  std::string summary{};
  bool has_motors = true;  ///< Driver::has_motors
  DriverSurvey survey{};
};

/// Asks each driver in turn. May take seconds; a device that a session uses is left alone.
std::vector<SurveyedDriver> survey_devices(const DriverRegistry& drivers,
                                           const DriverOptions& options);
/// Likewise, where what a driver is told depends on which it is: two makers have two libraries.
std::vector<SurveyedDriver> survey_devices(
    const DriverRegistry& drivers,
    const std::function<DriverOptions(const std::string& driver)>& options_of);

}  // namespace asperity
