// What every driver finds on this computer.

#include "app/tasks/device_survey.h"

namespace asperity {

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
                        .summary = driver.summary,
                        .has_motors = driver.has_motors,
                        .survey = drivers.survey(driver, options_of(driver.id))});
  }
  return surveyed;
}

}  // namespace asperity
