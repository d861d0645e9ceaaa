// What every driver finds on this computer.

#pragma once

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

}  // namespace asperity
