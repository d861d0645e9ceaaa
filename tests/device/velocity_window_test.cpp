// Velocity from positions, and turns from orientations, against closed forms.

#include "device/velocity_window.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/random.h"
#include "device/small_turn.h"

namespace asperity {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

TEST(VelocityWindow, FindsAConstantVelocityAtUnevenTimes) {
  VelocityWindow window;
  const glm::dvec3 velocity_m_per_s(0.1, -0.02, 0.003);
  std::int64_t time_ns = 5'000'000'000'000;
  EXPECT_EQ(window.next(time_ns, {0.3, 0.2, 0.1}), glm::dvec3(0.0));
  double elapsed_s = 0.0;
  for (int i = 1; i < 40; ++i) {
    const std::int64_t step_ns = (1 + i % 3) * kMillisecond_ns;
    time_ns += step_ns;
    elapsed_s += 1e-9 * static_cast<double>(step_ns);
    const glm::dvec3 found =
        window.next(time_ns, glm::dvec3(0.3, 0.2, 0.1) + elapsed_s * velocity_m_per_s);
    EXPECT_NEAR(glm::distance(found, velocity_m_per_s), 0.0, 1e-12);
  }
}

// A parabola's slope over five even readings is that of its middle: two periods ago.
TEST(VelocityWindow, LagsByTwoPeriods) {
  VelocityWindow window;
  double found_m_per_s = 0.0;
  for (int i = 0; i <= 30; ++i) {
    const double time_s = 1e-3 * i;
    found_m_per_s = window.next(i * kMillisecond_ns, {0.5 * 3.0 * time_s * time_s, 0.0, 0.0}).x;
  }
  EXPECT_NEAR(found_m_per_s, 3.0 * 0.028, 1e-12);
}

TEST(VelocityWindow, MakesOfPositionNoiseWhatItDeclares) {
  VelocityWindow window;
  Random random(17);
  constexpr double kNoise_m = 1e-5;
  double sum = 0.0;
  constexpr int kCount = 40'000;
  for (int i = 0; i < kCount; ++i) {
    const double v = window.next(i * kMillisecond_ns, {kNoise_m * random.normal(), 0.0, 0.0}).x;
    sum += v * v;
  }
  EXPECT_NEAR(std::sqrt(sum / kCount), kNoise_m * 316.2, 0.02 * kNoise_m * 316.2);
}

TEST(VelocityWindow, LeavesOutAReadingOfTheSameTime) {
  VelocityWindow window;
  window.next(0, {0.0, 0.0, 0.0});
  window.next(kMillisecond_ns, {0.001, 0.0, 0.0});
  EXPECT_NEAR(window.next(kMillisecond_ns, {7.0, 0.0, 0.0}).x, 1.0, 1e-12);
  window.reset();
  EXPECT_EQ(window.next(2 * kMillisecond_ns, {7.0, 0.0, 0.0}), glm::dvec3(0.0));
}

TEST(SmallTurn, IsTheVectorThatTurnsOneIntoTheOther) {
  const glm::dquat from = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1.0, 2.0, -1.0)));
  for (const double angle_rad : {1e-13, 1e-6, 0.3, 3.0}) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, -1.0, 0.5));
    const glm::dquat to = glm::angleAxis(angle_rad, axis) * from;
    EXPECT_NEAR(glm::distance(small_turn_rad(from, to), angle_rad * axis), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(small_turn_rad(from, -to), angle_rad * axis), 0.0, 1e-12);
  }
  EXPECT_EQ(small_turn_rad(from, from), glm::dvec3(0.0));
}

}  // namespace
}  // namespace asperity
