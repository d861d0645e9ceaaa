// How the virtual hand strokes, and that it is a function of seed and time.

#include "device/virtual_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kMillimetre_m = 1e-3;

// Strokes that are all alike.
constexpr HandHabits kSteadyHabits{.speed_variation = 0.0, .force_variation = 0.0, .drift_m = 0.0};

std::vector<HandIntent> motion(VirtualHand& hand, std::int64_t from_ns, std::int64_t to_ns,
                               std::int64_t step_ns = kMillisecond_ns) {
  std::vector<HandIntent> intents;
  for (std::int64_t now_ns = from_ns; now_ns < to_ns; now_ns += step_ns) {
    intents.push_back(hand.intent(now_ns));
  }
  return intents;
}

std::int64_t seconds(double duration_s) { return std::llround(1e9 * duration_s); }

bool same(const HandIntent& a, const HandIntent& b) {
  return a.position_m == b.position_m && a.velocity_m_per_s == b.velocity_m_per_s &&
         a.press_N == b.press_N && a.lifted == b.lifted;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};
Moments moments(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  Moments found{};
  for (const double value : values) {
    found.mean += value / n;
  }
  for (const double value : values) {
    found.deviation += (value - found.mean) * (value - found.mean) / n;
  }
  found.deviation = std::sqrt(found.deviation);
  return found;
}

// What one stroke was like.
struct HandStroke {
  double speed_m_per_s = 0.0;  // the fastest
  double force_N = 0.0;        // before it ends
  glm::dvec3 end_m{0.0};
};

// Cuts a motion along x where it turns.
std::vector<HandStroke> strokes_of(VirtualHand& hand, double duration_s) {
  hand.stroke();
  std::vector<HandStroke> strokes;
  HandStroke stroke{};
  double direction = 0.0;
  HandIntent last{};
  for (std::int64_t now_ns = 0; now_ns < seconds(duration_s); now_ns += 2 * kMillisecond_ns) {
    const HandIntent intent = hand.intent(now_ns);
    const double vx = intent.velocity_m_per_s.x;
    if (intent.lifted) {
      continue;
    }
    if (vx * direction < 0.0) {
      stroke.force_N = last.press_N;
      stroke.end_m = last.position_m;
      strokes.push_back(stroke);
      stroke = HandStroke{};
    }
    direction = vx == 0.0 ? direction : std::copysign(1.0, vx);
    stroke.speed_m_per_s = std::max(stroke.speed_m_per_s, std::abs(vx));
    last = intent;
  }
  return strokes;
}

TEST(VirtualHand, WaitsAboveTheStartOfItsStrokeUntilToldToStroke) {
  VirtualHand hand(kSteadyHabits, Random(1));
  for (const HandIntent& intent : motion(hand, 0, seconds(5.0))) {
    ASSERT_TRUE(intent.lifted);
    ASSERT_EQ(intent.press_N, 0.0);
    ASSERT_NEAR(glm::distance(intent.position_m, glm::dvec3(-0.030, 0.0, 0.010)), 0.0, 1e-15);
    ASSERT_EQ(intent.velocity_m_per_s, glm::dvec3(0.0));
  }
}

TEST(VirtualHand, ComesDownAtTheApproachSpeedAndTouchesAtRest) {
  HandHabits habits = kSteadyHabits;
  habits.centre_m = {0.01, 0.02, -0.03};
  VirtualHand hand(habits, Random(1));
  hand.stroke();
  double fastest_m_per_s = 0.0;
  HandIntent touch{};
  std::int64_t touched_ns = 0;
  for (std::int64_t now_ns = 0; now_ns < seconds(1.0); now_ns += kMillisecond_ns) {
    touch = hand.intent(now_ns);
    touched_ns = now_ns;
    if (!touch.lifted) {
      break;
    }
    fastest_m_per_s = std::max(fastest_m_per_s, -touch.velocity_m_per_s.z);
  }
  EXPECT_NEAR(fastest_m_per_s, habits.approach_speed_m_per_s, 1e-9);
  // 10 mm at 50 mm/s, 85 % of the time's worth of steady speed: 0.2 s / 0.85.
  EXPECT_NEAR(static_cast<double>(touched_ns) * 1e-9, 0.2 / 0.85, 2e-3);
  EXPECT_EQ(touch.position_m.z, habits.centre_m.z);
  EXPECT_LT(glm::length(touch.velocity_m_per_s), 1e-3);
  EXPECT_LT(touch.press_N, 0.01);
}

TEST(VirtualHand, ReportsTheDerivativeOfItsPosition) {
  VirtualHand hand(HandHabits{.direction_rad = 0.7}, Random(2));
  hand.stroke();
  constexpr std::int64_t kStep_ns = 100'000;
  const std::vector<HandIntent> path = motion(hand, 0, seconds(8.0), kStep_ns);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const glm::dvec3 slope_m_per_s =
        (path[i + 1].position_m - path[i - 1].position_m) / (2e-9 * kStep_ns);
    // The acceleration, below 3 m/s², may turn within the two steps.
    ASSERT_LT(glm::distance(path[i].velocity_m_per_s, slope_m_per_s), 3e-9 * kStep_ns);
    ASSERT_LT(glm::distance(path[i + 1].velocity_m_per_s, path[i].velocity_m_per_s),
              3e-9 * kStep_ns);
  }
}

TEST(VirtualHand, KeepsTheStrokesSpeedForSeventyPercentOfTheTime) {
  VirtualHand hand(kSteadyHabits, Random(3));
  hand.stroke();
  int moving = 0;
  int steady = 0;
  double farthest_m = 0.0;
  for (const HandIntent& intent : motion(hand, 0, seconds(20.0))) {
    if (intent.lifted) {
      continue;
    }
    const double speed_m_per_s = std::abs(intent.velocity_m_per_s.x);
    ASSERT_LE(speed_m_per_s, 0.080 + 1e-9);
    ++moving;
    steady += speed_m_per_s > 0.0799 ? 1 : 0;
    farthest_m = std::max(farthest_m, std::abs(intent.position_m.x));
  }
  EXPECT_NEAR(static_cast<double>(steady) / moving, 0.70, 0.02);
  EXPECT_NEAR(farthest_m, 0.030, 1e-6);
}

TEST(VirtualHand, StrokesAlongItsDirection) {
  HandHabits habits = kSteadyHabits;
  habits.direction_rad = std::numbers::pi / 2.0;
  VirtualHand hand(habits, Random(3));
  hand.stroke();
  double lowest_m = 0.0;
  double highest_m = 0.0;
  for (const HandIntent& intent : motion(hand, 0, seconds(5.0))) {
    ASSERT_NEAR(intent.position_m.x, 0.0, 1e-15);
    lowest_m = std::min(lowest_m, intent.position_m.y);
    highest_m = std::max(highest_m, intent.position_m.y);
  }
  EXPECT_NEAR(lowest_m, -0.030, 1e-6);
  EXPECT_NEAR(highest_m, 0.030, 1e-6);
}

TEST(VirtualHand, PressesWithTheWantedForceFromTheStartOfTheStrokeOn) {
  VirtualHand hand(kSteadyHabits, Random(3));
  hand.stroke();
  const auto path = motion(hand, 0, seconds(3.0));
  const auto touch =
      std::find_if(path.begin(), path.end(), [](const HandIntent& i) { return !i.lifted; });
  for (auto now = touch; now + 1 != path.end(); ++now) {
    ASSERT_GE((now + 1)->press_N, now->press_N);
    ASSERT_LT((now + 1)->press_N - now->press_N, 0.015);  // 1.5 N / 150 ms at the steepest
  }
  EXPECT_EQ((touch + 151)->press_N, 1.0);
}

TEST(VirtualHand, VariesSpeedAndForceBetweenStrokesAsItsHabitsSay) {
  VirtualHand hand(HandHabits{.speed_variation = 0.15, .force_variation = 0.10, .drift_m = 0.0},
                   Random(4));
  std::vector<double> speeds_m_per_s;
  std::vector<double> forces_N;
  for (const HandStroke& stroke : strokes_of(hand, 2000.0)) {
    speeds_m_per_s.push_back(stroke.speed_m_per_s);
    forces_N.push_back(stroke.force_N);
  }
  ASSERT_GT(speeds_m_per_s.size(), 2000U);
  // Four standard errors each: of a mean σ/√n, of a deviation σ/√(2n); cutting at 2.5 σ takes 1 %.
  const Moments speed = moments(speeds_m_per_s);
  EXPECT_NEAR(speed.mean, 0.080, 4.0 * 0.012 / std::sqrt(2000.0));
  EXPECT_NEAR(speed.deviation, 0.99 * 0.012, 4.0 * 0.012 / std::sqrt(4000.0));
  const Moments force = moments(forces_N);
  EXPECT_NEAR(force.mean, 1.0, 4.0 * 0.10 / std::sqrt(2000.0));
  EXPECT_NEAR(force.deviation, 0.99 * 0.10, 4.0 * 0.10 / std::sqrt(4000.0));
  EXPECT_GE(*std::min_element(forces_N.begin(), forces_N.end()), 0.75 - 1e-12);
  EXPECT_LE(*std::max_element(forces_N.begin(), forces_N.end()), 1.25 + 1e-12);
}

TEST(VirtualHand, DriftsSlowlyWithTheStatedDeviation) {
  VirtualHand hand(HandHabits{.drift_m = 0.004}, Random(5));
  std::vector<double> across_m;
  for (const HandStroke& stroke : strokes_of(hand, 6000.0)) {
    across_m.push_back(stroke.end_m.y);
  }
  const Moments drift = moments(across_m);
  // Strokes of 0.9 s remember 85 % of the last: some 500 independent values in 6500.
  EXPECT_NEAR(drift.mean, 0.0, 4.0 * 0.004 / std::sqrt(500.0));
  EXPECT_NEAR(drift.deviation, 0.004, 4.0 * 0.004 / std::sqrt(1000.0));
  double together_m2 = 0.0;
  for (std::size_t i = 1; i < across_m.size(); ++i) {
    together_m2 += across_m[i] * across_m[i - 1] / static_cast<double>(across_m.size());
  }
  EXPECT_NEAR(together_m2 / (drift.deviation * drift.deviation), 1.0 / (1.0 + 0.9 / 5.0), 0.05);
}

TEST(VirtualHand, NeverLeavesItsBound) {
  const HandHabits habits{.centre_m = {0.01, 0.0, 0.0}, .drift_m = 0.008};
  VirtualHand hand(habits, Random(6));
  hand.stroke();
  double farthest_along_m = 0.0;
  double farthest_across_m = 0.0;
  for (std::int64_t now_ns = 0; now_ns < seconds(4000.0); now_ns += 20 * kMillisecond_ns) {
    const HandIntent intent = hand.intent(now_ns);
    farthest_along_m = std::max(farthest_along_m, std::abs(intent.position_m.x - 0.01));
    farthest_across_m = std::max(farthest_across_m, std::abs(intent.position_m.y));
  }
  EXPECT_LE(farthest_along_m, 0.030 + 2.5 * 0.008 + 1e-12);
  EXPECT_LE(farthest_across_m, 2.5 * 0.008 + 1e-12);
  EXPECT_GT(farthest_across_m, 2.0 * 0.008);
}

// Patches side by side along y, stroked along x.
TEST(VirtualHand, StrokesAboutItsCentresInTurn) {
  const HandHabits habits{.centre_m = {0.0, -0.02, 0.0},
                          .drift_m = 0.002,
                          .further_centres_m = {{{0.0, 0.02, 0.0}}},
                          .further_centres = 1,
                          .strokes_at_a_centre = 3};
  VirtualHand hand(habits, Random(6));
  hand.stroke();
  std::vector<int> visits{};  // the centre, and the turns in between
  std::vector<int> strokes{};
  double direction = 0.0;
  bool was_lifted = true;
  HandIntent last{};
  for (const HandIntent& intent : motion(hand, 0, seconds(30.0))) {
    if (!intent.lifted) {
      const int centre = intent.position_m.y < 0.0 ? 0 : 1;
      EXPECT_LE(std::abs(std::abs(intent.position_m.y) - 0.02), 2.5 * 0.002 + 1e-12);
      EXPECT_LE(std::abs(intent.position_m.x), 0.03 + 2.5 * 0.002 + 1e-12);
      if (was_lifted) {
        EXPECT_EQ(intent.press_N, 0.0) << "touches before it presses";
        visits.push_back(centre);
        strokes.push_back(0);
        direction = 0.0;
      }
      EXPECT_EQ(visits.back(), centre) << "moves to another centre in the air";
      const double vx = intent.velocity_m_per_s.x;
      if (vx != 0.0 && std::copysign(1.0, vx) != direction) {
        direction = std::copysign(1.0, vx);
        ++strokes.back();
      }
    } else if (!was_lifted) {
      EXPECT_LT(last.press_N, 0.01) << "releases before it lifts";
    }
    was_lifted = intent.lifted;
    last = intent;
  }
  ASSERT_GE(visits.size(), 6U);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    EXPECT_EQ(visits[i], static_cast<int>(i % 2));
    if (i + 1 < visits.size()) {
      EXPECT_EQ(strokes[i], 3);
    }
  }
}

TEST(VirtualHand, MovesTheSameBitForBitFromTheSameSeedAndOtherwiseFromAnother) {
  VirtualHand one(HandHabits{}, Random(7));
  VirtualHand again(HandHabits{}, Random(7));
  VirtualHand other(HandHabits{}, Random(8));
  one.stroke();
  again.stroke();
  other.stroke();
  bool differs = false;
  for (std::int64_t now_ns = 0; now_ns < seconds(20.0); now_ns += kMillisecond_ns) {
    const HandIntent intent = one.intent(now_ns);
    ASSERT_TRUE(same(intent, again.intent(now_ns)));
    differs = differs || !same(intent, other.intent(now_ns));
  }
  EXPECT_TRUE(differs);
}

TEST(VirtualHand, StrokesTheSameHoweverOftenItIsAsked) {
  VirtualHand slow(HandHabits{}, Random(9));
  VirtualHand fast(HandHabits{}, Random(9));
  slow.stroke();
  fast.stroke();
  for (std::int64_t now_ns = 0; now_ns < seconds(10.0); now_ns += 2 * kMillisecond_ns) {
    for (std::int64_t early_ns = std::max<std::int64_t>(0, now_ns - 1'900'000); early_ns < now_ns;
         early_ns += 100'000) {
      fast.intent(early_ns);
    }
    const HandIntent slowly = slow.intent(now_ns);
    const HandIntent often = fast.intent(now_ns);
    ASSERT_EQ(slowly.position_m, often.position_m);
    ASSERT_EQ(slowly.velocity_m_per_s, often.velocity_m_per_s);
    ASSERT_NEAR(slowly.press_N, often.press_N, 0.02);  // 2 ms of letting the force grow
  }
}

TEST(VirtualHand, LetsGoAndRisesWhenToldToLift) {
  VirtualHand hand(kSteadyHabits, Random(10));
  hand.stroke();
  motion(hand, 0, seconds(2.0));
  hand.lift();
  const auto path = motion(hand, seconds(2.0), seconds(3.0));
  EXPECT_GT(path.front().press_N, 0.9);
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_LE(path[i].press_N, path[i - 1].press_N);
    ASSERT_GE(path[i].position_m.z, path[i - 1].position_m.z);
  }
  EXPECT_TRUE(path[151].lifted);
  EXPECT_EQ(path[151].press_N, 0.0);
  EXPECT_NEAR(path[151 + 237].position_m.z, 0.010, 1e-6);  // 0.2 s / 0.85 later
  EXPECT_EQ(path.back().velocity_m_per_s, glm::dvec3(0.0));
}

TEST(VirtualHand, TurnsBackWhenToldToLiftWhileComingDown) {
  VirtualHand hand(kSteadyHabits, Random(10));
  hand.stroke();
  const double height_m = motion(hand, 0, seconds(0.1)).back().position_m.z;
  hand.lift();
  for (const HandIntent& intent : motion(hand, seconds(0.1), seconds(1.0))) {
    ASSERT_TRUE(intent.lifted);
    ASSERT_GT(intent.position_m.z, height_m - 0.1 * kMillimetre_m);
  }
  EXPECT_NEAR(hand.intent(seconds(1.0)).position_m.z, 0.010, 1e-12);
}

TEST(VirtualHand, RisesToTheEndBeforeItComesDownAgain) {
  VirtualHand hand(kSteadyHabits, Random(10));
  hand.stroke();
  motion(hand, 0, seconds(1.0));
  hand.lift();
  auto path = motion(hand, seconds(1.0), seconds(1.2));
  hand.stroke();
  double highest_m = 0.0;
  const auto after = motion(hand, seconds(1.2), seconds(3.0));
  path.insert(path.end(), after.begin(), after.end());
  for (std::size_t i = 1; i < path.size(); ++i) {
    highest_m = std::max(highest_m, path[i].position_m.z);
    ASSERT_LT(glm::distance(path[i].position_m, path[i - 1].position_m), 0.21 * kMillimetre_m);
  }
  EXPECT_NEAR(highest_m, 0.010, 1e-6);
  EXPECT_FALSE(path.back().lifted);
}

TEST(VirtualHand, StandsStillInALongGap) {
  VirtualHand hand(kSteadyHabits, Random(11));
  hand.stroke();
  HandIntent before = motion(hand, 0, seconds(1.0)).back();
  double now_s = 1.0;
  for (const double gap_s : {0.37, 1.0, 7.3, 1000.0, 0.51}) {
    now_s += gap_s;
    const HandIntent after = hand.intent(seconds(now_s));
    // As far as in 0.1 s.
    EXPECT_LE(glm::distance(before.position_m, after.position_m), 0.1 * 0.080 + 1e-9);
    EXPECT_GT(glm::distance(before.position_m, after.position_m), 0.0);
    before = after;
  }
}

/// The intents of the first second from rest above the start, and the time after it.
std::vector<HandIntent> first_second_of_visit(VirtualHand& hand, std::int64_t& now_ns) {
  while (!hand.is_ready()) hand.intent(now_ns += kMillisecond_ns);
  hand.stroke();
  const std::int64_t from_ns = now_ns + kMillisecond_ns;
  now_ns = from_ns + seconds(1.0) - kMillisecond_ns;
  return motion(hand, from_ns, from_ns + seconds(1.0));
}

TEST(VirtualHand, ComesDownInTheSameWayEachTime) {
  VirtualHand hand(HandHabits{}, Random(21));
  std::int64_t now_ns = 0;
  const auto pass = [&hand, &now_ns](double duration_s) {
    const std::int64_t from_ns = now_ns + kMillisecond_ns;
    now_ns += seconds(duration_s);
    motion(hand, from_ns, now_ns + kMillisecond_ns);
  };
  const std::vector<HandIntent> first = first_second_of_visit(hand, now_ns);
  for (const double longer_s : {0.0, 0.13, 1.9, 7.0, 0.6}) {
    pass(longer_s);
    hand.lift();
    hand.intent(now_ns += kMillisecond_ns);
    EXPECT_FALSE(hand.is_ready());
    const std::vector<HandIntent> again = first_second_of_visit(hand, now_ns);
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_TRUE(same(again[i], first[i])) << i << " ms";
    }
  }
  hand.lift();
  hand.set_habits(HandHabits{}, Random(22));
  pass(3.0);
  const std::vector<HandIntent> other = first_second_of_visit(hand, now_ns);
  EXPECT_FALSE(same(other.back(), first.back())) << "the next attempt has its own strokes";
}

TEST(VirtualHand, TakesUpNewHabitsInTheAirWithoutAJump) {
  VirtualHand hand(kSteadyHabits, Random(12));
  hand.stroke();
  motion(hand, 0, seconds(1.0));
  HandHabits next = kSteadyHabits;
  next.centre_m = {0.02, 0.05, 0.001};
  next.direction_rad = std::numbers::pi / 2.0;
  next.normal_force_N = 0.5;
  hand.set_habits(next, Random(12));
  for (const HandIntent& intent : motion(hand, seconds(1.0), seconds(3.0))) {
    ASSERT_EQ(intent.position_m.y, 0.0);  // not before it has been lifted
  }
  hand.lift();
  motion(hand, seconds(3.0), seconds(4.0));
  hand.stroke();
  const auto path = motion(hand, seconds(4.0), seconds(8.0));
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_LT(glm::distance(path[i].position_m, path[i - 1].position_m), 0.21 * kMillimetre_m);
  }
  EXPECT_NEAR(path.back().position_m.x, 0.02, 1e-12);
  EXPECT_EQ(path.back().position_m.z, 0.001);
  EXPECT_EQ(path.back().press_N, 0.5);
}

TEST(VirtualHand, MayBeToldFromAnotherThread) {
  VirtualHand hand(kSteadyHabits, Random(13));
  std::atomic<bool> done{false};
  std::thread conductor([&hand, &done] {
    for (int i = 1; i <= 2000; ++i) {
      HandHabits habits = kSteadyHabits;
      habits.normal_force_N = 0.001 * i;
      habits.centre_m = glm::dvec3(0.0, 1e-5 * i, 0.0);
      hand.lift();
      hand.set_habits(habits, Random(13));
      hand.stroke();
    }
    done.store(true);
  });
  std::int64_t now_ns = 0;
  while (!done.load()) {
    now_ns += kMillisecond_ns;
    ASSERT_TRUE(std::isfinite(hand.intent(now_ns).position_m.y));
  }
  conductor.join();
  hand.lift();
  motion(hand, now_ns, now_ns + seconds(2.0));
  hand.stroke();
  const HandIntent last = motion(hand, now_ns + seconds(2.0), now_ns + seconds(6.0)).back();
  EXPECT_EQ(last.press_N, 2.0);
  EXPECT_NEAR(last.position_m.y, 0.02, 1e-12);
}

TEST(VirtualHand, RefusesAHabitThatIsOutOfRangeByName) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refused_field = [](const HandHabits& habits) {
    const std::string refusal =
        refusal_of<std::invalid_argument>([&] { VirtualHand hand(habits, Random(1)); });
    return refusal.substr(0, refusal.find(' '));
  };
  EXPECT_EQ(refused_field({}), "");
  EXPECT_EQ(refused_field({.speed_variation = 0.0, .force_variation = 0.0, .drift_m = 0.0}), "");
  EXPECT_EQ(refused_field({.centre_m = {0.0, kNan, 0.0}}), "centre_m");
  EXPECT_EQ(refused_field({.direction_rad = kNan}), "direction_rad");
  EXPECT_EQ(refused_field({.stroke_length_m = 0.0}), "stroke_length_m");
  EXPECT_EQ(refused_field({.speed_m_per_s = -0.1}), "speed_m_per_s");
  EXPECT_EQ(refused_field({.speed_variation = 0.31}), "speed_variation");
  EXPECT_EQ(refused_field({.normal_force_N = 0.0}), "normal_force_N");
  EXPECT_EQ(refused_field({.force_variation = -0.1}), "force_variation");
  EXPECT_EQ(refused_field({.drift_m = kNan}), "drift_m");
  EXPECT_EQ(refused_field({.lift_height_m = 0.0}), "lift_height_m");
  EXPECT_EQ(refused_field({.approach_speed_m_per_s = kNan}), "approach_speed_m_per_s");
  VirtualHand hand(HandHabits{}, Random(1));
  EXPECT_THROW(hand.set_habits({.normal_force_N = kNan}, Random(1)), std::invalid_argument);
}

TEST(VirtualHand, DoesNotTouchTheHeap) {
  VirtualHand hand(HandHabits{}, Random(14));
  AllocationGuard guard;
  hand.stroke();
  for (std::int64_t now_ns = 0; now_ns < seconds(5.0); now_ns += kMillisecond_ns) {
    hand.intent(now_ns);
  }
  hand.lift();
  for (std::int64_t now_ns = seconds(5.0); now_ns < seconds(6.0); now_ns += kMillisecond_ns) {
    hand.intent(now_ns);
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
