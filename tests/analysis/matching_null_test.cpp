// Holds the null of matching to counted permutations.

#include "analysis/choices/matching_null.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

TEST(FixedPoints, OfFourAreNineEightSixNoneOneOfTwentyFour) {
  EXPECT_EQ(fixed_point_distribution(4),
            (std::vector<double>{9.0 / 24.0, 8.0 / 24.0, 6.0 / 24.0, 0.0, 1.0 / 24.0}));
}

TEST(FixedPoints, AreThoseOfAllPermutations) {
  for (std::size_t items = 1; items <= 7; ++items) {
    std::vector<std::size_t> order(items);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> count(items + 1);
    double all = 0.0;
    do {
      std::size_t right = 0;
      for (std::size_t i = 0; i < items; ++i) {
        right += order[i] == i ? 1U : 0U;
      }
      count[right] += 1.0;
      all += 1.0;
    } while (std::next_permutation(order.begin(), order.end()));
    for (double& share : count) {
      share /= all;
    }
    EXPECT_EQ(fixed_point_distribution(items), count);
  }
}

TEST(FixedPoints, HaveMeanAndVarianceOneUpToTwelve) {
  for (std::size_t items = 2; items <= 12; ++items) {
    const auto probability = fixed_point_distribution(items);
    double total = 0.0;
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t k = 0; k < probability.size(); ++k) {
      const auto right = static_cast<double>(k);
      total += probability[k];
      mean += right * probability[k];
      square += right * right * probability[k];
    }
    EXPECT_NEAR(total, 1.0, 1e-14);
    EXPECT_NEAR(mean, 1.0, 1e-14);
    EXPECT_NEAR(square - mean * mean, 1.0, 1e-13);
    EXPECT_EQ(probability[items - 1], 0.0);
  }
}

TEST(MatchingChance, IsOneInItemsAndOneInPermutations) {
  EXPECT_EQ(item_chance(4), 0.25);
  EXPECT_EQ(whole_chance(4), 1.0 / 24.0);
  EXPECT_EQ(whole_chance(12), 1.0 / 479001600.0);
  EXPECT_EQ(fixed_point_distribution(12)[12], whole_chance(12));
}

// Two assignments of three items, 2, 3, 0, 1 of 6 each: 4, 12, 9, 4, 6, 0, 1 of 36.
TEST(MatchingNull, AddsAssignmentsByConvolution) {
  const MatchingNull null({.items = 3, .assignments = 2});
  const std::vector<double> expected{4, 12, 9, 4, 6, 0, 1};
  ASSERT_EQ(null.distribution().probability.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(null.distribution().at(static_cast<std::int64_t>(k)), expected[k] / 36.0, 1e-15);
  }
  EXPECT_EQ(null.upper_tail(0), 1.0);
  EXPECT_NEAR(null.upper_tail(3), 11.0 / 36.0, 1e-15);
  EXPECT_NEAR(null.upper_tail(6), 1.0 / 36.0, 1e-16);
  EXPECT_EQ(null.upper_tail(7), 0.0);
}

TEST(MatchingNull, KeepsTheDigitsOfItsTail) {
  const MatchingNull null({.items = 4, .assignments = 20});
  EXPECT_NEAR(null.upper_tail(80) / std::pow(24.0, -20.0), 1.0, 1e-12);
}

// Below 1 of 36 lies nothing on either side that 2·(1/36) could spare but the 6 above.
TEST(MatchingNull, LeavesAtMostHalfTheErrorOnEachSide) {
  const MatchingNull null({.items = 3, .assignments = 2});
  const CountInterval wide = null.central_interval(1.0 - 2.1 / 36.0);
  EXPECT_EQ(wide.low, 0U);
  EXPECT_EQ(wide.high, 4U);
  const CountInterval narrow = null.central_interval(1.0 - 8.1 / 36.0);
  EXPECT_EQ(narrow.low, 1U);
  EXPECT_EQ(narrow.high, 4U);
  for (const std::size_t assignments : {1U, 20U, 500U}) {
    const MatchingNull many({.items = 4, .assignments = assignments});
    const CountInterval interval = many.central_interval(0.999);
    const double below = 1.0 - many.upper_tail(interval.low);
    EXPECT_LE(below, 0.0005 + 1e-12);
    EXPECT_LE(many.upper_tail(interval.high + 1), 0.0005);
    EXPECT_GT(many.upper_tail(interval.high), 0.0005);
    EXPECT_LE(interval.low, assignments);
    EXPECT_GE(interval.high, assignments);
  }
}

TEST(MatchingNull, HoldsForShuffledItems) {
  const MatchingNull null({.items = 4, .assignments = 1000});
  const CountInterval interval = null.central_interval(0.999);
  Random random(3);
  std::size_t right = 0;
  for (int assignment = 0; assignment < 1000; ++assignment) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    random.shuffle(std::span<std::size_t>(order));
    for (std::size_t i = 0; i < 4; ++i) {
      right += order[i] == i ? 1U : 0U;
    }
  }
  EXPECT_GE(right, interval.low);
  EXPECT_LE(right, interval.high);
}

TEST(MatchingNull, RefusesWhatItCannotCount) {
  EXPECT_THROW(fixed_point_distribution(0), std::invalid_argument);
  EXPECT_THROW(fixed_point_distribution(13), std::invalid_argument);
  EXPECT_THROW(item_chance(0), std::invalid_argument);
  EXPECT_THROW(whole_chance(13), std::invalid_argument);
  EXPECT_THROW(MatchingNull({.items = 4, .assignments = 0}), std::invalid_argument);
  EXPECT_THROW(MatchingNull({.items = 4, .assignments = 1}).central_interval(1.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
