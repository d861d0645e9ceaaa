// asperity devices: the drivers, what each finds attached, and what would make it usable.

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/driver_options.h"
#include "app/device_bench/device_survey.h"

namespace asperity {

namespace {

nlohmann::ordered_json text_or_null(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

nlohmann::ordered_json json_of_driver(const SurveyedDriver& driver) {
  nlohmann::ordered_json attached = nlohmann::ordered_json::array();
  for (const AttachedDevice& device : driver.survey.attached) {
    attached.push_back({{"model", device.model},
                        {"serial", text_or_null(device.serial)},
                        {"place", text_or_null(device.place)},
                        {"usable", device.is_usable()},
                        {"remark", text_or_null(device.remark)},
                        {"hindrance", text_or_null(device.blocker)}});
  }
  return {{"id", driver.id},
          {"summary", driver.summary},
          {"found", text_or_null(driver.survey.found)},
          {"hindrance", text_or_null(driver.survey.blocker)},
          {"attached", std::move(attached)}};
}

void print_driver(const SurveyedDriver& driver) {
  std::cout << driver.id << "\n  " << driver.summary << '\n';
  if (!driver.survey.found.empty()) std::cout << "  found: " << driver.survey.found << '\n';
  for (const AttachedDevice& device : driver.survey.attached) {
    std::string name = device.model;
    if (!device.serial.empty()) name += ", serial " + device.serial;
    if (!device.place.empty()) name += ", at " + device.place;
    if (device.is_usable()) {
      std::cout << "  ready: " << name << '\n';
      if (!device.remark.empty()) std::cout << "    " << device.remark << '\n';
    } else {
      std::cout << "  not usable: " << name << "\n    " << device.blocker << '\n';
    }
  }
  if (!driver.survey.blocker.empty()) {
    std::cout << "  not usable: " << driver.survey.blocker << '\n';
  } else if (driver.survey.attached.empty()) {
    std::cout << "  none attached: plug one in and check that it has power; docs/devices.md lists "
                 "what else it needs (a udev rule, firmware)\n";
  }
}

}  // namespace

void add_devices(CLI::App& program, Job& job) {
  struct Options {
    bool json = false;
    DriverOptions drivers{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "devices",
      "List the drivers, the attached devices, and what each needs before it can be used.");
  add_driver_options(*command, options->drivers);
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback([options, &job] {
    job = [options] {
      const auto surveyed = survey_devices(built_in_drivers(), options->drivers);
      if (options->json) {
        nlohmann::ordered_json document{{"format", "asperity.devices/1"},
                                        {"drivers", nlohmann::ordered_json::array()}};
        for (const SurveyedDriver& driver : surveyed) {
          document["drivers"].push_back(json_of_driver(driver));
        }
        std::cout << document.dump(2) << '\n';
      } else {
        for (const SurveyedDriver& driver : surveyed) print_driver(driver);
        if (const Phrase missing = missing_udev_rule(); !missing.empty()) {
          std::cout << missing.english() << '\n';
        }
      }
      return 0;
    };
  });
}

}  // namespace asperity
