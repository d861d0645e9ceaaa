// Holds the smallest sample to powers in closed form, and its interval to its coverage.

#include "analysis/power/smallest_sample.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/power/power.h"

namespace asperity {
namespace {

constexpr double kD = 0.6;

double power_of_t(int participants) {
  return paired_t_power({.pairs = static_cast<std::size_t>(participants), .d = kD});
}

// The smallest number of pairs with a power of the t test in closed form (noncentral t): 24 of 80 %, 32 of 90 %.
int least_pairs(double power) {
  int pairs = 2;
  while (power_of_t(pairs) < power) ++pairs;
  return pairs;
}

std::vector<StudiesOfSize> studies(const std::vector<double>& powers, std::uint64_t of_each) {
  std::vector<StudiesOfSize> all{};
  int participants = 10;
  for (const double power : powers) {
    const auto hits = static_cast<std::uint64_t>(std::lround(power * static_cast<double>(of_each)));
    all.push_back({.participants = participants, .significant = {.hits = hits, .trials = of_each}});
    participants += 5;
  }
  return all;
}

// Without Monte-Carlo error the fit errs by the interpolation alone, upwards, by less than the quarter of a participant that the
// header derives.
TEST(SmallestSample, AgreesWithTheTTestInClosedForm) {
  std::vector<double> powers{};
  for (int n = 10; n <= 40; n += 5) powers.push_back(power_of_t(n));
  const std::vector<PowerOfSize> curve = monotone_power(studies(powers, 100'000'000));
  for (const double power : {0.8, 0.9}) {
    const int least = least_pairs(power);
    // The place between two whole numbers where the power is reached.
    const double exact =
        least - 1 + (power - power_of_t(least - 1)) / (power_of_t(least) - power_of_t(least - 1));
    const SmallestSample sample = smallest_sample(curve, power);
    EXPECT_EQ(sample.reached, PowerReached::within);
    ASSERT_TRUE(sample.participants && sample.low && sample.high);
    EXPECT_GT(*sample.participants, exact);
    EXPECT_LT(*sample.participants, exact + 0.3);
    EXPECT_LT(*sample.high - *sample.low, 0.1);
  }
  EXPECT_EQ(least_pairs(0.8), 24);
  EXPECT_EQ(least_pairs(0.9), 32);
}

TEST(SmallestSample, IntervalContainsTheTrueSizeAsOftenAsItStates) {
  constexpr int kRepetitions = 400;
  constexpr std::uint64_t kStudies = 500;
  const int least = least_pairs(0.8);
  const double exact =
      least - 1 + (0.8 - power_of_t(least - 1)) / (power_of_t(least) - power_of_t(least - 1));
  Random random(7);
  int contained = 0;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    std::vector<StudiesOfSize> drawn{};
    for (int n = 10; n <= 40; n += 5) {
      const double power = power_of_t(n);
      StudiesOfSize& one = drawn.emplace_back(
          StudiesOfSize{.participants = n, .significant = {.hits = 0, .trials = kStudies}});
      for (std::uint64_t i = 0; i < kStudies; ++i) one.significant.hits += random.uniform() < power;
    }
    const SmallestSample sample = smallest_sample(monotone_power(drawn), 0.8);
    contained += (!sample.low || *sample.low <= exact) && (!sample.high || exact <= *sample.high);
  }
  // Three standard errors of a proportion of .95 in 400 repetitions are .033.
  EXPECT_GE(contained, 0.95 * kRepetitions - 0.033 * kRepetitions);
}

// Proportions in the wrong order are pooled: (0.6 + 0.5)/2 for both.
TEST(MonotonePower, PoolsSizesInTheWrongOrder) {
  const std::vector<PowerOfSize> curve = monotone_power(studies({0.3, 0.6, 0.5, 0.9}, 100));
  ASSERT_EQ(curve.size(), 4U);
  EXPECT_DOUBLE_EQ(curve[1].power, 0.6);
  EXPECT_DOUBLE_EQ(curve[1].fitted, 0.55);
  EXPECT_DOUBLE_EQ(curve[2].fitted, 0.55);
  EXPECT_DOUBLE_EQ(curve[3].fitted, 0.9);
  for (const PowerOfSize& one : curve) {
    EXPECT_LT(one.fitted_interval.low, one.fitted);
    EXPECT_GT(one.fitted_interval.high, one.fitted);
    EXPECT_LT(one.interval.low, one.power);
    EXPECT_GT(one.interval.high, one.power);
  }
  for (const PowerOfSize& one : {curve[1], curve[2]}) {
    EXPECT_DOUBLE_EQ(one.fitted_interval.low,
                     0.5 * (curve[1].interval.low + curve[2].interval.low));
    EXPECT_DOUBLE_EQ(one.fitted_interval.high,
                     0.5 * (curve[1].interval.high + curve[2].interval.high));
  }
  // Half-way between 0.3 at 10 and 0.55 at 15 is 12.5 participants.
  EXPECT_DOUBLE_EQ(*smallest_sample(curve, 0.425).participants, 12.5);
}

TEST(SmallestSample, StatesThatACurveDoesNotReachThePower) {
  const std::vector<PowerOfSize> curve = monotone_power(studies({0.2, 0.4, 0.7}, 1000));
  const SmallestSample sample = smallest_sample(curve, 0.8);
  EXPECT_EQ(sample.reached, PowerReached::beyond_sizes);
  EXPECT_FALSE(sample.participants);
  EXPECT_FALSE(sample.low);
  EXPECT_FALSE(sample.high);
}

// 7 of 10 studies: the upper limit, 0.93, has the power although the proportion does not.
TEST(SmallestSample, IntervalMayBeginWithinTheSizesWhereTheCurveEndsBelow) {
  const SmallestSample sample = smallest_sample(monotone_power(studies({0.1, 0.7}, 10)), 0.8);
  EXPECT_EQ(sample.reached, PowerReached::beyond_sizes);
  ASSERT_TRUE(sample.low);
  EXPECT_GT(*sample.low, 10.0);
  EXPECT_LT(*sample.low, 15.0);
  EXPECT_FALSE(sample.high);
}

TEST(SmallestSample, StatesThatTheSmallestSizeHasThePowerAlready) {
  const SmallestSample sample = smallest_sample(monotone_power(studies({0.95, 0.99}, 1000)), 0.8);
  EXPECT_EQ(sample.reached, PowerReached::at_first);
  EXPECT_EQ(sample.participants, 10.0);
  EXPECT_FALSE(sample.low);
  EXPECT_EQ(sample.high, 10.0);
}

TEST(MonotonePower, RefusesSizesThatDoNotAscend) {
  const std::vector<StudiesOfSize> twice{
      {.participants = 5, .significant = {.hits = 1, .trials = 2}},
      {.participants = 5, .significant = {.hits = 1, .trials = 2}}};
  EXPECT_THROW(monotone_power(twice), std::invalid_argument);
  EXPECT_THROW(monotone_power({}), std::invalid_argument);
  EXPECT_THROW(smallest_sample({}, 0.8), std::invalid_argument);
  EXPECT_THROW(smallest_sample(monotone_power(studies({0.5}, 10)), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
