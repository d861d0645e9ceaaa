// Which readings of the hand are plausible, and for how long others are held.

#include "device/reading_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Verdict = ReadingCheck::Verdict;
using Origin = ReadingCheck::Origin;

ProbeState reading_at(std::int64_t time_ns, double x_m) {
  ProbeState state{};
  state.time_ns = time_ns;
  state.position_m.x = x_m;
  return state;
}

ProbeState turned_reading(std::int64_t time_ns, double angle_rad) {
  ProbeState state = reading_at(time_ns, 0.0);
  state.orientation = {std::cos(0.5 * angle_rad), std::sin(0.5 * angle_rad), 0.0, 0.0};
  return state;
}

class ReadingCheckTest : public testing::TestWithParam<double> {
 protected:
  std::int64_t period_ns() const { return std::llround(1e9 / GetParam()); }
  // The first reading at which the answer is not `plausible`, of a motion at this speed.
  bool accepts_speed(double speed_m_per_s) const {
    ReadingCheck check(5.0);
    for (std::int64_t i = 0; i < 100; ++i) {
      const double x_m = speed_m_per_s * 1e-9 * static_cast<double>(i * period_ns());
      if (check.judge(reading_at(i * period_ns(), x_m), Origin::fresh) != Verdict::plausible)
        return false;
    }
    return true;
  }
};

TEST_P(ReadingCheckTest, AcceptsASteadyMotionUpToTheSpeedOfTheDevice) {
  EXPECT_TRUE(accepts_speed(4.9));
  EXPECT_FALSE(accepts_speed(5.6));
  EXPECT_FALSE(accepts_speed(20.0));
}

// One position step of 38 µm within a tick is 0.15 m/s at 4 kHz; a coarse sensor's 1 mm would be 4 m/s at 4 kHz.
TEST_P(ReadingCheckTest, DoesNotTakeAPositionStepForASpeed) {
  ReadingCheck check(5.0);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(check.judge(reading_at(i * period_ns(), i % 2 == 0 ? 0.0 : 0.0045), Origin::fresh),
              Verdict::plausible);
  }
}

TEST_P(ReadingCheckTest, HoldsAJumpForLessThanTwoMillisecondsAndThenLosesTheDevice) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  for (int i = 0; i < 50; ++i) check.judge(reading_at(now_ns += period_ns(), 0.0), Origin::fresh);
  const std::int64_t jumped_ns = now_ns + period_ns();
  for (int i = 0; i < 20; ++i) {
    now_ns += period_ns();
    EXPECT_EQ(check.judge(reading_at(now_ns, 0.5), Origin::fresh),
              now_ns - jumped_ns < 2'000'000 ? Verdict::held : Verdict::lost);
  }
}

TEST_P(ReadingCheckTest, ResumesAfterOneWildReading) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  for (int i = 0; i < 50; ++i) check.judge(reading_at(now_ns += period_ns(), 0.0), Origin::fresh);
  EXPECT_EQ(check.judge(reading_at(now_ns += period_ns(), 0.025), Origin::fresh), Verdict::held);
  EXPECT_EQ(check.judge(reading_at(now_ns += period_ns(), 0.0), Origin::fresh), Verdict::plausible);
  // The next one is held anew for its own 2 ms.
  EXPECT_EQ(check.judge(reading_at(now_ns += 3'000'000, 0.0), Origin::fresh), Verdict::plausible);
  EXPECT_EQ(check.judge(reading_at(now_ns += period_ns(), 0.025), Origin::fresh), Verdict::held);
}

// Above 5 mm, or above what 5 m/s are in a longer period, a position that has jumped for good is never accepted.
TEST_P(ReadingCheckTest, NeverAcceptsAJumpThatLasts) {
  const double period_s = 1e-9 * static_cast<double>(period_ns());
  for (const double jump_m : {0.0049, 0.006, 0.009, 0.011, 0.015, 0.019}) {
    ReadingCheck check(5.0);
    std::int64_t now_ns = 0;
    for (int i = 0; i < 50; ++i) check.judge(reading_at(now_ns += period_ns(), 0.0), Origin::fresh);
    const bool is_plausible = jump_m < 5.0 * std::max(1e-3, period_s);
    const std::int64_t jumped_ns = now_ns + period_ns();
    while (now_ns < jumped_ns + 100'000'000) {
      now_ns += period_ns();
      const Verdict verdict = check.judge(reading_at(now_ns, jump_m), Origin::fresh);
      ASSERT_EQ(verdict, is_plausible                     ? Verdict::plausible
                         : now_ns - jumped_ns < 2'000'000 ? Verdict::held
                                                          : Verdict::lost)
          << jump_m << ' ' << now_ns - jumped_ns;
    }
  }
}

// A hand at 1 m/s whose readings are wild for almost 2 ms.
TEST_P(ReadingCheckTest, ResumesWhereAMovingHandHasMovedMeanwhile) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  const auto x_m = [&] { return 1e-9 * static_cast<double>(now_ns); };
  for (int i = 0; i < 50; ++i) {
    now_ns += period_ns();
    check.judge(reading_at(now_ns, x_m()), Origin::fresh);
  }
  const std::int64_t wild_ns = now_ns + period_ns();
  while (now_ns + period_ns() - wild_ns < 2'000'000) {
    now_ns += period_ns();
    ASSERT_EQ(check.judge(reading_at(now_ns, 0.5), Origin::fresh), Verdict::held);
  }
  now_ns += period_ns();
  EXPECT_EQ(check.judge(reading_at(now_ns, x_m()), Origin::fresh), Verdict::plausible);
}

// A driver that returns a stale position for 40 ms as if it were new.
TEST_P(ReadingCheckTest, TakesABitIdenticalPositionOfAMovingHandForRepeated) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  ProbeState state{};
  const auto moved = [&] {
    state = reading_at(now_ns, 0.5e-9 * static_cast<double>(now_ns));
    state.velocity_m_per_s.x = 0.5;
    return state;
  };
  for (int i = 0; i < 50; ++i) {
    now_ns += period_ns();
    ASSERT_EQ(check.judge(moved(), Origin::fresh), Verdict::plausible);
  }
  for (const std::int64_t until_ns = now_ns + 40'000'000; now_ns < until_ns;) {
    state.time_ns = now_ns += period_ns();
    state.velocity_m_per_s.x = 0.0;  // as estimated from stale positions
    ASSERT_EQ(check.judge(state, Origin::fresh), Verdict::plausible);
  }
  now_ns += period_ns();
  EXPECT_EQ(check.judge(moved(), Origin::fresh), Verdict::plausible);
  // At rest for longer than any pause, the hand may jump no farther than in a tick.
  for (const std::int64_t until_ns = now_ns + 60'000'000; now_ns < until_ns;) {
    state.time_ns = now_ns += period_ns();
    check.judge(state, Origin::fresh);
  }
  state.time_ns = now_ns += period_ns();
  state.position_m.x += 0.025;
  EXPECT_EQ(check.judge(state, Origin::fresh), Verdict::held);
}

INSTANTIATE_TEST_SUITE_P(Rates, ReadingCheckTest, testing::Values(500.0, 1000.0, 2000.0, 4000.0));

TEST(ReadingCheck, JudgesATurnAsTheMotionOfAPointOfTheTool) {
  // 5 m/s at 50 mm: 100 rad/s, 0.1 rad in a millisecond.
  for (const double angle_rad : {0.09, -0.09}) {
    ReadingCheck check(5.0);
    check.judge(turned_reading(0, 1.0), Origin::fresh);
    EXPECT_EQ(check.judge(turned_reading(1'000'000, 1.0 + angle_rad), Origin::fresh),
              Verdict::plausible);
  }
  for (const double angle_rad : {0.11, -0.11, std::numbers::pi}) {
    ReadingCheck check(5.0);
    check.judge(turned_reading(0, 1.0), Origin::fresh);
    EXPECT_EQ(check.judge(turned_reading(1'000'000, 1.0 + angle_rad), Origin::fresh),
              Verdict::held);
  }
  // q and −q are one orientation.
  ReadingCheck check(5.0);
  check.judge(turned_reading(0, 1.0), Origin::fresh);
  EXPECT_EQ(check.judge(turned_reading(1'000'000, 1.0 + 2.0 * std::numbers::pi), Origin::fresh),
            Verdict::plausible);
}

// A wireless grip on an arm: it wakes after the arm, reports at 100 Hz, and is silent for 50 ms.
TEST(ReadingCheck, JudgesATurnOverTheTimeSinceTheOrientationChanged) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  const auto feel = [&](double angle_rad) {
    return check.judge(turned_reading(now_ns += 1'000'000, angle_rad), Origin::fresh);
  };
  for (int i = 0; i < 100; ++i) ASSERT_EQ(feel(0.0), Verdict::plausible);
  for (int i = 0; i < 100; ++i) {
    // 30 rad/s
    ASSERT_EQ(feel(2.0 + 0.3 * static_cast<double>(i / 10)), Verdict::plausible) << i;
  }
  for (int i = 0; i < 50; ++i) ASSERT_EQ(feel(4.7), Verdict::plausible);
  EXPECT_EQ(feel(6.2), Verdict::plausible);
  EXPECT_EQ(feel(6.25), Verdict::plausible);
  EXPECT_EQ(feel(6.45), Verdict::held);
  EXPECT_EQ(feel(6.45), Verdict::held);
  EXPECT_EQ(feel(6.45), Verdict::lost);
}

TEST(ReadingCheck, AcceptsTheFirstOrientationOfASensorThatWakes) {
  ReadingCheck check(5.0);
  check.judge(turned_reading(0, 0.0), Origin::fresh);
  EXPECT_EQ(check.judge(turned_reading(1'000'000, 2.0), Origin::fresh), Verdict::plausible);
  EXPECT_EQ(check.judge(turned_reading(2'000'000, 2.2), Origin::fresh), Verdict::held);
}

// The line pauses while the hand moves at 0.8 m/s, and the first readings are repeated ones.
TEST(ReadingCheck, BeginsWithTheFirstFreshReading) {
  ReadingCheck check(5.0);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(check.judge(reading_at(i * 1'000'000, 0.0), Origin::repeated), Verdict::plausible);
  }
  EXPECT_EQ(check.judge(reading_at(30'000'000, 0.024), Origin::fresh), Verdict::plausible);
  EXPECT_EQ(check.judge(reading_at(31'000'000, 0.050), Origin::fresh), Verdict::held);
  check.restart();
  EXPECT_EQ(check.judge(reading_at(32'000'000, 0.050), Origin::fresh), Verdict::plausible);
}

// A line that pauses for 6 ms while the hand moves at 3 m/s: the driver repeats its last reading meanwhile.
TEST(ReadingCheck, JudgesTheMotionOverTheWholePauseOfTheLine) {
  ReadingCheck check(5.0);
  std::int64_t now_ns = 0;
  for (int i = 0; i < 20; ++i) {
    now_ns += 1'000'000;
    ASSERT_EQ(check.judge(reading_at(now_ns, 3e-9 * static_cast<double>(now_ns)), Origin::fresh),
              Verdict::plausible);
  }
  const double last_m = 3e-9 * static_cast<double>(now_ns);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(check.judge(reading_at(now_ns += 1'000'000, last_m), Origin::repeated),
              Verdict::plausible);
  }
  EXPECT_EQ(check.judge(reading_at(now_ns, 3e-9 * static_cast<double>(now_ns)), Origin::fresh),
            Verdict::plausible);
  // A wild reading that the driver repeats stays wild.
  EXPECT_EQ(check.judge(reading_at(now_ns += 1'000'000, 0.5), Origin::fresh), Verdict::held);
  EXPECT_EQ(check.judge(reading_at(now_ns += 1'000'000, 0.5), Origin::repeated), Verdict::held);
  EXPECT_EQ(check.judge(reading_at(now_ns += 1'000'000, 0.5), Origin::repeated), Verdict::lost);
}

// Over 10 ms, in the arithmetic of the check: the limit to the last bit.
TEST(ReadingCheck, AcceptsExactlyTheSpeedOfTheDevice) {
  constexpr double kSpeed_m_per_s = 5.0;
  constexpr std::int64_t kTime_ns = 10'000'000;
  const double farthest_m = kSpeed_m_per_s * (1e-9 * static_cast<double>(kTime_ns));
  ReadingCheck at_limit(kSpeed_m_per_s);
  at_limit.judge(reading_at(0, 0.0), Origin::fresh);
  EXPECT_EQ(at_limit.judge(reading_at(kTime_ns, farthest_m), Origin::fresh), Verdict::plausible);
  ReadingCheck beyond(kSpeed_m_per_s);
  beyond.judge(reading_at(0, 0.0), Origin::fresh);
  EXPECT_EQ(beyond.judge(reading_at(kTime_ns, std::nextafter(farthest_m, 1.0)), Origin::fresh),
            Verdict::held);
}

TEST(ReadingCheck, AcceptsEveryReadingOfAHandThatMayJump) {
  ReadingCheck check(std::numeric_limits<double>::infinity());
  check.judge(reading_at(0, 0.0), Origin::fresh);
  EXPECT_EQ(check.judge(reading_at(1, 1e3), Origin::fresh), Verdict::plausible);
}

}  // namespace
}  // namespace asperity
