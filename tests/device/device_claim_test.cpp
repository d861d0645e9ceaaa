// A device is driven by one process at a time, and free again however that process ends.

#include "device/device_claim.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "device/drivers.h"
#include "tests/support/eventually.h"
#include "tests/support/scripted_device.h"
#include "tests/support/waiting_child.h"

namespace asperity {
namespace {

/// A serial number that no other run of these tests has.
std::string own_serial() { return std::to_string(::getpid()); }

TEST(DeviceClaim, IsOneAtATime) {
  const std::string name = "library:" + own_serial();
  const auto first = DeviceClaim::take(name);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(DeviceClaim::take(name), nullptr);
  EXPECT_NE(DeviceClaim::take(name + "1"), nullptr);
}

TEST(DeviceClaim, IsFreeWhenItsProcessIsKilled) {
  const std::string name = "library:" + own_serial();
  WaitingChild child([&name] { return DeviceClaim::take(name); });
  EXPECT_EQ(DeviceClaim::take(name), nullptr);
  child.kill();
  EXPECT_NE(DeviceClaim::take(name), nullptr);
}

TEST(DeviceClaim, DistinguishesLongNamesByTheirEnds) {
  const std::string beginning(200, 'x');
  const auto one = DeviceClaim::take(beginning + own_serial() + "a");
  const auto other = DeviceClaim::take(beginning + own_serial() + "b");
  EXPECT_NE(one, nullptr);
  EXPECT_NE(other, nullptr);
}

/// A driver of a manufacturer's library, of which each call counts those while `is_driven_elsewhere`.
struct LibraryDriver {
  std::string id = "library" + own_serial();
  std::atomic<bool> is_driven_elsewhere{true};
  int calls = 0;
  int disturbing_calls = 0;
  DriverRegistry drivers{};

  LibraryDriver() {
    drivers.add({.id = id,
                 .is_closed_by_another_process = true,
                 .find =
                     [this](const DriverOptions&) {
                       count();
                       return DriverSurvey{.attached = {{.model = "one"}}};
                     },
                 .open =
                     [this](const std::string&, const DriverOptions&) {
                       count();
                       return std::make_unique<ScriptedDevice>(
                           DeviceCapability{.name = id, .serial = "7", .peak_force_N = 1.0});
                     }});
  }

  void count() {
    ++calls;
    if (is_driven_elsewhere) ++disturbing_calls;
  }
  DriverSurvey survey() const {
    return drivers.survey(*drivers.find(id), {.closing_program = "/bin/true"});
  }
};

// To read the serial number of a device is to open it, and to close it then would end it for the other process.
TEST(Drivers, OpenNoDeviceBeforeAnotherProcessHasReleasedItsClaim) {
  LibraryDriver library;
  auto other = DeviceClaim::take(library.id);
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    library.is_driven_elsewhere = false;
    other.reset();
  });
  auto device = library.drivers.open(library.id, {.closing_program = "/bin/true"});
  EXPECT_EQ(library.calls, 1);
  EXPECT_EQ(library.disturbing_calls, 0);
  EXPECT_EQ(DeviceClaim::take(library.id), nullptr) << "this process has it";
  device.reset();
  EXPECT_NE(DeviceClaim::take(library.id), nullptr);
}

TEST(Drivers, SearchForNoDeviceWhileAnotherProcessDrivesOne) {
  LibraryDriver library;
  auto other = DeviceClaim::take(library.id);
  const DriverSurvey survey = library.survey();
  EXPECT_EQ(library.calls, 0);
  EXPECT_TRUE(survey.attached.empty());
  EXPECT_NE(survey.blocker.find("another process of this program drives a device of the driver"),
            std::string::npos)
      << survey.blocker;
  other.reset();
  EXPECT_EQ(library.survey().attached.size(), 1U);
  EXPECT_NE(DeviceClaim::take(library.id), nullptr) << "a search keeps no claim";
}

}  // namespace
}  // namespace asperity
