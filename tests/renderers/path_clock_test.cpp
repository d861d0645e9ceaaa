// The length of the path of a hand whose positions are measured in steps.

#include "renderers/force/path_clock.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderers/servo/tick_record.h"

namespace asperity {
namespace {

constexpr double kCount_m = 38e-6;  // of a Falcon

struct Straight {
  double angle_deg = 0.0;
  double speed_m_per_s = 0.06;
};

/// ℓ relative to the true length of 20 s along a line, less 1. The positions are read in counts at 1 kHz.
double excess_of(const Straight& line, double stated_step_m) {
  const double angle_rad = line.angle_deg * std::numbers::pi / 180.0;
  const glm::dvec2 along{std::cos(angle_rad), std::sin(angle_rad)};
  const auto read_m = [&](double way_m) {
    const glm::dvec2 at_m = glm::dvec2(0.3, 0.7) * kCount_m + way_m * along;
    return glm::dvec2(std::round(at_m.x / kCount_m), std::round(at_m.y / kCount_m)) * kCount_m;
  };
  PathClock clock(stated_step_m);
  clock.reset(read_m(0.0));
  double length_m = 0.0;
  constexpr int kTicks = 20'000;
  for (int tick = 1; tick <= kTicks; ++tick) {
    length_m = clock.advance(read_m(1e-3 * tick * line.speed_m_per_s));
  }
  return length_m / (1e-3 * kTicks * line.speed_m_per_s) - 1.0;
}

TEST(PathClock, IsAtMostTwoPercentTooLongInAllDirectionsWithTheStepOfTheDevice) {
  for (const double speed_m_per_s : {0.02, 0.06, 0.12, 0.2}) {
    for (double angle_deg = 0.0; angle_deg <= 90.0; angle_deg += 2.5) {
      const double excess = excess_of({angle_deg, speed_m_per_s}, kCount_m);
      EXPECT_GT(excess, -0.001) << angle_deg << " deg, " << speed_m_per_s << " m/s";
      EXPECT_LT(excess, 0.022) << angle_deg << " deg, " << speed_m_per_s << " m/s";
    }
  }
}

/// A count as the servo loop hands it to a renderer: rounded for the recording.
double recorded_m(int count) {
  const ProbeState read{.position_m = {count * kCount_m, 0.0, 0.0}};
  return rounded_for_recording(read).position_m.x;
}

// k + 1 and k - 1 counts differ by two, and as recorded numbers in metres at many k by a little more: up to 0.5 m.
TEST(PathClock, StandsStillWhereverACountVariesByOneAboutAPlace) {
  int above_two_counts = 0;
  for (int place = -13'000; place <= 13'000; ++place) {
    PathClock clock(kCount_m);
    clock.reset({recorded_m(place - 1), 0.0});
    EXPECT_EQ(clock.advance({recorded_m(place + 1), 0.0}), 0.0) << place;
    if (recorded_m(place + 1) - recorded_m(place - 1) > 2.0 * kCount_m) ++above_two_counts;
  }
  EXPECT_GT(above_two_counts, 5000);
}

TEST(PathClock, GrowsWithThreeCounts) {
  PathClock clock(kCount_m);
  clock.reset({0.0, 0.0});
  EXPECT_EQ(clock.advance({2.0 * kCount_m, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(clock.advance({3.0 * kCount_m, 0.0}), 3.0 * kCount_m);
}

TEST(PathClock, IsSeveralPercentTooLongWhereTheStepIsNotStated) {
  EXPECT_GT(excess_of({20.0, 0.06}, 0.0), 0.04);
  EXPECT_GT(excess_of({45.0, 0.02}, 0.0), 0.35);
}

}  // namespace
}  // namespace asperity
