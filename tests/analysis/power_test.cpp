// Holds power to plans that can be counted by hand.

#include "analysis/power.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace asperity
