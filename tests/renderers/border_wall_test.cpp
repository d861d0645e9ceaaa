// The wall of a patch: where it stands, its steps and its work.

#include "renderers/force/border_wall.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

constexpr double kWall_N_per_m = 500.0;

double force_N(BorderWall& wall, double beyond_m) {
  return wall.force_N({beyond_m, 0.0}, kWall_N_per_m).x;
}

TEST(BorderWall, IsASpringAtTheBorderForAContactThatBeganInside) {
  BorderWall wall;
  EXPECT_EQ(force_N(wall, 0.0), 0.0);
  EXPECT_NEAR(force_N(wall, 0.002), -1.0, 1e-12);
  EXPECT_NEAR(force_N(wall, 0.001), -0.5, 1e-12);
  EXPECT_NEAR(force_N(wall, -0.003), 1.5, 1e-12);
}

TEST(BorderWall, StandsWhereContactBeganAndFollowsTheHandInwards) {
  BorderWall wall;
  EXPECT_EQ(force_N(wall, 0.005), 0.0);  // touches down 5 mm outside
  EXPECT_NEAR(force_N(wall, 0.007), -1.0, 1e-12);
  EXPECT_EQ(force_N(wall, 0.004), 0.0);
  EXPECT_NEAR(force_N(wall, 0.005), -0.5, 1e-12);
  EXPECT_EQ(force_N(wall, 0.0), 0.0);  // from inside on it is the border
  EXPECT_NEAR(force_N(wall, 0.001), -0.5, 1e-12);
}

TEST(BorderWall, StandsAtTheOtherBorderForAHandThatCrossesThePatchInATick) {
  BorderWall wall;
  EXPECT_EQ(force_N(wall, 0.005), 0.0);
  EXPECT_NEAR(force_N(wall, -0.002), 1.0, 1e-12);
  EXPECT_NEAR(force_N(wall, 0.003), -1.5, 1e-12);
}

TEST(BorderWall, BeginsAnewWithEachContact) {
  BorderWall wall;
  EXPECT_EQ(force_N(wall, 0.0), 0.0);
  EXPECT_NEAR(force_N(wall, 0.004), -2.0, 1e-12);
  wall.release();
  EXPECT_EQ(force_N(wall, 0.004), 0.0);
}

TEST(BorderWall, ActsAlongEachAxisAlone) {
  BorderWall wall;
  EXPECT_EQ(wall.force_N({0.002, 0.0}, kWall_N_per_m), glm::dvec2(0.0));
  const glm::dvec2 found_N = wall.force_N({0.003, -0.004}, kWall_N_per_m);
  EXPECT_NEAR(found_N.x, -0.5, 1e-12);
  EXPECT_NEAR(found_N.y, 2.0, 1e-12);
}

// On paths that cross both borders in steps of up to 1 mm, and in jumps.
TEST(BorderWall, HasNoStepBeyondThatOfASpring) {
  Random random(20260101);
  for (int contact = 0; contact < 200; ++contact) {
    BorderWall wall;
    double beyond_m = 0.02 * (random.uniform() - 0.5);
    double last_N = force_N(wall, beyond_m);
    EXPECT_EQ(last_N, 0.0);
    for (int tick = 0; tick < 2000; ++tick) {
      const double reach_m = random.below(50) == 0 ? 0.03 : 0.001;
      const double moved_m = reach_m * (2.0 * random.uniform() - 1.0) - 0.01 * beyond_m;
      beyond_m += moved_m;
      const double now_N = force_N(wall, beyond_m);
      ASSERT_LE(std::abs(now_N - last_N), kWall_N_per_m * std::abs(moved_m) + 1e-12);
      last_N = now_N;
    }
  }
}

// To and fro with two frequencies, from any phase: up to 16 mJ are stored and returned. In a step d in which the wall begins to
// follow the hand, the trapezoid of the forces is up to k·d²/8 too large: 1 nJ for the 4 µm of these paths.
TEST(BorderWall, GivesNoEnergyToAHandThatTouchedAnywhere) {
  Random random(7);
  for (int contact = 0; contact < 50; ++contact) {
    const double slow_rad = 2.0 * std::numbers::pi * random.uniform();
    const double fast_rad = 2.0 * std::numbers::pi * random.uniform();
    const auto beyond_at_m = [&](int step) {
      const double angle_rad = 2.0 * std::numbers::pi * step / 20'000.0;
      return 0.008 * std::sin(angle_rad + slow_rad) + 0.005 * std::sin(2.7 * angle_rad + fast_rad);
    };
    BorderWall wall;
    double beyond_m = beyond_at_m(0);
    double last_N = force_N(wall, beyond_m);
    double work_J = 0.0;
    double gross_J = 0.0;
    for (int step = 1; step < 40'000; ++step) {
      const double moved_m = beyond_at_m(step) - beyond_m;
      beyond_m += moved_m;
      const double now_N = force_N(wall, beyond_m);
      work_J += 0.5 * (last_N + now_N) * moved_m;
      gross_J += std::abs(0.5 * (last_N + now_N) * moved_m);
      ASSERT_LE(work_J, 1e-8) << contact << ' ' << step;
      last_N = now_N;
    }
    EXPECT_GT(gross_J, 1e-3) << contact;  // the wall was met
  }
}

}  // namespace
}  // namespace asperity
