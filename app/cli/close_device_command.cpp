// asperity close-device: opens and closes a device, for the process that starts this program when another one was killed.

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/cli/call_limit.h"
#include "app/cli/command.h"
#include "app/cli/options/driver_options.h"
#include "app/cli/options/number_option.h"
#include "app/cli/output/terminal.h"
#include "device/device_claim.h"

namespace asperity {

namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenTrials{50};

struct CloseDevice {
  std::string device{};
  std::string claim{};
  int seconds = 60;
  DriverOptions drivers{};
};

int close_device(const CloseDevice& job) {
  const std::chrono::seconds limit{job.seconds};
  const auto latest = steady_clock::now() + limit;
  // A program that only tries to open the device may fail, and releases the claim then.
  const auto claim = DeviceClaim::take_until(latest, job.claim);
  if (claim == nullptr) {
    say("asperity: the device " + job.device +
        " was left unchanged: another program drives it now, and has set its force to zero");
    return 0;
  }
  // Until the kernel has released the device of the killed program, it is in use.
  CallLimit call(job.device);
  const DriverRegistry drivers = built_in_drivers();
  for (;;) {
    try {
      // Both set the motors to zero.
      call.begin("opening the device", limit);
      auto device = drivers.open(job.device, job.drivers);
      call.begin("closing the device", limit);
      device.reset();
      return 0;
    } catch (const std::exception&) {
      if (steady_clock::now() > latest) throw;
    }
    call.end();
    std::this_thread::sleep_for(kBetweenTrials);
  }
}

}  // namespace

void add_close_device(CLI::App& program, Job& job) {
  auto options = std::make_shared<CloseDevice>();
  CLI::App* command = program.add_subcommand("close-device", "Set the force of a device to zero.");
  command->group("");  // for the program itself: in no list of commands
  command->add_option("DEVICE", options->device, "NAME or NAME:SERIAL")->required();
  command->add_option("--claim", options->claim, "The name of the device's DeviceClaim")
      ->required();
  command
      ->add_option("--within", options->seconds,
                   "Give up after so many seconds, and where a call takes as long")
      ->check(number_within(1, 3600));
  add_driver_options(*command, options->drivers);
  command->callback([options, &job] {
    options->drivers.closing_program.clear();
    job = [options] { return close_device(*options); };
  });
}

}  // namespace asperity
