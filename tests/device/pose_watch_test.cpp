// Which poses that stay the same are believed.

#include "device/pose_watch.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/device/ticks.h"

namespace asperity {
namespace {

ProbeState at(std::int64_t tick, double x_m, double speed_m_per_s = 0.0) {
  return {.time_ns = tick * kTick_ns,
          .position_m = {x_m, 0.0, 0.0},
          .velocity_m_per_s = {speed_m_per_s, 0.0, 0.0}};
}

/// Ticks until it is frozen, at most 100 000.
int ticks_until_frozen(double force_N, double speed_m_per_s) {
  PoseWatch watch;
  for (int tick = 0; tick < 100'000; ++tick) {
    watch.take(at(tick, 0.01, speed_m_per_s), force_N);
    if (watch.is_frozen()) return tick;
  }
  return 100'000;
}

TEST(PoseWatch, DoesNotBelieveMotorsThatMoveNothingForASecond) {
  EXPECT_EQ(ticks_until_frozen(2.1, 0.0), 1002);  // the second counts from the first tick of it
  EXPECT_EQ(ticks_until_frozen(2.0, 0.0), 100'000);
}

TEST(PoseWatch, DoesNotBelieveAPlaceThatItsOwnVelocityLeaves) {
  EXPECT_EQ(ticks_until_frozen(0.0, 0.1), 201);  // 2 cm
}

TEST(PoseWatch, BelievesAHandAtRestOnAnEncoder) {
  // Steps of 38 µm, one to and one fro in every 0.9 s, against 4 N.
  PoseWatch watch;
  for (int tick = 0; tick < 60'000; ++tick) {
    watch.take(at(tick, tick / 900 % 2 == 0 ? 0.01 : 0.010038), 4.0);
    ASSERT_FALSE(watch.is_frozen()) << tick;
  }
}

TEST(PoseWatch, BelievesAHandThatStopsDeadWhoseVelocityIsAMeanOfAWhile) {
  // From 2 m/s to rest; the slope of eight positions falls to zero within 8 ms.
  PoseWatch watch;
  for (int tick = 0; tick < 100; ++tick) watch.take(at(tick, 0.002 * tick, 2.0), 0.0);
  for (int tick = 100; tick < 5000; ++tick) {
    watch.take(at(tick, 0.2, std::max(0.0, 2.0 - 0.25 * (tick - 100))), 0.0);
    ASSERT_FALSE(watch.is_frozen()) << tick;
  }
}

TEST(PoseWatch, CountsTheSecondAnewWhenThePushPauses) {
  PoseWatch watch;
  for (int tick = 0; tick < 10'000; ++tick) {
    watch.take(at(tick, 0.01), tick % 900 == 0 ? 0.0 : 5.0);
    ASSERT_FALSE(watch.is_frozen()) << tick;
  }
}

TEST(PoseWatch, BelievesNothingUntilThePoseChanges) {
  PoseWatch watch;
  int tick = 0;
  for (; tick < 1100; ++tick) watch.take(at(tick, 0.01), 5.0);
  ASSERT_TRUE(watch.is_frozen());
  for (; tick < 5000; ++tick) {
    watch.take(at(tick, 0.01), 0.0);
    ASSERT_TRUE(watch.is_frozen());
  }
  ProbeState turned = at(tick, 0.01);
  turned.orientation = glm::dquat(0.8, 0.6, 0.0, 0.0);
  watch.take(turned, 0.0);
  EXPECT_FALSE(watch.is_frozen());
}

}  // namespace
}  // namespace asperity
