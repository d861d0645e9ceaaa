// The rules of staircases, and the mean of their reversals.

#include "analysis/psychometric/up_down.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/level_scale.h"
#include "analysis/psychometric/staircase.h"

namespace asperity {
namespace {

TEST(UpDown, BalancesAtThePublishedProportions) {
  // [Levitt 1971]: pⁿ = ½.
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 1}), 0.5, 1e-12);
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 2}), 0.7071, 5e-5);
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 3}), 0.7937, 5e-5);
  // [Kaernbach 1991]: a step up of 3 steps down.
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 1}, 3.0), 0.75, 1e-12);
  // [García-Pérez 1998]: his ratios of down to up and his percentages.
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 1}, 1.0 / 0.2845), 0.7785, 5e-5);
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 2}, 1.0 / 0.5488), 0.8035, 5e-5);
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 3}, 1.0 / 0.7393), 0.8315, 5e-5);
  EXPECT_NEAR(balanced_performance({.up = 1, .down = 4}, 1.0 / 0.8415), 0.8584, 5e-5);
}

TEST(UpDown, BalancesMirroredRulesAtMirroredProportions) {
  EXPECT_NEAR(balanced_performance({.up = 2, .down = 1}), 1.0 - std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(balanced_performance({.up = 3, .down = 3}), 0.5, 1e-12);
  EXPECT_NEAR(balanced_performance({.up = 2, .down = 3}, 1.7),
              1.0 - balanced_performance({.up = 3, .down = 2}, 1.0 / 1.7), 1e-12);
}

// Two down, two up by hand: at p the next move is down with probability D. A run that begins with a correct response
// (p) goes down with another (p), or continues as one that began with an incorrect response. With a = P(down | last
// correct), b = P(down | last incorrect): a = p + q·b, b = p·a, hence a = p/(1 − pq), b = p²/(1 − pq), and
// D = p·a + q·b = p²(1 + q)/(1 − pq). At p = 0.6: 0.36·1.4/0.76 = 0.66316.
TEST(UpDown, HasTheChanceOfADownMoveThatARunByHandHas) {
  const double down = 0.36 * 1.4 / 0.76;
  EXPECT_NEAR(balanced_performance({.up = 2, .down = 2}, down / (1.0 - down)), 0.6, 1e-12);
}

TEST(UpDown, RefusesCountsAndRatiosOfZero) {
  EXPECT_THROW(UpDownRun({.up = 0, .down = 1}), std::invalid_argument);
  EXPECT_THROW(UpDownRun({.up = 1, .down = 0}), std::invalid_argument);
  EXPECT_THROW(balanced_performance({.up = 1, .down = 0}), std::invalid_argument);
  EXPECT_THROW(balanced_performance({}, 0.0), std::invalid_argument);
}

TEST(UpDown, BeginsItsCountsAgainAfterAMoveAndAfterAnotherResponse) {
  UpDownRun run({.up = 2, .down = 3});
  const auto moves = [&run](const std::vector<bool>& responses) {
    std::vector<UpDownMove> all{};
    for (const bool correct : responses) all.push_back(run.respond(correct).move);
    return all;
  };
  using enum UpDownMove;
  EXPECT_EQ(moves({true, true, false, true, true, true}),
            (std::vector{none, none, none, none, none, down}));
  EXPECT_EQ(moves({true, true, true}), (std::vector{none, none, down}));
  EXPECT_EQ(run.reversals(), 0U);
  EXPECT_EQ(moves({false, false}), (std::vector{none, up}));
  EXPECT_EQ(run.reversals(), 1U);
}

TEST(LevelScale, MovesAsItsFormulasState) {
  EXPECT_DOUBLE_EQ(moved_level(LevelScale::linear, 5.0, {.size = 0.5, .steps = -3.0}), 3.5);
  EXPECT_DOUBLE_EQ(moved_level(LevelScale::log10, 5.0, {.size = 1.0, .steps = 2.0}), 500.0);
  EXPECT_DOUBLE_EQ(moved_level(LevelScale::decibel, 5.0, {.size = 20.0, .steps = -1.0}), 0.5);
  EXPECT_DOUBLE_EQ(moved_level(LevelScale::ratio, 5.0, {.size = 2.0, .steps = 3.0}), 40.0);
}

TEST(LevelScale, HasEqualLengthsForEqualSteps) {
  for (const auto& [scale, step] :
       {std::pair{LevelScale::linear, 0.3}, std::pair{LevelScale::log10, 0.1},
        std::pair{LevelScale::decibel, 2.0}, std::pair{LevelScale::ratio, 1.25}}) {
    for (const double level : {0.2, 7.0}) {
      const double moved = moved_level(scale, level, {.size = step, .steps = 4.0});
      EXPECT_NEAR(place_on(scale, moved) - place_on(scale, level), 4.0 * step_length(scale, step),
                  1e-12)
          << name_of(scale);
      EXPECT_NEAR(level_at(scale, place_on(scale, level)), level, 1e-12);
    }
  }
}

// Reversals at 4, 6, 5 and 7 (1-up/1-down, step 1): their mean is 5.5, the median 5.5, the midpoints are 5 and 6.
TEST(Staircase, AveragesTheLevelsOfItsReversals) {
  const StaircaseTrack track =
      replay_staircase({.start = 6.0, .steps = {1.0}},
                       //  6     5     4      5      6     5      6      7     6
                       {true, true, false, false, true, false, false, true, true});
  const auto mean = mean_of_reversals(track, {});
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->used, 4U);
  EXPECT_DOUBLE_EQ(mean->mean, 5.5);
  EXPECT_DOUBLE_EQ(mean->median, 5.5);
  EXPECT_DOUBLE_EQ(*mean->sd, std::sqrt(5.0 / 3.0));
  EXPECT_DOUBLE_EQ(*mean->midpoint_error, std::sqrt(0.5) / std::sqrt(2.0));
  EXPECT_EQ(track.next_level, 5.0);
}

TEST(Staircase, LeavesOutTheFirstReversals) {
  const StaircaseTrack track = replay_staircase(
      {.start = 6.0, .steps = {1.0}}, {true, true, false, false, true, false, false, true, true});
  EXPECT_DOUBLE_EQ(mean_of_reversals(track, {.discard = 1})->mean, 6.0);
  const auto even = mean_of_reversals(track, {.discard = 1, .even_number = true});
  EXPECT_EQ(even->used, 2U);
  EXPECT_DOUBLE_EQ(even->mean, 6.0);  // 5 and 7
  EXPECT_TRUE(std::isnan(*even->midpoint_error));
  EXPECT_FALSE(mean_of_reversals(track, {.discard = 1})->midpoint_error);  // three
  EXPECT_FALSE(mean_of_reversals(track, {.discard = 4}));
  EXPECT_FALSE(mean_of_reversals(track, {.discard = 3, .even_number = true}));
}

TEST(Staircase, AveragesLogarithmsOnALogarithmicScale) {
  const StaircaseTrack track = replay_staircase(
      {.start = 1.0, .scale = LevelScale::ratio, .steps = {4.0}}, {true, false, true});
  // Levels 1, 1/4, 1 with reversals at 1/4 and 1: the geometric mean is 1/2.
  EXPECT_NEAR(mean_of_reversals(track, {.scale = LevelScale::ratio})->mean, 0.5, 1e-12);
}

TEST(Staircase, RefusesSettingsWithoutATrack) {
  const std::vector<bool> none{};
  EXPECT_THROW(replay_staircase({.start = 1.0}, none), std::invalid_argument);
  EXPECT_THROW(replay_staircase({.start = 1.0, .steps = {0.0}}, none), std::invalid_argument);
  EXPECT_THROW(replay_staircase({.start = 1.0, .steps = {1.0}, .lowest = 2.0}, none),
               std::invalid_argument);
  EXPECT_THROW(replay_staircase({.start = 0.0, .scale = LevelScale::decibel, .steps = {1.0}}, none),
               std::invalid_argument);
  EXPECT_THROW(replay_staircase({.start = 1.0, .steps = {1.0}, .up_over_down = 0.0}, none),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
