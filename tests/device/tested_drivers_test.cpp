// Every driver, unmodified, on its emulated device, measured as `asperity device-test` measures a real one: what it has
// to do, and that it lets go. How punctual it is depends on the test machine, and how an emulated handle moves says
// nothing: both are left to real devices.

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "app/device_bench/measure_device.h"
#include "device/drivers.h"
#include "device/vendor_library.h"
#include "tests/device/emulated_falcon.h"
#include "tests/device/emulated_spacemouse.h"
#include "tests/device/vendors/test_dhd.h"
#include "tests/device/vendors/test_hd.h"
#include "tests/device/vendors/test_inverse_service.h"
#include "tests/support/patience.h"

namespace asperity {
namespace {

using Status = DeviceItem::Status;

constexpr std::array kSafety{"limiter", "zero_after_stop", "zero_after_not_finite",
                             "zero_without_heartbeat"};

Status status_of(const DeviceProfile& profile, const std::string& name) {
  const DeviceItem* item = profile.item(name);
  return item == nullptr ? Status::fail : item->status;
}

/// Whether something that has to be so was not looked at: what was looked at and is wrong stays wrong.
bool is_incomplete(const DeviceProfile& profile) {
  const auto is_wanting = [&profile](const char* name) {
    return status_of(profile, name) == Status::not_measured;
  };
  const auto fails = [&profile](const char* name) {
    return status_of(profile, name) == Status::fail;
  };
  if (std::any_of(kSafety.begin(), kSafety.end(), fails) || fails("force_zero_N")) return false;
  return std::any_of(kSafety.begin(), kSafety.end(), is_wanting) || is_wanting("force_zero_N");
}

bool is_of_a_loss(const std::runtime_error& error) {
  return std::string(error.what())
      .starts_with("the connection to the device was lost during the measurement");
}

// A busy machine may keep the other side of a wire from answering for 50 ms, which is a loss like another: only what
// was not measured for that is measured again.
DeviceProfile measured_by(const std::function<DeviceProfile()>& measure) {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  for (;;) {
    const bool is_last = std::chrono::steady_clock::now() > until;
    try {
      DeviceProfile profile = measure();
      if (is_last || !is_incomplete(profile)) return profile;
    } catch (const std::runtime_error& error) {
      if (is_last || !is_of_a_loss(error)) throw;
    }
  }
}

DeviceProfile measured(const std::function<std::unique_ptr<HapticDevice>()>& open) {
  MeasureOrder order{};
  order.test.force_N = 1.0;  // a handle that nothing moves is believed up to 2 N
  order.test.rate_Hz = 500.0;
  order.test.mechanics = StagePacing::stepped;
  return measured_by([&] { return measure_device(*open(), order, {}).profile; });
}

DeviceProfile with_safety(Status status) {
  DeviceProfile profile{};
  for (const char* name : kSafety) profile.items.push_back({.name = name, .status = Status::pass});
  profile.items.push_back({.name = "force_zero_N", .status = Status::pass, .value = 0.0});
  profile.items[1].status = status;
  return profile;
}

TEST(TestedDriver, IsMeasuredAgainOnlyWhereItWasNotMeasured) {
  const auto trials_until = [](const std::function<DeviceProfile()>& first, Status found) {
    int trials = 0;
    const DeviceProfile profile = measured_by([&] {
      ++trials;
      return trials == 1 ? first() : with_safety(Status::pass);
    });
    EXPECT_EQ(profile.items[1].status, found);
    return trials;
  };
  EXPECT_EQ(trials_until([] { return with_safety(Status::fail); }, Status::fail), 1);
  EXPECT_EQ(trials_until([] { return with_safety(Status::not_measured); }, Status::pass), 2);
  const auto lost = []() -> DeviceProfile {
    throw std::runtime_error(
        "the connection to the device was lost during the measurement: it does not answer");
  };
  EXPECT_EQ(trials_until(lost, Status::pass), 2);
  const auto refused = []() -> DeviceProfile { throw std::runtime_error("cannot be opened"); };
  EXPECT_THROW(measured_by(refused), std::runtime_error);
  EXPECT_THROW(trials_until(refused, Status::pass), std::runtime_error);
}

void expect_function_and_safety(const DeviceProfile& profile) {
  EXPECT_FALSE(profile.is_simulated);
  for (const char* name : kSafety) {
    EXPECT_EQ(status_of(profile, name), Status::pass)
        << name << ": "
        << (profile.item(name) == nullptr ? "" : profile.item(name)->text.english());
  }
  EXPECT_EQ(status_of(profile, "force_zero_N"), Status::pass);
  EXPECT_EQ(profile.value("force_zero_N"), 0.0);
  EXPECT_TRUE(profile.value("rate_Hz").has_value()) << "told, whatever it is";
  EXPECT_TRUE(profile.value("lateness_p99_s").has_value());
}

class TestedUsbDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (!EmulatedBus::is_possible()) GTEST_SKIP() << "not started under umockdev-wrapper";
    bus_.emplace();
  }
  std::optional<EmulatedBus> bus_{};
};

TEST_F(TestedUsbDevice, PassesFunctionAndSafetyAsAFalcon) {
  EmulatedFalcon emulated(*bus_, {});
  const DriverRegistry drivers = built_in_drivers();
  expect_function_and_safety(
      measured([&] { return drivers.open("falcon", {.wants_fifo = false}); }));
  EXPECT_GT(emulated.take_strongest_word(), 0) << "its motors were asked for a force";
  EXPECT_EQ(emulated.motor_words(), (std::array<std::int16_t, 3>{}));
}

TEST_F(TestedUsbDevice, HasNothingToLetGoOfAsASpaceMouse) {
  const EmulatedSpaceMouse emulated(*bus_, {});
  const DriverRegistry drivers = built_in_drivers();
  MeasureOrder order{};
  order.test.mechanics = StagePacing::stepped;
  order.test.timing = StagePacing::stepped;
  const DeviceProfile profile = measure_device(*drivers.open("spacemouse", {}), order, {}).profile;
  for (const char* name : kSafety) EXPECT_EQ(status_of(profile, name), Status::not_measured);
  EXPECT_EQ(status_of(profile, "force_zero_N"), Status::pass);
  EXPECT_FALSE(profile.has_failed());
}

TEST(TestedForceDimension, PassesFunctionAndSafety) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_DRD});
  TestDhdBench bench_of = nullptr;
  library.find("test_dhd_bench", bench_of);
  *bench_of() = test_dhd::Bench{};
  bench_of()->units.push_back({.type = 33, .serial = 7});
  const DriverRegistry drivers = built_in_drivers();
  expect_function_and_safety(
      measured([&] { return drivers.open("force_dimension", {.library = ASPERITY_TEST_DRD}); }));
  for (const double sent : bench_of()->units[0].sent) EXPECT_EQ(sent, 0.0);
  EXPECT_TRUE(bench_of()->units[0].is_stopped);
}

TEST(TestedOpenHaptics, PassesFunctionAndSafety) {
  const VendorLibrary library("the stand-in", {ASPERITY_TEST_HD});
  TestHdReset reset = nullptr;
  library.find("test_hd_reset", reset);
  reset();
  TestHdBench bench_of = nullptr;
  library.find("test_hd_bench", bench_of);
  const DriverRegistry drivers = built_in_drivers();
  expect_function_and_safety(
      measured([&] { return drivers.open("openhaptics", {.library = ASPERITY_TEST_HD}); }));
  EXPECT_GT(bench_of()->strongest_N, 0.0);
  for (const double force_N : bench_of()->force_N) EXPECT_EQ(force_N, 0.0);
  reset();
}

TEST(TestedInverse3, PassesFunctionAndSafety) {
  TestInverseService service{};
  const DriverRegistry drivers = built_in_drivers();
  expect_function_and_safety(
      measured([&] { return drivers.open("inverse3", {.service = service.place()}); }));
  const std::lock_guard lock(service.bench().mutex);
  EXPECT_GT(service.bench().strongest_N, 0.0);
  EXPECT_EQ(service.bench().force_N, (std::array<double, 3>{}));
}

}  // namespace
}  // namespace asperity
