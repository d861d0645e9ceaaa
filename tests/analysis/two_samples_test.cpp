// Holds the exact tests of two groups to splits and tables counted by hand.

#include "analysis/tests/two_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/models/mixed_logit.h"
#include "analysis/tests/two_by_two.h"

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

std::optional<NoMixedLogit> reason_of(const std::variant<MixedLogit, NoMixedLogit>& result) {
  const auto* reason = std::get_if<NoMixedLogit>(&result);
  return reason == nullptr ? std::nullopt : std::optional(*reason);
}

TEST(MixedLogit, HasNoSpreadWherePeopleAreAlike) {
  const std::array kAlike{person(4, false), person(4, false), person(4, false),
                          person(6, true),  person(6, true),  person(6, true)};
  EXPECT_EQ(reason_of(mixed_logit(kAlike)), NoMixedLogit::no_spread);
  EXPECT_NEAR(fixed_logit(kAlike)->beta.second_group, std::log(3.0), 1e-14);
  EXPECT_NEAR(fixed_logit(kAlike)->cluster_standard_error.intercept, 0.0, 1e-14);
}

TEST(MixedLogit, HasNoFiniteEffectWhereAGroupIsAllRight) {
  const std::array kRight{person(8, false), person(8, false), person(6, true), person(3, true)};
  EXPECT_FALSE(fixed_logit(kRight));
  EXPECT_EQ(reason_of(mixed_logit(kRight)), NoMixedLogit::separated);
}

// One trial each: any spread explains them as well as none.
TEST(MixedLogit, IsFlatInOneTrialEach) {
  std::vector<GroupedHits> people;
  for (std::uint64_t i = 0; i < 12; ++i) {
    people.push_back(
        {.count = {.hits = i % 3 == 0 ? 0U : 1U, .trials = 1}, .second_group = i % 2 == 0});
  }
  EXPECT_EQ(reason_of(mixed_logit(people)), NoMixedLogit::flat);
}

std::vector<GroupedHits> of_three_trials(std::initializer_list<std::uint64_t> first,
                                         std::initializer_list<std::uint64_t> second) {
  std::vector<GroupedHits> people;
  for (const std::uint64_t hits : first) people.push_back({{hits, 3}, false});
  for (const std::uint64_t hits : second) people.push_back({{hits, 3}, true});
  return people;
}

// All or nothing of every participant: the likelihood grows with the spread without end.
TEST(MixedLogit, HasNoMaximumWhereNobodyHasHitsAndMisses) {
  std::vector<GroupedHits> people =
      of_three_trials({0, 3, 3, 3, 0, 3, 3, 0, 3, 3}, {0, 0, 3, 0, 0, 3, 0, 0, 0, 3, 0});
  EXPECT_EQ(reason_of(mixed_logit(people)), NoMixedLogit::unbounded_spread);
  // One participant with both is enough for a maximum, at a large spread. Simpson's rule over
  // u = −9 … 9 at 40 000 points gives the same likelihood.
  people.push_back({{1, 3}, true});
  const auto result = mixed_logit(people);
  ASSERT_TRUE(std::holds_alternative<MixedLogit>(result));
  const MixedLogit& fit = std::get<MixedLogit>(result);
  EXPECT_GT(fit.sigma, 5.0);
  const auto log_likelihood = [&people](double intercept, double effect, double sigma) {
    double sum = 0.0;
    for (const GroupedHits& one : people) {
      constexpr int kPoints = 40'000;
      constexpr double kHalf = 9.0;
      const double step = 2.0 * kHalf / kPoints;
      double integral = 0.0;
      for (int i = 0; i <= kPoints; ++i) {
        const double u = -kHalf + i * step;
        const double p =
            1.0 / (1.0 + std::exp(-(intercept + (one.second_group ? effect : 0.0) + sigma * u)));
        const auto hits = static_cast<double>(one.count.hits);
        const double weight = i == 0 || i == kPoints ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        integral += weight * std::pow(p, hits) * std::pow(1.0 - p, 3.0 - hits) *
                    std::exp(-0.5 * u * u) / std::sqrt(2.0 * std::numbers::pi);
      }
      const double ways = one.count.hits % 3 == 0 ? 1.0 : 3.0;
      sum += std::log(ways * integral * step / 3.0);
    }
    return sum;
  };
  const double at = log_likelihood(fit.beta.intercept, fit.beta.second_group, fit.sigma);
  EXPECT_NEAR(fit.log_likelihood, at, 1e-9);
  for (const double factor : {0.98, 1.02}) {
    EXPECT_LT(log_likelihood(fit.beta.intercept * factor, fit.beta.second_group, fit.sigma), at);
    EXPECT_LT(log_likelihood(fit.beta.intercept, fit.beta.second_group * factor, fit.sigma), at);
    EXPECT_LT(log_likelihood(fit.beta.intercept, fit.beta.second_group, fit.sigma * factor), at);
  }
}

TEST(FixedLogit, HasNoClusterErrorOfASingleParticipant) {
  const std::array kOne{person(4, false), person(5, false), person(6, true)};
  const auto fit = fixed_logit(kOne);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->cluster_standard_error.intercept, 0.0);
  EXPECT_TRUE(std::isnan(fit->cluster_standard_error.second_group));
}

}  // namespace
}  // namespace asperity
