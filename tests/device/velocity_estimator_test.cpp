// The velocity estimate, its lag and its noise against closed forms.

#include "device/velocity_estimator.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kTick_s = 1e-3;

TEST(VelocityEstimator, IsExactAtConstantVelocityHoweverIrregularTheReadings) {
  VelocityEstimator estimator({.samples = 8});
  const glm::dvec3 velocity(0.1, -0.02, 0.3);
  std::int64_t time_ns = 5'000'000'000'000;
  const std::int64_t first_ns = time_ns;
  for (int i = 0; i < 40; ++i) {
    const auto position =
        glm::dvec3(0.3) + 1e-9 * static_cast<double>(time_ns - first_ns) * velocity;
    const glm::dvec3 estimate = estimator.add(time_ns, position);
    if (i > 0) {
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(estimate[axis], velocity[axis], 1e-10);
    }
    time_ns += kTick_ns * (1 + i % 5) / 2;
  }
}

TEST(VelocityEstimator, LagsByHalfItsWindow) {
  // x = t²/2 · 3: v = 3 t. The estimate is the velocity lag_s ago.
  for (const int samples : {2, 8, 13}) {
    const VelocityWindow window{.samples = samples};
    VelocityEstimator estimator(window);
    glm::dvec3 estimate{0.0};
    double time_s = 0.0;
    for (int i = 0; i < 100; ++i) {
      time_s = i * kTick_s;
      estimate = estimator.add(i * kTick_ns, {1.5 * time_s * time_s, 0.0, 0.0});
    }
    EXPECT_NEAR(estimate.x, 3.0 * (time_s - window.lag_s(kTick_s)), 1e-9);
  }
  EXPECT_DOUBLE_EQ(VelocityWindow{.samples = 8}.lag_s(kTick_s), 3.5e-3);
}

TEST(VelocityEstimator, IsAsNoisyAsDeclared) {
  constexpr double kNoise_m = 11e-6;
  for (const int samples : {2, 8, 20}) {
    const VelocityWindow window{.samples = samples};
    VelocityEstimator estimator(window);
    Random random(7);
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < 60000; ++i) {
      const glm::dvec3 estimate =
          estimator.add(i * kTick_ns, {kNoise_m * random.normal(), 0.0, 0.0});
      if (i >= samples) {
        sum += estimate.x * estimate.x;
        ++count;
      }
    }
    const double declared = window.noise_m_per_s(kNoise_m, kTick_s);
    EXPECT_NEAR(std::sqrt(sum / count) / declared, 1.0, 0.03) << samples;
  }
  // Two readings: the difference of two errors over one period.
  EXPECT_NEAR(VelocityWindow{.samples = 2}.noise_m_per_s(1e-6, kTick_s), std::sqrt(2.0) * 1e-3,
              1e-12);
}

TEST(VelocityEstimator, StartsAgainAfterAReset) {
  VelocityEstimator estimator({.samples = 4});
  for (int i = 0; i < 9; ++i) estimator.add(i * kTick_ns, {0.001 * i, 0.0, 0.0});
  estimator.reset();
  EXPECT_EQ(estimator.add(100 * kTick_ns, {9.0, 0.0, 0.0}).x, 0.0);
  EXPECT_NEAR(estimator.add(101 * kTick_ns, {9.002, 0.0, 0.0}).x, 2.0, 1e-9);
}

TEST(VelocityEstimator, LeavesOutAReadingThatImpliesASpeedThatNoHandHas) {
  // 0.2 m/s; one reading is 25 mm off, which would be 2 m/s in the slope of eight.
  VelocityEstimator estimator({.samples = 8});
  for (int i = 0; i < 60; ++i) {
    const bool is_wild = i == 30;
    const double x_m_per_s =
        estimator.add(i * kTick_ns, {0.0002 * i + (is_wild ? 0.025 : 0.0), 0.0, 0.0}).x;
    if (i > 0) {
      EXPECT_NEAR(x_m_per_s, 0.2, 1e-9) << i;
    }
  }
}

TEST(VelocityEstimator, BeginsAnewAfterAJumpThatLasts) {
  VelocityEstimator estimator({.samples = 8});
  for (int i = 0; i < 30; ++i) estimator.add(i * kTick_ns, {0.0002 * i, 0.0, 0.0});
  for (int i = 30; i < 60; ++i) {
    const double x_m_per_s = estimator.add(i * kTick_ns, {0.1, 0.0, 0.0}).x;
    EXPECT_NEAR(x_m_per_s, i < 32 ? 0.2 : 0.0, 1e-9) << i;
  }
}

TEST(VelocityEstimator, CountsNoReadingTwice) {
  VelocityEstimator estimator({.samples = 4});
  estimator.add(0, {0.0, 0.0, 0.0});
  const double before = estimator.add(kTick_ns, {0.001, 0.0, 0.0}).x;
  EXPECT_EQ(estimator.add(kTick_ns, {0.5, 0.0, 0.0}).x, before);
  EXPECT_EQ(estimator.add(0, {0.5, 0.0, 0.0}).x, before);
}

TEST(VelocityEstimator, RefusesAWindowThatIsNone) {
  EXPECT_THROW(VelocityEstimator({.samples = 1}), std::invalid_argument);
  EXPECT_THROW(VelocityEstimator({.samples = 65}), std::invalid_argument);
}

TEST(VelocityEstimator, DoesNotTouchTheHeap) {
  VelocityEstimator estimator({.samples = 8});
  AllocationGuard guard;
  for (int i = 0; i < 20; ++i) estimator.add(i * kTick_ns, {0.001 * i, 0.0, 0.0});
  estimator.reset();
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
