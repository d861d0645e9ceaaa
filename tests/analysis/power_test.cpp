// Holds power to plans that can be counted by hand.

#include "analysis/power/power.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/proportion.h"
#include "analysis/tests/two_by_two.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

// Five coins: five hits have the probability 1/32, four or more 6/32.
TEST(Power, OfFiveCoinsIsThatOfFiveHits) {
  const ExactPower power =
      binomial_power({.trials = 5, .chance = 0.5, .truth = 0.9, .error = 0.05});
  EXPECT_EQ(power.critical, 5U);
  EXPECT_NEAR(power.actual_error, 1.0 / 32.0, 1e-15);
  EXPECT_NEAR(power.power, std::pow(0.9, 5), 1e-14);
}

TEST(Power, OfTooFewTrialsIsNone) {
  const ExactPower power = binomial_power({.trials = 4, .chance = 0.5, .truth = 1.0});
  EXPECT_FALSE(power.critical);
  EXPECT_EQ(power.power, 0.0);
}

// Without an effect every test rejects as often as by chance.
TEST(Power, WithoutAnEffectIsTheError) {
  EXPECT_NEAR(paired_t_power({.pairs = 9, .d = 0.0, .error = 0.03}), 0.03, 1e-15);
  EXPECT_NEAR(within_power({.participants = 9, .levels = 4, .error = 0.03}).power, 0.03, 1e-15);
  const UniformPower uniform = uniform_power({.choices = 9, .truth = {0.25, 0.25, 0.25, 0.25}});
  EXPECT_NEAR(uniform.power, uniform.actual_error, 1e-12);
  const MatchingPower matching = mallows_power({.assignments = 6, .items = 4}, 0.0);
  EXPECT_NEAR(matching.exact.power, matching.exact.actual_error, 1e-14);
  EXPECT_NEAR(matching.mean_right, 1.0, 1e-14);
}

// Hits that hang together make the pooled test reject too often.
TEST(Power, OfThePooledTestGrowsWithTheCorrelation) {
  const PooledPlan plan{
      .participants = 20, .trials_each = 3, .chance = 0.5, .truth = 0.5, .correlation = 1e-6};
  PooledPlan clustered = plan;
  clustered.correlation = 0.4;
  EXPECT_LT(pooled_rejection(plan).rate, 0.05);
  EXPECT_GT(pooled_rejection(clustered).rate, 0.08);
  EXPECT_NEAR(pooled_rejection(clustered).design_effect, 1.8, 1e-14);
}

TEST(Power, RefusesWhatIsNoPlan) {
  EXPECT_THROW(binomial_power({.trials = 0}), std::invalid_argument);
  EXPECT_THROW(binomial_power({.trials = 4, .error = 0.0}), std::invalid_argument);
  EXPECT_THROW(uniform_power({.choices = 4, .truth = {0.5, 0.6}}), std::invalid_argument);
  EXPECT_THROW(known_items_power({.assignments = 2, .items = 4}, 5), std::invalid_argument);
}

TEST(Power, OfTheTwoSidedBinomialTestIsThatOfTheCountsThatItRejects) {
  for (const std::size_t trials : {1U, 2U, 7U, 20U, 61U}) {
    for (const double chance : {0.0, 0.04, 0.25, 0.5, 0.9, 1.0}) {
      for (const double truth : {0.0, 0.3, 0.97, 1.0}) {
        for (const double error : {0.001, 0.05, 0.6}) {
          ExactPower counted;
          for (std::size_t hits = 0; hits <= trials; ++hits) {
            if (binomial_test({.hits = hits, .trials = trials}, chance) > error) continue;
            const double ways = std::exp(std::lgamma(static_cast<double>(trials) + 1.0) -
                                         std::lgamma(static_cast<double>(hits) + 1.0) -
                                         std::lgamma(static_cast<double>(trials - hits) + 1.0));
            const auto probability = [&](double p) {
              return ways * std::pow(p, static_cast<double>(hits)) *
                     std::pow(1.0 - p, static_cast<double>(trials - hits));
            };
            counted.actual_error += probability(chance);
            counted.power += probability(truth);
          }
          const ExactPower power = binomial_two_sided_power(
              {.trials = trials, .chance = chance, .truth = truth, .error = error});
          EXPECT_NEAR(power.actual_error, counted.actual_error, 1e-12) << trials << ' ' << chance;
          EXPECT_NEAR(power.power, counted.power, 1e-12) << trials << ' ' << chance << ' ' << truth;
        }
      }
    }
  }
}

// All tables of two groups, each judged by the test itself.
ExactPower counted_one_by_one(const TwoGroupPlan& plan) {
  const auto probability = [](std::size_t trials, double p, std::size_t hits) {
    return std::exp(std::lgamma(static_cast<double>(trials) + 1.0) -
                    std::lgamma(static_cast<double>(hits) + 1.0) -
                    std::lgamma(static_cast<double>(trials - hits) + 1.0)) *
           std::pow(p, static_cast<double>(hits)) *
           std::pow(1.0 - p, static_cast<double>(trials - hits));
  };
  ExactPower sum;
  for (std::size_t x = 0; x <= plan.first_trials; ++x) {
    for (std::size_t y = 0; y <= plan.second_trials; ++y) {
      const double p = fisher_two_sided({.first = {.hits = x, .trials = plan.first_trials},
                                         .second = {.hits = y, .trials = plan.second_trials}});
      if (p > plan.error * (1.0 + 1e-12)) continue;
      const double first = probability(plan.first_trials, plan.first_truth, x);
      sum.power += first * probability(plan.second_trials, plan.second_truth, y);
      sum.actual_error += first * probability(plan.second_trials, plan.first_truth, y);
    }
  }
  return sum;
}

TEST(Power, OfFishersTestIsThatOfItsTables) {
  for (const auto& [first, second] :
       {std::pair{1U, 1U}, {3U, 3U}, {7U, 12U}, {20U, 5U}, {33U, 40U}}) {
    for (const auto& [p, q] :
         {std::pair{0.5, 0.5}, {0.2, 0.7}, {0.0, 0.9}, {1.0, 0.3}, {0.95, 0.05}}) {
      for (const double error : {0.001, 0.05, 0.1, 0.5}) {
        const TwoGroupPlan plan{.first_trials = first,
                                .second_trials = second,
                                .first_truth = p,
                                .second_truth = q,
                                .error = error};
        const ExactPower counted = counted_one_by_one(plan);
        const ExactPower power = fisher_power(plan);
        EXPECT_NEAR(power.power, counted.power, 1e-12) << first << ' ' << second << ' ' << p;
        EXPECT_NEAR(power.actual_error, counted.actual_error, 1e-12);
      }
    }
  }
}

// Minutes, if every table were judged by itself. With so many trials the test is that of two normal distributions:
// a difference of 0.015 is 3 standard errors, of which 1.96 are needed, and a little for whole numbers.
TEST(Power, OfFishersTestIsCountedForTwentyThousandTrialsInEachGroup) {
  const ExactPower power = fisher_power({.first_trials = 20'000,
                                         .second_trials = 20'000,
                                         .first_truth = 0.5,
                                         .second_truth = 0.515,
                                         .error = 0.05});
  EXPECT_NEAR(power.actual_error, 0.05, 0.002);
  EXPECT_LT(power.actual_error, 0.05);
  EXPECT_NEAR(power.power, 0.849, 0.01);
}

TEST(Power, OfThePooledTestIsRefusedWhereItTakesMinutes) {
  const PooledPlan plan{.participants = 100'000,
                        .trials_each = 100'000,
                        .chance = 0.5,
                        .truth = 0.6,
                        .correlation = 0.1};
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { pooled_rejection(plan); }),
              testing::AllOf(testing::HasSubstr(
                                 "participants is 100000 and that of the trials of each is 100000"),
                             testing::HasSubstr("plan fewer trials per participant")));
  // Many participants with few trials are quick, and one with many.
  PooledPlan many = plan;
  many.trials_each = 3;
  EXPECT_NEAR(pooled_rejection(many).rate, 1.0, 1e-12);
  PooledPlan one = plan;
  one.participants = 1;
  EXPECT_GT(pooled_rejection(one).rate, 0.5);
}

TEST(Power, OfMatchingIsCountedForManyAssignments) {
  const MatchingPower power = mallows_power({.assignments = 100'000, .items = 4}, 0.0);
  EXPECT_NEAR(power.exact.actual_error, 0.05, 0.002);
  EXPECT_NEAR(power.exact.power, power.exact.actual_error, 1e-12);
}

}  // namespace
}  // namespace asperity
