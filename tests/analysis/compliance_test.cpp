// Holds bands, strokes and speeds to motions that were drawn by hand.

#include "analysis/compliance.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/random.h"

namespace asperity {
namespace {

TEST(Compliance, CountsBothBordersAsInside) {
  const std::vector<double> force_N{0.5, 1.0, 1.5, 2.0, 2.5};
  EXPECT_DOUBLE_EQ(*compliance_of(force_N, {.minimum = 1.0, .maximum = 2.0})->fraction_inside, 0.6);
  EXPECT_DOUBLE_EQ(*compliance_of(force_N, {.minimum = 1.0, .maximum = {}})->fraction_inside, 0.8);
  EXPECT_DOUBLE_EQ(*compliance_of(force_N, {.minimum = {}, .maximum = 1.0})->fraction_inside, 0.4);
  EXPECT_FALSE(compliance_of(force_N, {})->fraction_inside);
  EXPECT_DOUBLE_EQ(compliance_of(force_N, {})->summary.mean, 1.5);
}

TEST(Compliance, IsAbsentWithoutSamplesAndRefusesAnInvertedBand) {
  EXPECT_FALSE(compliance_of({}, {.minimum = 1.0, .maximum = 2.0}));
  EXPECT_THROW(compliance_of({}, {.minimum = 2.0, .maximum = 1.0}), std::invalid_argument);
  EXPECT_THROW(compliance_of({}, {.minimum = std::nan(""), .maximum = {}}), std::invalid_argument);
}

std::vector<double> through(const std::vector<double>& corners_m) {
  std::vector<double> position_m{corners_m.front()};
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    for (int step = 1; step <= 100; ++step) {
      position_m.push_back(corners_m[i - 1] + (corners_m[i] - corners_m[i - 1]) * step / 100.0);
    }
  }
  return position_m;
}

TEST(PressingForce, IsASteadyForceFromTheFirstSampleOn) {
  PressingForce pressing;
  EXPECT_DOUBLE_EQ(pressing.take(0.9, 1e-3), 0.9);
  EXPECT_DOUBLE_EQ(pressing.take(0.9, 1e-3), 0.9);
  pressing.lift();
  EXPECT_DOUBLE_EQ(pressing.take(1.5, 1e-3), 1.5);  // nothing is left of the contact before
}

// Two samples of 0.2 s: the first has lost half of its weight, so that p = (1 + 2·4) / 3 = 3.
TEST(PressingForce, ForgetsWhatIsOlderThanAFifthOfASecond) {
  PressingForce pressing;
  pressing.take(1.0, 0.2);
  EXPECT_DOUBLE_EQ(pressing.take(4.0, 0.2), 3.0);
}

TEST(Strokes, AreCutAtTurningPoints) {
  const auto strokes = strokes_along(through({0.0, 0.06, 0.01, 0.07}));
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_NEAR(strokes[0].length_m, 0.06, 1e-12);
  EXPECT_NEAR(strokes[1].length_m, -0.05, 1e-12);
  EXPECT_NEAR(strokes[2].length_m, 0.06, 1e-12);
  EXPECT_EQ(strokes[0].begin, 0U);
  EXPECT_EQ(strokes[0].end, 100U);
  EXPECT_EQ(strokes[1].begin, 100U);
  EXPECT_EQ(strokes[1].end, 200U);
  EXPECT_EQ(strokes[2].end, 300U);
}

TEST(Strokes, MayBeginBackwards) {
  const auto strokes = strokes_along(through({0.0, -0.04, 0.0}));
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_NEAR(strokes[0].length_m, -0.04, 1e-12);
  EXPECT_NEAR(strokes[1].length_m, 0.04, 1e-12);
}

// The hand backs off 2 mm before it goes, hesitates by 4 mm on the way and at the end.
TEST(Strokes, AreNotCutByHesitation) {
  const auto strokes = strokes_along(through({0.0, -0.002, 0.03, 0.026, 0.06, 0.056}));
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(strokes[0].begin, 100U);
  EXPECT_EQ(strokes[0].end, 400U);
  EXPECT_NEAR(strokes[0].length_m, 0.062, 1e-12);
}

TEST(Strokes, AreNotMultipliedByTremor) {
  Random random(1);
  std::vector<double> position_m = through({0.0, 0.06, 0.0, 0.06, 0.0});
  for (double& at_m : position_m) {
    at_m += 0.3e-3 * random.normal();
  }
  EXPECT_EQ(strokes_along(position_m).size(), 4U);
}

TEST(Strokes, NeedTheLeastLength) {
  EXPECT_TRUE(strokes_along(through({0.0, 0.0049, 0.0})).empty());
  EXPECT_EQ(strokes_along(through({0.0, 0.0051, 0.0})).size(), 2U);
  EXPECT_EQ(strokes_along(through({0.0, 0.0049, 0.0}), 0.004).size(), 2U);
  EXPECT_TRUE(strokes_along({}).empty());
}

TEST(Strokes, RefuseWhatIsNoPosition) {
  const std::vector<double> broken{0.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROW(strokes_along(broken), std::invalid_argument);
  EXPECT_THROW(strokes_along(through({0.0, 0.1}), 0.0), std::invalid_argument);
}

TEST(TangentialSpeed, LeavesOutTheMotionAlongTheNormal) {
  EXPECT_DOUBLE_EQ(tangential_speed_m_per_s({0.03, 0.04, -7.0}, {0.0, 0.0, 1.0}), 0.05);
  const double slope = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(tangential_speed_m_per_s({1.0, 0.0, 0.0}, {slope, 0.0, slope}), slope, 1e-15);
  EXPECT_NEAR(tangential_speed_m_per_s({2.0, 0.0, 2.0}, {slope, 0.0, slope}), 0.0, 1e-15);
}

}  // namespace
}  // namespace asperity
