// A device is driven by one process at a time, and free again however that process ends.

#include "device/device_claim.h"

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

TEST(Drivers, OpenADeviceAgainThatAnotherProcessHadClaimed) {
  int opened = 0;
  DriverRegistry drivers;
  drivers.add({.id = "library",
               .is_closed_by_another_process = true,
               .open = [&opened](const std::string&, const DriverOptions&) {
                 ++opened;
                 return std::make_unique<ScriptedDevice>(DeviceCapability{
                     .name = "library", .serial = own_serial(), .peak_force_N = 1.0});
               }});
  const std::string claim = "library:" + own_serial();
  auto other = DeviceClaim::take(claim);
  std::jthread later([&other] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.reset();
  });
  auto device = drivers.open("library", {.closing_program = "/bin/true"});
  EXPECT_EQ(opened, 2);
  EXPECT_EQ(DeviceClaim::take(claim), nullptr) << "this process has it";
  device.reset();
  EXPECT_NE(DeviceClaim::take(claim), nullptr);
}

}  // namespace
}  // namespace asperity
