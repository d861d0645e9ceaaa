// Holds Cronbach's alpha to its formula, to R, and to its interval's distribution.

#include "analysis/scales/cronbach_alpha.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/analysis/computed_in_r/r_results.h"

namespace asperity {
namespace {

using Scores = std::vector<std::vector<std::optional<double>>>;

// Item variances 2.5, 2.5 and 1; sums 3, 5, 9, 12, 11 with the mean 8 and the variance 15:
// α = 3/2·(1 − 6/15) = 0.9.
TEST(CronbachAlpha, FollowsFromTheVariancesOfItemsAndSums) {
  const Scores scores{
      {1.0, 1.0, 1.0}, {2.0, 2.0, 1.0}, {3.0, 3.0, 3.0}, {4.0, 5.0, 3.0}, {5.0, 4.0, 2.0}};
  const CronbachAlpha alpha = cronbach_alpha(scores);
  ASSERT_TRUE(alpha.value);
  EXPECT_NEAR(*alpha.value, 0.9, 1e-12);
  EXPECT_EQ(alpha.items, 3U);
  EXPECT_EQ(alpha.respondents, 5U);
  EXPECT_EQ(alpha.left_out, 0U);
}

// Closed forms: only rounding separates the two programs.
TEST(CronbachAlpha, AndItsLimitsAreThoseOfR) {
  const RTable table("scales.csv");
  const RResults expected("scales_expected.csv");
  Scores scores{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    scores.push_back(
        {table.number(row, 0), table.number(row, 1), table.number(row, 2), table.number(row, 3)});
  }
  scores.insert(scores.begin() + 5, {4.0, std::nullopt, 3.0, 2.0});
  const CronbachAlpha alpha = cronbach_alpha(scores);
  ASSERT_TRUE(alpha.value);
  ASSERT_TRUE(alpha.interval);
  EXPECT_NEAR(*alpha.value, expected.at("alpha", "value"), 1e-10);
  EXPECT_NEAR(alpha.interval->low, expected.at("alpha", "low"), 1e-10);
  EXPECT_NEAR(alpha.interval->high, expected.at("alpha", "high"), 1e-10);
  EXPECT_EQ(alpha.respondents, 40U);
  EXPECT_EQ(alpha.left_out, 1U);
}

TEST(CronbachAlpha, IsOneWithoutIntervalWhereItemsAgreeCompletely) {
  const CronbachAlpha alpha = cronbach_alpha(Scores{{1.0, 2.0}, {2.0, 3.0}, {5.0, 6.0}});
  ASSERT_TRUE(alpha.value);
  EXPECT_EQ(*alpha.value, 1.0);
  EXPECT_FALSE(alpha.interval);
}

TEST(CronbachAlpha, DoesNotExistWithoutVarianceOfTheSums) {
  EXPECT_FALSE(cronbach_alpha(Scores{{1.0, 3.0}, {2.0, 2.0}, {3.0, 1.0}}).value);  // all sums are 4
  EXPECT_FALSE(cronbach_alpha(Scores{{2.0, 2.0}, {2.0, 2.0}}).value);
  const CronbachAlpha one = cronbach_alpha(Scores{{1.0, 3.0}, {2.0, std::nullopt}});
  EXPECT_FALSE(one.value);
  EXPECT_EQ(one.respondents, 1U);
  EXPECT_EQ(one.left_out, 1U);
}

TEST(CronbachAlpha, RefusesImpossibleScores) {
  EXPECT_THROW(cronbach_alpha(Scores{}), std::invalid_argument);
  EXPECT_THROW(cronbach_alpha(Scores{{1.0}, {2.0}}), std::invalid_argument);
  EXPECT_THROW(cronbach_alpha(Scores{{1.0, 2.0}, {2.0}}), std::invalid_argument);
  EXPECT_THROW(cronbach_alpha(Scores{{1.0, 2.0}, {std::numeric_limits<double>::infinity(), 1.0}}),
               std::invalid_argument);
  EXPECT_THROW(cronbach_alpha(Scores{{1.0, 2.0}, {2.0, 1.0}}, 1.5), std::invalid_argument);
}

TEST(CronbachAlphaInterval, IsAPointWhereAllClustersAreAlike) {
  const Scores scores{{1.0, 2.0}, {3.0, 2.0}, {5.0, 6.0}, {1.0, 2.0}, {3.0, 2.0}, {5.0, 6.0}};
  const std::vector<std::size_t> cluster{0, 0, 0, 1, 1, 1};
  const auto interval = cronbach_alpha_interval(scores, cluster, {.draws = 50});
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, *cronbach_alpha(scores).value, 1e-12);
  EXPECT_NEAR(interval->high, *cronbach_alpha(scores).value, 1e-12);
}

// Of two clusters each draw is both (probability ½) or one of them twice (¼ each). Their alphas are 1 and 0.75, and that of
// both together lies between: the limits are those of the clusters.
TEST(CronbachAlphaInterval, DrawsWholeClusters) {
  const Scores one{{1.0, 1.0}, {2.0, 2.0}, {3.0, 3.0}};
  const Scores other{{1.0, 2.0}, {2.0, 1.0}, {3.0, 4.0}, {4.0, 3.0}};
  Scores all = one;
  all.insert(all.end(), other.begin(), other.end());
  const std::vector<std::size_t> cluster{0, 0, 0, 1, 1, 1, 1};
  const auto interval = cronbach_alpha_interval(all, cluster);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->high, 1.0, 1e-12);
  EXPECT_NEAR(interval->low, *cronbach_alpha(other).value, 1e-1);
  EXPECT_FALSE(cronbach_alpha_interval(one, std::vector<std::size_t>{0, 0, 0}));
  EXPECT_THROW(cronbach_alpha_interval(one, std::vector<std::size_t>{0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
