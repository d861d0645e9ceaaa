// Holds bands, strokes and speeds to motions that were drawn by hand.

#include "analysis/signals/compliance.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

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

/// Where a hand is that goes to and fro by 50 mm, `stroke_s` there and as long back.
enum class Motion { steady, sinusoid, minimum_jerk };
double place_m(Motion motion, double time_s, double stroke_s) {
  const double strokes = time_s / stroke_s;
  const double u = strokes - std::floor(strokes);
  double way = u;
  if (motion == Motion::sinusoid) way = 0.5 - 0.5 * std::cos(std::numbers::pi * u);
  if (motion == Motion::minimum_jerk) way = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
  return 0.05 * (std::fmod(std::floor(strokes), 2.0) == 0.0 ? way : 1.0 - way);
}

// 50 mm in 1 s, three and a half times: the last one is cut off and says nothing of its speed.
TEST(HandStrokes, AreAsFastAsTheyAreLongWhateverTheHandDoesBetweenItsTurns) {
  for (const Motion motion : {Motion::steady, Motion::sinusoid, Motion::minimum_jerk}) {
    HandStrokes strokes;
    int ticks_in_band = 0;
    for (int tick = 0; tick <= 3500; ++tick) {
      const double time_s = 1e-3 * tick;
      // A texture moves the probe by 0.03 mm, 40 times a second: up to 7.5 mm/s to and fro.
      const double ripple_m = 3e-5 * std::sin(2.0 * std::numbers::pi * 40.0 * time_s);
      strokes.take(place_m(motion, time_s, 1.0) + ripple_m, 1'000'000LL * tick);
      const double speed =
          (place_m(motion, time_s + 5e-4, 1.0) - place_m(motion, time_s - 5e-4, 1.0)) / 1e-3;
      if (tick > 0 && std::abs(speed) >= 0.035 && std::abs(speed) <= 0.065) ++ticks_in_band;
    }
    const std::vector<double> speeds = strokes.speeds_m_per_s();
    ASSERT_EQ(speeds.size(), 3U);
    for (const double speed : speeds) EXPECT_NEAR(speed, 0.05, 0.003);
    ASSERT_EQ(strokes.lengths_m().size(), 4U);
    EXPECT_NEAR(strokes.lengths_m()[3], 0.025, 1e-3);
    // What ticks would have said of the same hands.
    if (motion != Motion::steady) {
      EXPECT_LT(ticks_in_band, 0.4 * 3500);
    }
  }
}

TEST(HandStrokes, CountOneThatWasCutOffOnlyWhereItsContactHasNoOther) {
  HandStrokes strokes;
  std::int64_t time_ns = 0;
  const auto stroke_to = [&](double from_m, double to_m) {  // in 1 s
    for (int i = 0; i <= 1000; ++i) {
      strokes.take(from_m + (to_m - from_m) * i / 1000.0, time_ns += 1'000'000);
    }
  };
  stroke_to(0.0, 0.03);
  ASSERT_EQ(strokes.speeds_m_per_s().size(), 1U);
  EXPECT_NEAR(strokes.speeds_m_per_s()[0], 0.03, 1e-9);
  strokes.lift();
  stroke_to(0.0, 0.05);
  stroke_to(0.05, 0.03);
  EXPECT_EQ(strokes.lengths_m().size(), 3U);
  ASSERT_EQ(strokes.speeds_m_per_s().size(), 2U);
  EXPECT_NEAR(strokes.speeds_m_per_s()[1], 0.05, 1e-4);
  strokes.lift();
  EXPECT_EQ(strokes.lengths_m().size(), 3U);
  EXPECT_EQ(strokes.speeds_m_per_s().size(), 2U);
}

// A rest where the hand turns belongs to the stroke that follows.
TEST(HandStrokes, CountARestAtATurnAsSlow) {
  HandStrokes strokes;
  std::int64_t time_ns = 0;
  const auto at = [&](double place) { strokes.take(place, time_ns += 1'000'000); };
  for (int i = 0; i <= 500; ++i) at(1e-4 * i);
  for (int i = 0; i < 500; ++i) at(0.05);
  for (int i = 0; i <= 500; ++i) at(0.05 - 1e-4 * i);
  for (int i = 0; i <= 100; ++i) at(1e-4 * i);
  ASSERT_EQ(strokes.speeds_m_per_s().size(), 2U);
  EXPECT_NEAR(strokes.speeds_m_per_s()[0], 0.1, 1e-3);
  EXPECT_NEAR(strokes.speeds_m_per_s()[1], 0.05, 1e-3);
}

// 50 mm in 1 s. Of the first stroke nobody knows how it will end; those that follow go on as it did.
TEST(HandStrokes, TellAHandThatSlowsDownAtItsTurnsNothingElseThanTheirMean) {
  for (const Motion motion : {Motion::sinusoid, Motion::minimum_jerk}) {
    HandStrokes strokes(0.05);
    double most_of_first = 0.0;
    for (int tick = 0; tick <= 5000; ++tick) {
      strokes.take(place_m(motion, 1e-3 * tick, 1.0), 1'000'000LL * tick);
      const auto told = strokes.speed_to_tell_m_per_s();
      if (std::abs(tick - 500) > 1) {
        EXPECT_EQ(told.has_value(), tick > 500) << tick;
      }
      if (!told) continue;
      EXPECT_GT(*told, 0.05 * 0.995) << tick;
      if (tick <= 1000) {
        most_of_first = std::max(most_of_first, *told);
      } else {
        EXPECT_LT(*told, 0.05 * 1.005) << tick;
      }
    }
    EXPECT_LT(most_of_first, 0.05 * (motion == Motion::sinusoid ? 8.0 / 7.0 : 1.2));
  }
}

// As the last stroke, in half the time: twice as fast from its half on, and no less at its end.
TEST(HandStrokes, TellAHandThatChangesItsPaceFromTheHalfOfAStrokeOn) {
  HandStrokes strokes(0.05);
  const auto way = [](double u) { return u * u * u * (10.0 - 15.0 * u + 6.0 * u * u); };
  std::int64_t time_ns = 0;
  for (int i = 0; i <= 1000; ++i) strokes.take(0.05 * way(1e-3 * i), time_ns += 1'000'000);
  for (int i = 1; i <= 1000; ++i) {  // back and forth
    strokes.take(0.05 * way(i <= 500 ? 1.0 - 2e-3 * i : 2e-3 * i - 1.0), time_ns += 1'000'000);
    if (i == 250) continue;  // half-way
    EXPECT_NEAR(strokes.speed_to_tell_m_per_s().value(), i < 250 ? 0.05 : 0.1, 0.001) << i;
  }
}

// 50 mm in 1 s each, some after half a second at the turn, which belongs to the stroke that follows:
// neither the last one's rest nor the missing of one makes another faster or slower than it is.
TEST(HandStrokes, TellAHandThatRestsAtSomeOfItsTurnsNoOtherSpeedThanItHas) {
  HandStrokes strokes(0.05);
  std::int64_t time_ns = 0;
  strokes.take(0.0, time_ns);
  bool is_forth = true;
  int told = 0;
  for (const int rest_ms : {0, 500, 0, 0, 500, 500, 0}) {
    const double from_m = is_forth ? 0.0 : 0.05;
    const double to_m = 0.05 - from_m;
    for (int i = 0; i < rest_ms; ++i) strokes.take(from_m, time_ns += 1'000'000);
    for (int i = 1; i <= 1000; ++i) {
      strokes.take(from_m + (to_m - from_m) * i / 1000.0, time_ns += 1'000'000);
      if (i <= 502) continue;  // half-way
      ++told;
      EXPECT_NEAR(strokes.speed_to_tell_m_per_s().value(), 0.05 / (1.0 + 1e-3 * rest_ms), 5e-4)
          << rest_ms << ' ' << i;
    }
    is_forth = !is_forth;
  }
  EXPECT_EQ(told, 7 * 498);
}

// A stroke is told as what it is where the last one says nothing of it: farther than that went, and in
// another contact.
TEST(HandStrokes, TellAHandThatContinuesAsNeverBeforeWhatItDoes) {
  HandStrokes strokes(0.05);
  std::int64_t time_ns = 0;
  for (int i = 0; i <= 500; ++i)
    strokes.take(2e-7 * i * i, time_ns += 1'000'000);  // faster and faster
  for (int i = 1; i <= 800; ++i) {
    strokes.take(0.05 - 1e-4 * i, time_ns += 1'000'000);
    if (i > 500) {
      EXPECT_NEAR(strokes.speed_to_tell_m_per_s().value(), 0.1, 1e-3) << i;
    }
  }
  strokes.lift();
  for (int i = 0; i <= 400; ++i) {
    strokes.take(1e-4 * i, time_ns += 1'000'000);
    const std::optional<double> told = strokes.speed_to_tell_m_per_s();
    if (i == 250) continue;  // half of what is usual
    EXPECT_EQ(told.has_value(), i > 250) << i;
    if (told) {
      EXPECT_NEAR(*told, 0.1, 1e-9) << i;
    }
  }
}

TEST(HandStrokes, TellAHandThatRestsThatItDoes) {
  HandStrokes strokes(0.05);
  for (int tick = 0; tick <= 750; ++tick) {
    strokes.take(0.001, 1'000'000LL * tick);
    EXPECT_FALSE(strokes.speed_to_tell_m_per_s());
  }
  strokes.take(0.001, 751'000'000);
  EXPECT_EQ(strokes.speed_to_tell_m_per_s(), 0.0);
}

TEST(TangentialSpeed, LeavesOutTheMotionAlongTheNormal) {
  EXPECT_DOUBLE_EQ(tangential_speed_m_per_s({0.03, 0.04, -7.0}, {0.0, 0.0, 1.0}), 0.05);
  const double slope = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(tangential_speed_m_per_s({1.0, 0.0, 0.0}, {slope, 0.0, slope}), slope, 1e-15);
  EXPECT_NEAR(tangential_speed_m_per_s({2.0, 0.0, 2.0}, {slope, 0.0, slope}), 0.0, 1e-15);
}

}  // namespace
}  // namespace asperity
