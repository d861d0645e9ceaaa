// The driver of OpenHaptics' devices, unmodified, against a library with the same functions and a scheduler's thread.

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/openhaptics/openhaptics_device.h"
#include "device/vendor_library.h"
#include "renderers/servo/servo_loop.h"
#include "renderers/servo/servo_thread.h"
#include "tests/device/hanging_tick.h"
#include "tests/device/long_tick.h"
#include "tests/device/read_and_push.h"
#include "tests/device/vendors/test_hd.h"
#include "tests/support/patience.h"
#include "tests/support/patient_servo.h"
#include "tests/support/refusal.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class OpenHaptics : public testing::Test {
 protected:
  OpenHaptics() : library_("the stand-in", {ASPERITY_TEST_HD}) {
    library_.find("test_hd_reset", reset_);
    reset_();
    TestHdBench bench_of = nullptr;
    library_.find("test_hd_bench", bench_of);
    bench = bench_of();
  }
  ~OpenHaptics() override { reset_(); }

  // A busy machine may keep the scheduler's thread waiting for long.
  std::unique_ptr<OpenHapticsDevice> open(std::chrono::milliseconds patience = kPatience) {
    return std::make_unique<OpenHapticsDevice>(
        std::make_shared<const HdFunctions>(ASPERITY_TEST_HD), "", patience);
  }
  std::vector<std::string> calls() {
    const std::lock_guard lock(bench->mutex);
    return bench->calls;
  }

  const Driver driver = openhaptics_driver();
  const DriverOptions options{.library = ASPERITY_TEST_HD};
  test_hd::Bench* bench = nullptr;

 private:
  VendorLibrary library_;
  TestHdReset reset_ = nullptr;
};

TEST_F(OpenHaptics, TellsWhatItNeeds) {
  EXPECT_THAT(driver.find({.library = "/no/such/libHD.so"}).blocker,
              AllOf(HasSubstr("OpenHaptics is not installed"), HasSubstr("/no/such/libHD.so")));
  EXPECT_THAT(driver.find({.library = ASPERITY_TEST_OLD_HD}).blocker,
              AllOf(HasSubstr("hdUnschedule"), HasSubstr("not the version")));
  bench->is_attached = false;
  const DriverSurvey survey = driver.find(options);
  EXPECT_EQ(survey.blocker, "");
  EXPECT_THAT(survey.attached.at(0).blocker, AllOf(HasSubstr("HD_COMM_ERROR"), HasSubstr("cable")));
}

TEST_F(OpenHaptics, DescribesTheDeviceAsItDescribesItself) {
  const DeviceCapability capability = driver.open("", options)->capability();
  EXPECT_EQ(capability.model, "Touch");
  EXPECT_EQ(capability.serial, "T-17");
  EXPECT_EQ(capability.pacing, Pacing::theirs);
  EXPECT_EQ(capability.sensed_degrees_of_freedom, 6);
  EXPECT_EQ(capability.actuated_degrees_of_freedom, 3);
  EXPECT_EQ(capability.peak_force_N, 3.3);
  EXPECT_EQ(capability.continuous_force_N, 0.88);
  // 320 × 180 × 120 mm to the right, up and towards the participant, about their middle.
  EXPECT_NEAR(glm::distance(capability.workspace_maximum_m, glm::dvec3(0.160, 0.060, 0.090)), 0.0,
              1e-12);
  EXPECT_NEAR(glm::distance(capability.workspace_minimum_m, glm::dvec3(-0.160, -0.060, -0.090)),
              0.0, 1e-12);
}

TEST_F(OpenHaptics, OpensByConfiguredNameOrBySerialNumber) {
  driver.open("Left Device", options);
  EXPECT_THAT(calls(), Contains("hdInitDevice Left Device"));
  EXPECT_EQ(driver.open("T-17", options)->capability().serial, "T-17");
  EXPECT_THAT(refusal_of([&] { driver.open("Right Device", options); }),
              HasSubstr("\"Right Device\""));
}

TEST_F(OpenHaptics, RefusesADeviceWithoutLimitOrCalibrationAndClosesIt) {
  bench->peak_force_N = 0.0;
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("peak force"));
  bench->peak_force_N = 3.3;
  bench->calibration = 0x5002;
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("inkwell"));
  EXPECT_THAT(calls(), ElementsAre("hdInitDevice default", "hdDisableDevice",
                                   "hdInitDevice default", "hdDisableDevice"));
  bench->calibration = 0x5001;
  open();
  EXPECT_THAT(calls(), Contains("hdUpdateCalibration 4"));
  bench->calibration = 0x5001;
  bench->calibrates = false;
  EXPECT_THAT(refusal_of([&] { open(); }), HasSubstr("not calibrated"));
  EXPECT_EQ(calls().back(), "hdDisableDevice");
}

TEST_F(OpenHaptics, LeavesADeviceThatThisProgramUsesAlone) {
  const auto device = open();
  bench->calls.clear();
  const int made_current = bench->made_current;
  const DriverSurvey survey = driver.find(options);
  ASSERT_EQ(survey.attached.size(), 1U);
  EXPECT_EQ(survey.attached[0].serial, "T-17");
  EXPECT_THAT(survey.attached[0].blocker, HasSubstr("This program uses it"));
  EXPECT_THAT(refusal_of([&] { driver.open("Left Device", options); }),
              HasSubstr("This program uses Touch T-17"));
  EXPECT_THAT(calls(), IsEmpty());
  EXPECT_EQ(bench->made_current, made_current);
}

TEST_F(OpenHaptics, TicksOnceInEachFrame) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(20);
  device->stop_calls();
  EXPECT_EQ(bench->disorders, 0);
  EXPECT_EQ(bench->frames, servo.ticks + 1);  // and one to say zero
  EXPECT_THAT(calls(), Contains("hdEnable " + std::to_string(0x4000)));
  EXPECT_THAT(calls(), Contains("hdEnable " + std::to_string(0x4001)));
  const int ticks = servo.ticks;
  device->stop_calls();
  servo.start();
  servo.wait_for(3);
  EXPECT_GT(servo.ticks, ticks);
}

TEST_F(OpenHaptics, TellsThePoseInMetresAndInOurFrame) {
  // 10 mm right, 20 mm up and 30 mm towards the participant of the workspace's middle (0, 30, −10); turned by +90°
  // about the axis that points up: what pointed right points away.
  const double transform[16] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 10, 50, 20, 1};
  std::copy_n(transform, 16, bench->transform);
  bench->buttons = 2;
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(8);
  const ProbeState probe = servo.probe();
  EXPECT_NEAR(glm::distance(probe.position_m, glm::dvec3(0.010, -0.030, 0.020)), 0.0, 1e-12);
  EXPECT_NEAR(
      glm::distance(probe.orientation * glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)), 0.0,
      1e-12);
  EXPECT_NEAR(
      glm::distance(probe.orientation * glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 0.0, 1.0)), 0.0,
      1e-12);
  EXPECT_EQ(probe.velocity_m_per_s, glm::dvec3(0.0));
  EXPECT_EQ(probe.buttons, 2U);
}

TEST_F(OpenHaptics, SendsForcesInItsFrameAndNeverAboveItsPeak) {
  const auto device = open();
  device->set_limits({.force_N = 50.0, .torque_N_m = 0.1, .slew_N = 1e6});
  ReadAndPush servo{device.get(), {.force_N = {0.3, 0.2, 0.1}, .torque_N_m = {0.01, 0.0, 0.0}}};
  servo.start();
  servo.wait_for(2);
  {
    const std::lock_guard lock(bench->mutex);
    EXPECT_THAT(bench->force_N, ElementsAre(0.3, 0.1, -0.2));
    EXPECT_THAT(bench->torque, ElementsAre(9.0, 9.0, 9.0));  // it cannot turn: never touched
  }
  device->stop_calls();
  servo.wanted.force_N = {0.0, 0.0, 40.0};
  servo.start();
  servo.wait_for(2);
  device->stop_calls();
  EXPECT_NEAR(bench->strongest_N, 3.3, 1e-12);
  EXPECT_LE(bench->strongest_N, 3.3);
  EXPECT_THAT(bench->force_N, ElementsAre(0.0, 0.0, 0.0));
}

TEST_F(OpenHaptics, SendsTorqueInNewtonMillimetresToModelsThatCanTurn) {
  bench->actuated_degrees = 6;
  const auto device = open();
  device->set_limits({.force_N = 3.0, .torque_N_m = 0.1, .slew_N = 1e6, .slew_N_m = 1e6});
  ReadAndPush servo{device.get(), {.torque_N_m = {0.01, 0.02, 0.03}}};
  servo.start();
  servo.wait_for(2);
  const std::lock_guard lock(bench->mutex);
  EXPECT_NEAR(bench->torque[0], 10.0, 1e-12);
  EXPECT_NEAR(bench->torque[1], 30.0, 1e-12);
  EXPECT_NEAR(bench->torque[2], -20.0, 1e-12);
}

struct HdErrorAtTheEnd {
  std::string called{};
  unsigned int code = 0;
  std::string name{};
};

class OpenHapticsAfterAFrameWithAnError : public OpenHaptics,
                                          public testing::WithParamInterface<HdErrorAtTheEnd> {};

TEST_P(OpenHapticsAfterAFrameWithAnError, RefusesAPushAndNamesIt) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  EXPECT_EQ(servo.refused, 0);
  {
    const std::lock_guard lock(bench->mutex);
    bench->error_of_each_end = GetParam().code;
  }
  while (servo.refused == 0) std::this_thread::yield();
  EXPECT_EQ(servo.unread, 0);  // it can be read, and is
  EXPECT_THAT(device->trouble(), AllOf(HasSubstr("Touch T-17"), HasSubstr(GetParam().name)));
}

INSTANTIATE_TEST_SUITE_P(
    Codes, OpenHapticsAfterAFrameWithAnError,
    testing::Values(HdErrorAtTheEnd{"WarmMotors", 0x0200, "HD_WARM_MOTORS (its motors are warm"},
                    HdErrorAtTheEnd{"ExceededForce", 0x0201,
                                    "HD_EXCEEDED_MAX_FORCE (more force was requested"},
                    HdErrorAtTheEnd{"DeviceFault", 0x0300, "HD_DEVICE_FAULT (the device reports"}),
    [](const auto& instance) { return instance.param.called; });

TEST_F(OpenHaptics, SendsNothingInAFrameThatBeginsWithAnError) {
  const auto device = open();
  device->set_limits({.force_N = 3.0, .torque_N_m = 0.1, .slew_N = 1e6});
  {
    const std::lock_guard lock(bench->mutex);
    bench->error_of_each_begin = 0x0203;
  }
  ReadAndPush servo{device.get(), {.force_N = {0.0, 0.0, 1.0}}};
  servo.start();
  servo.wait_for(3);
  device->stop_calls();
  EXPECT_EQ(bench->strongest_N, 0.0);  // the first frame included
  EXPECT_EQ(servo.refused, servo.ticks);
  EXPECT_EQ(servo.unread, 0);
}

TEST_F(OpenHaptics, TellsTheGravestOfSomeErrors) {
  bench->errors = {0x0100, 0x0300, 0x0200, 0x0101};
  EXPECT_EQ(HdFunctions(ASPERITY_TEST_HD).take_errors().code, 0x0300U);
  EXPECT_EQ(HdFunctions(ASPERITY_TEST_HD).take_errors().code, 0U);
}

TEST_F(OpenHaptics, BeginsAnewAfterAnError) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  bench->mutex.lock();
  bench->error_of_each_end = 0x0200;
  bench->mutex.unlock();
  while (servo.refused == 0) std::this_thread::yield();
  device->stop_calls();
  bench->error_of_each_end = 0;
  const int refused = servo.refused;
  servo.start();
  servo.wait_for(3);
  EXPECT_EQ(servo.refused, refused);
  EXPECT_EQ(device->trouble(), "");
}

TEST_F(OpenHaptics, DoesNotAnswerWhenTheDeviceIsGoneAndDoesAgainAfterwards) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  EXPECT_EQ(servo.unread, 0);
  {
    const std::lock_guard lock(bench->mutex);
    bench->is_attached = false;
  }
  while (servo.unread == 0) std::this_thread::yield();
  EXPECT_THAT(device->trouble(), HasSubstr("HD_COMM_ERROR"));
  {
    const std::lock_guard lock(bench->mutex);
    bench->is_attached = true;
  }
  servo.wait_for(3);
  const int unread = servo.unread;
  servo.wait_for(3);
  EXPECT_EQ(servo.unread, unread);
}

TEST_F(OpenHaptics, AsksForTheRateOrSaysThatItCannotBeHad) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  EXPECT_THAT(refusal_of([&] {
                device->start_calls(
                    {.function = &ReadAndPush::tick, .argument = &servo, .rate_Hz = 2000.0});
              }),
              HasSubstr("2000 Hz"));
  device->start_calls({.function = &ReadAndPush::tick, .argument = &servo, .rate_Hz = 500.0});
  {
    const std::lock_guard lock(bench->mutex);
    EXPECT_EQ(bench->rate_Hz, 500U);
  }
  device->stop_calls();
  EXPECT_EQ(bench->rate_Hz, 1000U);  // the scheduler is one for the process
}

TEST_F(OpenHaptics, IsAsBeforeWhenItsSchedulerDoesNotStart) {
  const auto device = open();
  ReadAndPush servo{device.get()};
  bench->refuses_to_start = true;
  EXPECT_THAT(refusal_of([&] { servo.start(500.0); }), HasSubstr("HD_TIMER_ERROR"));
  EXPECT_FALSE(bench->gives_force);
  EXPECT_EQ(bench->rate_Hz, 1000U);
  EXPECT_EQ(device->trouble(), "");
  bench->refuses_to_start = false;
  servo.start();
  servo.wait_for(3);
}

TEST_F(OpenHaptics, LetsGoOfASchedulerThatNeverCalled) {
  const auto device = open(std::chrono::milliseconds(20));
  ReadAndPush servo{device.get()};
  bench->never_calls = true;
  servo.start();
  EXPECT_TRUE(bench->gives_force);
  device->stop_calls();
  EXPECT_FALSE(bench->gives_force);
  EXPECT_THAT(calls(), Contains("hdUnschedule"));
  EXPECT_EQ(device->trouble(), "");
}

// The tick is this program's own, and what it works on is freed once the calls are stopped.
TEST_F(OpenHaptics, WaitsForATickUnderWay) {
  LongTick tick;
  const auto device = open();
  device->start_calls({.function = &LongTick::run, .argument = &tick});
  tick.wait_until_begun();
  tick.end_calls([&device] { device->stop_calls(); });
  EXPECT_TRUE(tick.has_ended);
  EXPECT_FALSE(tick.was_left);
  EXPECT_EQ(device->trouble(), "");
}

TEST_F(OpenHaptics, EndsAtZeroForceAndLetsGo) {
  {
    const auto device = open();
    device->set_limits({.force_N = 3.0, .torque_N_m = 0.1, .slew_N = 1e6});
    ReadAndPush servo{device.get(), {.force_N = {0.0, 0.0, 1.0}}};
    servo.start();
    servo.wait_for(2);
    device->stop_calls();
    EXPECT_EQ(bench->strongest_N, 1.0);
  }
  EXPECT_THAT(bench->force_N, ElementsAre(0.0, 0.0, 0.0));
  const std::vector<std::string> all = calls();
  EXPECT_EQ(all.back(), "hdDisableDevice");
  EXPECT_THAT(all, Contains("hdStopScheduler"));
}

TEST_F(OpenHaptics, IsLostWithItsWordsOnItAfterFiftyMillisecondsWithoutAFrame) {
  const auto device = open();
  RecordRing ring(16384);
  ServoLoop loop(*device, ring, patient_servo());
  EXPECT_EQ(1e9 * loop.settings().silence_to_fault_s, 50e6);
  const ServoThread thread(loop, *device, Scheduling::normal);
  while (loop.status().ticks < 2) std::this_thread::yield();
  bench->hangs = true;
  while (loop.status().fault != Fault::device_lost) std::this_thread::yield();
  EXPECT_THAT(device->complaint(),
              AllOf(HasSubstr("OpenHaptics' scheduler"), HasSubstr("Touch T-17"),
                    HasSubstr("for more than 50 ms")));
  bench->hangs = false;
  while (!device->complaint().empty()) std::this_thread::yield();
}

TEST_F(OpenHaptics, HasItsForceSwitchedOffWhileATickHangs) {
  const auto device = open();
  device->set_limits({.force_N = 3.0, .torque_N_m = 0.1, .slew_N = 1e6});
  expect_zero_force_while_a_tick_hangs(*device, [this] {
    const std::lock_guard lock(bench->mutex);
    return bench->gives_force && std::hypot(bench->force_N[0], bench->force_N[1]) > 0.5;
  });
  EXPECT_EQ(bench->disorders, 0);
}

TEST_F(OpenHaptics, EndsTheServoThreadWhileItsOwnHangs) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler what_is_left_behind_on_purpose;
#endif
  const auto device = open(std::chrono::milliseconds(20));
  RecordRing ring(16384);
  ServoLoop loop(*device, ring, patient_servo());
  {
    const ServoThread thread(loop, *device, Scheduling::normal);
    while (loop.status().ticks < 2) std::this_thread::yield();
    bench->hangs = true;
    while (loop.status().fault != Fault::device_lost) std::this_thread::yield();
    // The watch looks at it several times.
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_THAT(device->trouble(), HasSubstr("hangs"));
  const int frames = bench->frames;
  bench->hangs = false;
  while (bench->frames == frames) std::this_thread::yield();
}

TEST_F(OpenHaptics, LeavesAThreadThatHangsBehind) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler what_is_left_behind_on_purpose;
#endif
  auto device = open(std::chrono::milliseconds(20));
  ReadAndPush servo{device.get()};
  servo.start();
  servo.wait_for(2);
  bench->hangs = true;
  while (!bench->is_hanging) std::this_thread::yield();
  const int ticks = servo.ticks;
  // Somebody asks how it is while it is given up: the thread sanitizer sees what both touch.
  std::thread asking([&device] {
    while (device->trouble().find("hangs") == std::string::npos) std::this_thread::yield();
  });
  device->stop_calls();  // comes back
  asking.join();
  EXPECT_THAT(device->trouble(), HasSubstr("hangs"));
  EXPECT_FALSE(device->read(0).has_value());
  EXPECT_THAT(refusal_of([&] { servo.start(); }), HasSubstr("hangs"));
  servo.device = nullptr;
  device.reset();
  EXPECT_THAT(calls(),
              Not(Contains("hdStopScheduler")));  // it would wait for the thread that hangs

  const int frames = bench->frames;
  bench->hangs = false;  // the thread comes back to a device that is gone
  while (bench->frames == frames) std::this_thread::yield();
  EXPECT_EQ(servo.ticks, ticks);
  const std::lock_guard lock(bench->mutex);
  EXPECT_THAT(bench->force_N, ElementsAre(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace asperity
