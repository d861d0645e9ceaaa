// Holds the exact tests of two groups to splits and tables counted by hand.

#include "analysis/two_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/mixed_logit.h"
#include "analysis/two_by_two.h"

namespace asperity {
namespace {

constexpr std::array kLow{1.0, 2.0, 3.0};
constexpr std::array kHigh{4.0, 5.0, 6.0};

// Of the 20 splits of six numbers in order only the observed one and its mirror image are as far.
TEST(TwoSamples, AreAsFarApartInTwoOfTwentySplits) {
  EXPECT_NEAR(permutation_test({.first = kLow, .second = kHigh}).p, 0.1, 1e-15);
  const MannWhitney ranks = mann_whitney({.first = kLow, .second = kHigh});
  EXPECT_EQ(ranks.U, 0.0);
  EXPECT_NEAR(*ranks.p_exact, 0.1, 1e-15);
}

TEST(TwoSamples, OfEqualNumbersAreNoDifference) {
  constexpr std::array kSame{0.3, 0.3, 0.3};
  EXPECT_EQ(permutation_test({.first = kSame, .second = kSame}).p, 1.0);
  const MannWhitney ranks = mann_whitney({.first = kSame, .second = kSame});
  EXPECT_EQ(ranks.U, 4.5);
  EXPECT_NEAR(*ranks.p_exact, 1.0, 1e-15);
  EXPECT_FALSE(ranks.p_normal);
  EXPECT_FALSE(welch_t({.first = kSame, .second = kSame}));
}

// Of the C(6, 3) = 20 splits of 1 to 6 those are as far from half of 21 as 1 + 2 + 5 = 1 + 3 + 4 whose
// sum is 6, 7 or 8: one, one and two, and as many at the other end. In units that are no whole numbers
// the two are equal but for rounding.
TEST(TwoSamples, AreSplitAlikeInWhateverUnit) {
  for (const double unit : {1e-15 / 3.0, 0.1, 1.0, 1e12 / 3.0}) {
    for (const double start : {0.0, 1000.0, -1000.0}) {
      const auto in_units = [&](double number) { return (start + number) * unit; };
      const std::array first{in_units(1.0), in_units(2.0), in_units(5.0)};
      const std::array second{in_units(3.0), in_units(4.0), in_units(6.0)};
      EXPECT_NEAR(permutation_test({.first = first, .second = second}).p, 0.4, 1e-15)
          << unit << ' ' << start;
    }
  }
}

// 15 zeros and 15 ones of which all but k stand in their own sample: of the C(30, 15) ways to split
// them, C(15, j)² have j ones among the first 15.
TEST(TwoSamples, AreSplitAtRandomWhereThereAreTooManyWays) {
  std::vector<double> first(15, 0.0);
  std::vector<double> second(15, 1.0);
  for (std::size_t i = 0; i < 5; ++i) std::swap(first[i], second[i]);
  double ways[16] = {1.0};
  for (int j = 1; j < 16; ++j) ways[j] = ways[j - 1] * (16.0 - j) / j;
  double as_far = 0.0;
  double all = 0.0;
  for (int j = 0; j < 16; ++j) {
    all += ways[j] * ways[j];
    if (j <= 5 || j >= 10) as_far += ways[j] * ways[j];
  }
  const SplitTest test = permutation_test({.first = first, .second = second});
  EXPECT_FALSE(test.exact);
  const double p = as_far / all;
  EXPECT_NEAR(test.p, p, 4.0 * std::sqrt(p * (1.0 - p) / kRandomSplits));
  EXPECT_EQ(test.p, permutation_test({.first = first, .second = second}).p) << "the same again";
  // What no split reaches is not impossible.
  std::fill(first.begin(), first.end(), 0.0);
  std::fill(second.begin(), second.end(), 1.0);
  EXPECT_EQ(permutation_test({.first = first, .second = second}).p, 1.0 / (kRandomSplits + 1.0));
}

// The approximation stands in where the exact distribution is too large, and must have been near.
TEST(TwoSamples, HaveANormalApproximationWhereTheyAreMany) {
  std::vector<double> first;
  std::vector<double> second;
  for (int i = 0; i < 60; ++i) {
    first.push_back(i % 17);
    second.push_back(1.5 + i % 19);
  }
  const MannWhitney exact = mann_whitney({.first = first, .second = second});
  EXPECT_NEAR(*exact.p_exact, *exact.p_normal, 0.005);
  second.push_back(3.0);
  EXPECT_FALSE(mann_whitney({.first = first, .second = second}).p_exact);
}

// 3 of 3 against 0 of 3: one of 20 tables on either side.
TEST(FisherTest, CountsTheTablesWithTheseMargins) {
  const TwoByTwo table{.first = {.hits = 3, .trials = 3}, .second = {.hits = 0, .trials = 3}};
  const FisherTest test = fisher_test(table);
  EXPECT_NEAR(test.p_two_sided, 0.1, 1e-14);
  EXPECT_NEAR(test.p_greater, 0.05, 1e-14);
  EXPECT_NEAR(test.p_less, 1.0, 1e-14);
  EXPECT_EQ(test.odds_ratio, std::numeric_limits<double>::infinity());
  EXPECT_EQ(test.interval.high, std::numeric_limits<double>::infinity());
  EXPECT_GT(test.interval.low, 0.0);
}

TEST(FisherTest, LearnsNothingWhereEverybodyIsRight) {
  const TwoByTwo table{.first = {.hits = 4, .trials = 4}, .second = {.hits = 5, .trials = 5}};
  const FisherTest test = fisher_test(table);
  EXPECT_TRUE(test.margins_decide);
  EXPECT_EQ(test.p_two_sided, 1.0);
}

GroupedHits person(std::uint64_t hits, bool second) {
  return {.count = {.hits = hits, .trials = 8}, .second_group = second};
}

TEST(MixedLogit, HasNoSpreadWherePeopleAreAlike) {
  const std::array kAlike{person(4, false), person(4, false), person(4, false),
                          person(6, true),  person(6, true),  person(6, true)};
  EXPECT_FALSE(mixed_logit(kAlike));
  EXPECT_NEAR(fixed_logit(kAlike)->beta.second_group, std::log(3.0), 1e-14);
  EXPECT_NEAR(fixed_logit(kAlike)->cluster_standard_error.intercept, 0.0, 1e-14);
}

TEST(MixedLogit, HasNoFiniteEffectWhereAGroupIsAllRight) {
  const std::array kRight{person(8, false), person(8, false), person(6, true), person(3, true)};
  EXPECT_FALSE(fixed_logit(kRight));
  EXPECT_FALSE(mixed_logit(kRight));
}

// One trial each: any spread explains them as well as none.
TEST(MixedLogit, SeesNoSpreadInOneTrialEach) {
  std::vector<GroupedHits> people;
  for (std::uint64_t i = 0; i < 12; ++i) {
    people.push_back(
        {.count = {.hits = i % 3 == 0 ? 0U : 1U, .trials = 1}, .second_group = i % 2 == 0});
  }
  EXPECT_FALSE(mixed_logit(people));
}

}  // namespace
}  // namespace asperity
