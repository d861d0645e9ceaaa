// What a sensor makes of a hand whose motion is known.

#include "device/imperfect_sensor.h"

#include <cmath>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr glm::dvec3 kVelocity_m_per_s{0.1, -0.05, 0.02};

// A hand at constant velocity, after `time_ns`.
ProbeState hand_at(std::int64_t time_ns) {
  return {.time_ns = time_ns,
          .position_m = 1e-9 * static_cast<double>(time_ns) * kVelocity_m_per_s,
          .velocity_m_per_s = kVelocity_m_per_s,
          .buttons = static_cast<std::uint32_t>(time_ns / 1'000'000 % 2)};
}

TEST(ImperfectSensor, PassesTheHandOnUnchangedByDefault) {
  ImperfectSensor sensor({});
  for (int tick = 0; tick < 10; ++tick) {
    const ProbeState hand = hand_at(1'000'000 * tick);
    const ProbeState read = sensor.read(hand);
    EXPECT_EQ(read.time_ns, hand.time_ns);
    EXPECT_EQ(read.position_m, hand.position_m);
    EXPECT_EQ(read.velocity_m_per_s, hand.velocity_m_per_s);
    EXPECT_EQ(read.buttons, hand.buttons);
  }
}

TEST(ImperfectSensor, IsLateByTheLatencyAtAnyRate) {
  for (const double latency_s : {0.0001, 0.001, 0.00237, 0.05}) {
    for (const std::int64_t period_ns : {100'000, 1'000'000, 2'100'000}) {
      ImperfectSensor sensor({.latency_s = latency_s});
      for (std::int64_t time_ns = 0; time_ns < 200'000'000; time_ns += period_ns) {
        const ProbeState read = sensor.read(hand_at(time_ns));
        const double since_s = std::max(0.0, 1e-9 * static_cast<double>(time_ns) - latency_s);
        ASSERT_EQ(read.time_ns, time_ns);
        ASSERT_NEAR(read.position_m.x, since_s * kVelocity_m_per_s.x, 1e-12);
        ASSERT_NEAR(read.position_m.z, since_s * kVelocity_m_per_s.z, 1e-12);
      }
    }
  }
}

TEST(ImperfectSensor, ReadsTheSameTimeTwiceWithoutForgetting) {
  ImperfectSensor sensor({.latency_s = 0.002});
  for (int tick = 0; tick < 10; ++tick) {
    const double once_m = sensor.read(hand_at(1'000'000 * tick)).position_m.x;
    EXPECT_EQ(sensor.read(hand_at(1'000'000 * tick)).position_m.x, once_m);
  }
}

TEST(ImperfectSensor, GivesMultiplesOfItsStepNoFartherThanHalfOfOne) {
  constexpr double kStep_m = 38e-6;
  ImperfectSensor sensor({.position_step_m = kStep_m});
  for (int tick = 0; tick < 1000; ++tick) {
    const ProbeState hand = hand_at(1'000'000 * tick);
    const ProbeState read = sensor.read(hand);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(read.position_m[axis], kStep_m * std::round(read.position_m[axis] / kStep_m));
      ASSERT_NEAR(read.position_m[axis], hand.position_m[axis], 0.5 * kStep_m + 1e-15);
    }
  }
}

// Root mean square of 3 n independent errors of deviation σ: σ, within 4 standard errors σ/√(6n).
TEST(ImperfectSensor, HasNoiseOfTheDeviationThatWasDeclared) {
  constexpr double kNoise_m = 5e-6;
  constexpr int kReadings = 20'000;
  ImperfectSensor sensor({.position_noise_m = kNoise_m, .noise_seed = 3});
  double squares_m2 = 0.0;
  glm::dvec3 sum_m{0.0};
  for (int tick = 0; tick < kReadings; ++tick) {
    const glm::dvec3 error_m = sensor.read({.time_ns = 1'000'000LL * tick}).position_m;
    squares_m2 += error_m.x * error_m.x + error_m.y * error_m.y + error_m.z * error_m.z;
    sum_m += error_m;
  }
  EXPECT_NEAR(std::sqrt(squares_m2 / (3 * kReadings)), kNoise_m,
              4.0 * kNoise_m / std::sqrt(6.0 * kReadings));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum_m[axis] / kReadings, 0.0, 4.0 * kNoise_m / std::sqrt(kReadings));
  }
}

TEST(ImperfectSensor, EstimatesVelocityFromWhatItReads) {
  const SensorSettings settings{.position_step_m = 38e-6, .velocity = VelocityWindow{.samples = 8}};
  ImperfectSensor sensor(settings);
  VelocityEstimator estimator(*settings.velocity);
  double farthest_m_per_s = 0.0;
  for (int tick = 0; tick < 500; ++tick) {
    const ProbeState read = sensor.read(hand_at(1'000'000 * tick));
    ASSERT_EQ(read.velocity_m_per_s, estimator.add(read.time_ns, read.position_m));
    if (tick < 8) continue;
    farthest_m_per_s =
        std::max(farthest_m_per_s, std::abs(read.velocity_m_per_s.x - kVelocity_m_per_s.x));
  }
  EXPECT_GT(farthest_m_per_s, 0.0);
  EXPECT_LT(farthest_m_per_s,
            4.0 * settings.velocity->noise_m_per_s(38e-6 / std::sqrt(12.0), 1e-3));
}

}  // namespace
}  // namespace asperity
