// What a Falcon's answers say.

#include "device/falcon/falcon_readings.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/device/falcon_arm_angles.h"
#include "tests/device/ticks.h"

namespace asperity::falcon {
namespace {

Answer at(const glm::dvec3& grip_m) { return {.counts = counts_at(grip_m), .homed_motors = 0b111}; }

TEST(FalconReadings, TellPlaceVelocityAndButtons) {
  Readings readings({.samples = 8});
  std::optional<Reading> reading;
  // 0.2 m/s along z, for long enough that counts of 40 µm average out.
  for (int i = 0; i <= 100; ++i) {
    Answer answer = at({0.010, -0.005, 0.100 + 0.0002 * i});
    answer.buttons = 0b1000;
    reading = readings.take(answer, i * kTick_ns);
    ASSERT_TRUE(reading.has_value()) << i;
  }
  EXPECT_EQ(reading->time_ns, 100 * kTick_ns);
  EXPECT_LT(glm::distance(reading->position_m, glm::dvec3(0.010, -0.005, 0.120)), 50e-6);
  EXPECT_NEAR(reading->velocity_m_per_s.z, 0.2, 0.01);
  EXPECT_EQ(reading->buttons, 0b1000U);
  EXPECT_TRUE(reading->is_homed);
}

// The servo loop judges the place (servo_steps_test.cpp).
TEST(FalconReadings, KeepAWildPlaceOutOfTheVelocity) {
  Readings readings({});
  const auto place_m = [](int i) { return glm::dvec3{0.0, 0.0, 0.115 + 0.0002 * i}; };
  glm::dvec3 before_m_per_s{0.0};
  for (int i = 0; i < 30; ++i) {
    before_m_per_s = readings.take(at(place_m(i)), i * kTick_ns).value().velocity_m_per_s;
  }
  const auto wild = readings.take(at({0.020, 0.0, 0.115}), 30 * kTick_ns);
  EXPECT_NEAR(wild.value().position_m.x, 0.020, 50e-6);
  EXPECT_EQ(wild->velocity_m_per_s, before_m_per_s);
  const auto next = readings.take(at(place_m(31)), 31 * kTick_ns);
  EXPECT_NEAR(next.value().velocity_m_per_s.z, 0.2, 0.02);
  EXPECT_NEAR(next->velocity_m_per_s.x, 0.0, 0.02);
}

// Bit 11 of one encoder flips on the wire. Torques from these angles would push in another direction.
TEST(FalconReadings, KeepTheLastPlausiblePoseForTheTorques) {
  const glm::dvec3 place_m(0.002, -0.001, 0.115);
  const glm::dvec3 wanted_N(1.0, 0.0, 2.0);
  const auto torques_of = [&](const Reading& reading) {
    return torques_N_m(reading.plausible.angles, reading.plausible.position_m, wanted_N).value();
  };
  for (std::size_t encoder = 0; encoder < 3; ++encoder) {
    Readings readings({});
    glm::dvec3 before{0.0};
    for (int i = 0; i < 30; ++i) {
      before = torques_of(readings.take(at(place_m), i * kTick_ns).value());
    }
    Answer wild = at(place_m);
    wild.counts[encoder] = static_cast<std::int16_t>(wild.counts[encoder] ^ (1 << 11));
    const auto reading = readings.take(wild, 30 * kTick_ns);
    if (!reading) continue;  // the legs do not meet there
    EXPECT_GT(glm::distance(reading->position_m, place_m), 0.005);
    EXPECT_EQ(torques_of(*reading), before) << encoder;
    EXPECT_EQ(torques_of(readings.take(at(place_m), 31 * kTick_ns).value()), before);
  }
}

// The servo loop has latched its fault after 2 ms; once a person has cleared it, the place is the true one.
TEST(FalconReadings, KeepAPoseForFiftyMilliseconds) {
  Readings readings({});
  const auto old = readings.take(at({0.0, 0.0, 0.115}), 0);
  for (int i = 1; i <= 60; ++i) {
    const auto reading = readings.take(at({0.020, 0.0, 0.115}), i * kTick_ns);
    EXPECT_EQ(reading.value().plausible.position_m,
              i <= 50 ? old.value().position_m : reading->position_m)
        << i;
  }
  // Homing moves the zero: nothing of before is kept.
  readings.take({.counts = {-900, -900, -900}}, 61 * kTick_ns);
  const auto homed = readings.take(at({-0.020, 0.0, 0.115}), 62 * kTick_ns);
  EXPECT_EQ(homed.value().plausible.position_m, homed->position_m);
}

TEST(FalconReadings, TakeAJumpThatLastsForTheBeginningOfAnotherMotion) {
  // An encoder that gained counts: 20 mm within a millisecond, permanently. Nothing moved there.
  Readings readings({});
  ASSERT_TRUE(readings.take(at({0.0, 0.0, 0.115}), 0));
  for (int i = 1; i < 500; ++i) {
    const auto reading = readings.take(at({0.020, 0.0, 0.115}), i * kTick_ns);
    ASSERT_LT(glm::length(reading.value().velocity_m_per_s), 1e-9) << i;
  }
}

TEST(FalconReadings, FollowAHandThatMovedWhileNothingWasHeard) {
  // 20 mm in 30 ms.
  Readings readings({});
  ASSERT_TRUE(readings.take(at({0.0, 0.0, 0.115}), 0));
  const auto reading = readings.take(at({0.020, 0.0, 0.115}), 30 * kTick_ns);
  EXPECT_NEAR(reading.value().velocity_m_per_s.x, 0.020 / 0.030, 0.01);
}

TEST(FalconReadings, NeverTellOfAPlaceThatIsNoNumber) {
  Random random(3);
  int none = 0;
  Readings readings({});
  for (int i = 0; i < 2000; ++i) {
    Answer answer{.homed_motors = 0b111};
    for (std::int16_t& count : answer.counts) {
      count = static_cast<std::int16_t>(65536.0 * random.uniform() - 32768.0);
    }
    const auto reading = readings.take(answer, i * 1'000 * kTick_ns);
    if (!reading) {
      ++none;
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(std::isfinite(reading->position_m[axis]));
      ASSERT_TRUE(std::isfinite(reading->velocity_m_per_s[axis]));
    }
  }
  EXPECT_GT(none, 100);
}

TEST(FalconReadings, BeginAgainWhenHomingMovesTheZero) {
  Readings readings({});
  Answer answer{.counts = {-900, -900, -900}};
  ASSERT_TRUE(readings.take(answer, 0).has_value());
  EXPECT_FALSE(readings.is_homed());
  const auto homed = readings.take(at({0.0, 0.0, 0.115}), kTick_ns);
  ASSERT_TRUE(homed.has_value());
  EXPECT_TRUE(readings.is_homed());
  EXPECT_EQ(glm::length(homed->velocity_m_per_s), 0.0);
}

}  // namespace
}  // namespace asperity::falcon
