// asperity close-device: opens and closes a device, for the process that starts this program when another one was killed.

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/driver_options.h"

namespace asperity {

namespace {

using std::chrono::steady_clock;

// The kernel releases the device of a killed program when it can; until then it is in use.
constexpr std::chrono::seconds kLongest{60};
constexpr std::chrono::milliseconds kBetweenTrials{50};

int close_device(const std::string& device, DriverOptions options) {
  options.closing_program.clear();
  const DriverRegistry drivers = built_in_drivers();
  const auto latest = steady_clock::now() + kLongest;
  for (;;) {
    try {
      drivers.open(
          device,
          options);  // both set the motors to zero, the opening and the end of what it returns
      return 0;
    } catch (const std::exception&) {
      if (steady_clock::now() > latest) throw;
    }
    std::this_thread::sleep_for(kBetweenTrials);
  }
}

}  // namespace

void add_close_device(CLI::App& program, Job& job) {
  struct Options {
    std::string device{};
    DriverOptions drivers{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("close-device", "Set the force of a device to zero.");
  command->group("");  // for the program itself: in no list of commands
  command->add_option("DEVICE", options->device, "NAME or NAME:SERIAL")->required();
  add_driver_options(*command, options->drivers);
  command->callback([options, &job] {
    job = [options] { return close_device(options->device, options->drivers); };
  });
}

}  // namespace asperity
