// Holds intervals of effect sizes to numbers of a second program (mpmath, 30 digits: the noncentral t
// as an integral over χ, the noncentral F as a sum of beta functions, both inverted by the secant
// method), and to their limits.

#include "analysis/tests/effect_size.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/tests/friedman.h"
#include "analysis/tests/t_test.h"

namespace asperity {
namespace {

void expect_limits(const std::optional<ConfidenceInterval>& interval, double low, double high) {
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, low, 1e-9 * std::abs(low));
  EXPECT_NEAR(interval->high, high, 1e-9 * std::abs(high));
}

TEST(NoncentralityInterval, TurnsTheNoncentralTRound) {
  expect_limits(noncentrality_interval(TStatistic{.value = 2.5, .df = 9.0}), 0.182943963044932,
                4.71541229121613);
  expect_limits(noncentrality_interval(TStatistic{.value = -1.0, .df = 18.0}), -2.97319071000724,
                1.00004201127078);
  expect_limits(noncentrality_interval(TStatistic{.value = 12.25, .df = 19.0}), 7.8831411847587,
                16.5474018386006);
}

TEST(NoncentralityInterval, TurnsTheNoncentralFRound) {
  expect_limits(noncentrality_interval(FStatistic{.value = 8.5, .df1 = 3.0, .df2 = 33.0}),
                5.7975973236983, 51.4022262957801);
  const auto small = noncentrality_interval(FStatistic{.value = 0.01, .df1 = 2.0, .df2 = 20.0});
  ASSERT_TRUE(small);
  EXPECT_EQ(small->low, 0.0);
  EXPECT_EQ(small->high, 0.0);
}

TEST(NoncentralityInterval, IsAbsentWhereThereIsNone) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(noncentrality_interval(TStatistic{.value = kUnbounded, .df = 9.0}));
  EXPECT_FALSE(noncentrality_interval(TStatistic{.value = 1.0, .df = 0.0}));
  EXPECT_FALSE(noncentrality_interval(FStatistic{.value = -1.0, .df1 = 1.0, .df2 = 5.0}));
  EXPECT_THROW(noncentrality_interval(TStatistic{.value = 1.0, .df = 5.0}, 1.0),
               std::invalid_argument);
}

TEST(StandardisedDifference, HasTheLimitsOfItsT) {
  constexpr std::array kFirstGroup{5.0, 7.0, 8.0, 6.0, 9.0};
  constexpr std::array kSecondGroup{6.0, 9.0, 7.0, 11.0, 8.0, 10.0, 7.0};
  const TwoSamples samples{.first = kFirstGroup, .second = kSecondGroup};
  const std::optional<WelchT> welch = welch_t(samples);
  EXPECT_NEAR(welch->d, -0.749479708574217, 1e-13);
  expect_limits(standardised_difference_interval(*welch, samples), -1.92491586125751,
                0.460154965913587);
  // t = d·√n: 2.5 of 10 differences.
  expect_limits(standardised_mean_interval(2.5 / std::sqrt(10.0), 10.0),
                0.182943963044932 / std::sqrt(10.0), 4.71541229121613 / std::sqrt(10.0));
}

TEST(PartialEta, HasTheLimitsOfItsF) {
  expect_limits(partial_eta_interval({.value = 8.5, .df1 = 3.0, .df2 = 33.0}),
                5.7975973236983 / (5.7975973236983 + 37.0),
                51.4022262957801 / (51.4022262957801 + 37.0));
}

// SS 6, own error 2, all errors 10: 6/8 becomes 6/16.
TEST(GeneralisedEta, CountsAllErrors) {
  EXPECT_NEAR(generalised_eta(0.75, 5.0), 0.375, 1e-15);
  EXPECT_EQ(generalised_eta(1.0, 5.0), 1.0);
  EXPECT_EQ(generalised_eta(0.0, 5.0), 0.0);
}

TEST(Concordance, HasAnIntervalAroundItself) {
  Eigen::MatrixXd rows(6, 4);
  rows << 1, 2, 3, 4, 1, 3, 2, 4, 2, 1, 3, 4, 1, 2, 4, 3, 1, 2, 3, 4, 2, 1, 4, 3;
  const double W = friedman_test(rows).concordance;
  const auto interval = concordance_interval(rows);
  ASSERT_TRUE(interval);
  EXPECT_LT(interval->low, W);
  EXPECT_GT(interval->high, W);
  EXPECT_GE(interval->low, 0.0);
  EXPECT_LE(interval->high, 1.0);
  // Narrower at less confidence, and the same whatever order the rows have.
  const Eigen::MatrixXd reversed = rows.colwise().reverse();
  EXPECT_NEAR(concordance_interval(reversed)->low, interval->low, 1e-12);
  EXPECT_GT(concordance_interval(rows, 0.8)->low, interval->low);
}

TEST(Concordance, HasNoIntervalWithoutDisagreement) {
  Eigen::MatrixXd same(5, 3);
  same << 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3;
  EXPECT_FALSE(concordance_interval(same));
  EXPECT_FALSE(concordance_interval(same.topRows(3)));
}

// 2·asin√¾ − 2·asin√¼ = 2·60° − 2·30° = 60°; the error of 8 and 8 trials is ½.
TEST(CohenH, ComparesTwoProportions) {
  const ArcsineDifference h =
      cohen_h(HitCount{.hits = 6, .trials = 8}, HitCount{.hits = 2, .trials = 8});
  EXPECT_NEAR(h.h, std::acos(-1.0) / 3.0, 1e-14);
  EXPECT_NEAR(h.interval.high - h.h, 0.5 * 1.959963984540054, 1e-13);
  EXPECT_THROW(cohen_h(HitCount{.hits = 3, .trials = 2}, HitCount{.hits = 0, .trials = 1}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
