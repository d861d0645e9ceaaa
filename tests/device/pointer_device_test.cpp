// A pointer's samples, as a window would give them, and the probe that follows.

#include "device/pointer_device.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

class APointer : public testing::Test {
 protected:
  // Reads once a millisecond until `tick`, which it has been read at when this returns.
  ProbeState read_until(int tick) {
    ProbeState probe{};
    for (; tick_ <= tick; ++tick_) {
      probe = device_.read(kTick_ns * tick_).value();
      device_.push({.force_N = {0.0, 0.0, 1.0}}, 1e-3);
    }
    return probe;
  }

  LatestValue<PointerSample> samples_{};
  PointerDevice device_{samples_};
  int tick_ = 0;
};

TEST_F(APointer, WaitsAboveTheSurface) {
  const ProbeState probe = read_until(100);
  EXPECT_EQ(probe.position_m, glm::dvec3(0.0, 0.0, 0.005));
  EXPECT_EQ(probe.velocity_m_per_s, glm::dvec3(0.0));
}

TEST_F(APointer, ComesDownAsDeepAsAPenPresses) {
  samples_.put({.position_m = {0.02, -0.03}, .pressure = 0.25});
  EXPECT_EQ(read_until(0).position_m, glm::dvec3(0.02, -0.03, 0.005));  // from above
  const ProbeState probe = read_until(400);
  EXPECT_NEAR(probe.position_m.z, -0.25 * 0.002, 1e-9);
  EXPECT_NEAR(probe.position_m.x, 0.02, 1e-12);
  samples_.put({.position_m = {0.02, -0.03}});
  EXPECT_NEAR(read_until(800).position_m.z, 0.005, 1e-9);
}

TEST_F(APointer, PressesHalfWhileAMousesButtonIsHeld) {
  samples_.put({.is_held = true});
  EXPECT_NEAR(read_until(400).position_m.z, -0.5 * 0.002, 1e-9);
}

// x(t) = 1 − (1 + ωt) e^(−ωt) of the way after a step.
TEST_F(APointer, FollowsAStepAsACriticallyDampedSpring) {
  samples_.put({});
  read_until(0);
  samples_.put({.position_m = {0.01, 0.0}});
  read_until(1);
  for (int since = 1; since < 100; ++since) {
    const double wt = 80.0 * 1e-3 * since;
    const ProbeState probe = read_until(1 + since);
    ASSERT_NEAR(probe.position_m.x, 0.01 * (1.0 - (1.0 + wt) * std::exp(-wt)), 1e-12);
    ASSERT_NEAR(probe.velocity_m_per_s.x, 0.01 * 80.0 * wt * std::exp(-wt), 1e-10);
  }
}

TEST_F(APointer, TrailsASteadyPointerBy25Milliseconds) {
  // Samples of each millisecond stand still until the next one: half of one is added.
  double x_m = 0.0;
  for (int tick = 0; tick < 600; ++tick) {
    x_m = 0.1e-3 * tick;
    samples_.put({.position_m = {x_m, 0.0}, .is_held = true});
    const ProbeState probe = read_until(tick);
    if (tick < 400) continue;
    ASSERT_NEAR(x_m - probe.position_m.x, 0.1 * (0.025 + 0.0005), 1e-6);
    ASSERT_NEAR(probe.velocity_m_per_s.x, 0.1, 1e-4);
  }
}

TEST_F(APointer, MovesTheSameHoweverOftenItIsRead) {
  LatestValue<PointerSample> same_samples;
  PointerDevice rarely(same_samples);
  samples_.put({});
  same_samples.put({});
  read_until(0);
  rarely.read(0);
  samples_.put({.position_m = {0.01, 0.02}, .pressure = 1.0});
  same_samples.put({.position_m = {0.01, 0.02}, .pressure = 1.0});
  read_until(1);
  rarely.read(kTick_ns);
  const ProbeState often = read_until(31);
  const ProbeState once = rarely.read(31 * kTick_ns).value();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(once.position_m[axis], often.position_m[axis], 1e-14);
    EXPECT_NEAR(once.velocity_m_per_s[axis], often.velocity_m_per_s[axis], 1e-12);
  }
}

TEST_F(APointer, StaysInItsWorkspaceAndIgnoresWhatIsNoNumber) {
  samples_.put({.position_m = {5.0, -5.0}, .pressure = 7.0});
  read_until(0);
  samples_.put({.position_m = {std::numeric_limits<double>::quiet_NaN(), 0.0}});
  const ProbeState probe = read_until(400);
  EXPECT_NEAR(probe.position_m.x, 0.1, 1e-9);
  EXPECT_NEAR(probe.position_m.y, -0.1, 1e-9);
  EXPECT_NEAR(probe.position_m.z, -0.002, 1e-9);
}

TEST_F(APointer, HasNoMotors) {
  EXPECT_EQ(device_.capability().actuated_degrees_of_freedom, 0);
  EXPECT_EQ(device_.capability().peak_force_N, 0.0);
  read_until(0);
  const LimitedWrench sent = device_.push({.force_N = {0.0, 0.0, 99.0}}, 1.0).value();
  EXPECT_EQ(sent.wrench.force_N, glm::dvec3(0.0));  // nobody felt anything
}

TEST_F(APointer, DoesNotTouchTheHeap) {
  AllocationGuard guard;
  for (int tick = 0; tick < 100; ++tick) {
    samples_.put({.position_m = {1e-4 * tick, 0.0}, .is_held = true});
    read_until(tick);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(PointerDriver, OpensThePointerOfAWindowOnly) {
  const DriverRegistry drivers = built_in_drivers();
  EXPECT_THROW(drivers.open("mouse", {}), std::runtime_error);
  EXPECT_FALSE(drivers.find("mouse")->find({}).blocker.empty());
  LatestValue<PointerSample> samples;
  EXPECT_EQ(drivers.open("mouse", {.pointer = &samples})->capability().name, "mouse");
  EXPECT_EQ(drivers.find("mouse")->find({.pointer = &samples}).attached.size(), 1U);
}

TEST(PointerSettings, AreRefusedByName) {
  LatestValue<PointerSample> samples;
  EXPECT_THROW(PointerDevice(samples, {.half_width_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(PointerDevice(samples, {.deepest_m = -1.0}), std::invalid_argument);
  EXPECT_THROW(PointerDevice(samples, {.held_pressure = 1.1}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
