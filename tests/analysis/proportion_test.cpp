// Holds intervals and the exact test to their definitions, summed here term by term.

#include "analysis/numbers/proportion.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

namespace asperity {
namespace {

double probability_of(std::uint64_t hits, std::uint64_t trials, double chance) {
  double choices = 1.0;
  for (std::uint64_t i = 1; i <= hits; ++i) {
    choices *= static_cast<double>(trials - hits + i) / static_cast<double>(i);
  }
  return choices * std::pow(chance, static_cast<double>(hits)) *
         std::pow(1.0 - chance, static_cast<double>(trials - hits));
}

double at_least(const HitCount& count, double chance) {
  double sum = 0.0;
  for (std::uint64_t k = count.hits; k <= count.trials; ++k) {
    sum += probability_of(k, count.trials, chance);
  }
  return sum;
}

TEST(WilsonInterval, EndsWhereTheScoreTestRejects) {
  constexpr double kZ95 = 1.959963984540054;
  constexpr double kZ999 = 3.290526731491926;
  for (const std::uint64_t hits : {1U, 7U, 12U, 19U}) {
    for (const auto& [confidence, z] : {std::pair{0.95, kZ95}, std::pair{0.999, kZ999}}) {
      const ConfidenceInterval interval = wilson_interval({hits, 20}, confidence);
      for (const double p : {interval.low, interval.high}) {
        EXPECT_NEAR(std::abs(proportion({hits, 20}) - p), z * std::sqrt(p * (1.0 - p) / 20.0),
                    1e-12);
      }
    }
  }
}

// Without hits the upper end is z²/(n + z²): 3.841459/23.841459.
TEST(WilsonInterval, TouchesZeroAndOneExactly) {
  const ConfidenceInterval none = wilson_interval({0, 20});
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 3.841458820694124 / 23.841458820694124, 1e-14);
  const ConfidenceInterval all = wilson_interval({20, 20});
  EXPECT_NEAR(all.low, 20.0 / 23.841458820694124, 1e-14);
  EXPECT_EQ(all.high, 1.0);
}

TEST(ClopperPearsonInterval, EndsWhereTheExactTailsAreHalfTheError) {
  for (const std::uint64_t hits : {1U, 7U, 12U, 19U}) {
    for (const double confidence : {0.90, 0.95, 0.999}) {
      const ConfidenceInterval interval = clopper_pearson_interval({hits, 20}, confidence);
      EXPECT_NEAR(at_least({hits, 20}, interval.low), 0.5 * (1.0 - confidence), 1e-12);
      EXPECT_NEAR(1.0 - at_least({hits + 1, 20}, interval.high), 0.5 * (1.0 - confidence), 1e-12);
    }
  }
}

// Without hits (1 − high)ⁿ = 0.025.
TEST(ClopperPearsonInterval, TouchesZeroAndOneExactly) {
  const ConfidenceInterval none = clopper_pearson_interval({0, 20});
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 0.05), 1e-14);
  const ConfidenceInterval all = clopper_pearson_interval({20, 20});
  EXPECT_NEAR(all.low, std::pow(0.025, 0.05), 1e-14);
  EXPECT_EQ(all.high, 1.0);
}

// The published counts of three choices among three models (chance 1/3), 20 people.
TEST(ClopperPearsonInterval, AgreesWithPublishedCounts) {
  const ConfidenceInterval twelve = clopper_pearson_interval({12, 20});
  EXPECT_NEAR(twelve.low, 0.36, 0.005);
  EXPECT_NEAR(twelve.high, 0.81, 0.005);
  EXPECT_NEAR(binomial_test({12, 20}, 1.0 / 3.0), 0.016, 0.0005);
  EXPECT_NEAR(binomial_test({11, 20}, 1.0 / 3.0), 0.055, 0.0005);
  EXPECT_NEAR(binomial_test({13, 20}, 1.0 / 3.0), 0.0040, 0.00005);
  EXPECT_NEAR(binomial_test({0, 20}, 1.0 / 3.0), 0.00047, 0.000005);
  EXPECT_NEAR(binomial_test({7, 20}, 1.0 / 3.0), 1.0, 1e-12);
}

// At chance ½ both tails count: 2·(C(20,0) + … + C(20,7))/2²⁰ = 275960/1048576. That both sides of
// a symmetric distribution are in is what the relative tolerance is for.
TEST(BinomialTest, CountsEquallyProbableOutcomesOnBothSides) {
  EXPECT_NEAR(binomial_test({7, 20}, 0.5), 275960.0 / 1048576.0, 1e-14);
  EXPECT_NEAR(binomial_test({13, 20}, 0.5), 275960.0 / 1048576.0, 1e-14);
  for (std::uint64_t n = 1; n <= 60; ++n) {
    for (std::uint64_t k = 0; 2 * k < n; ++k) {
      const double both = 2.0 * (1.0 - at_least({k + 1, n}, 0.5));
      EXPECT_NEAR(binomial_test({k, n}, 0.5), both, 1e-11) << k << " of " << n;
    }
  }
}

// 9 of 10 at chance 1/4: 9 and 10 alone are as improbable; 0 has (3/4)¹⁰ = 0.056.
TEST(BinomialTest, LeavesOutWhatIsMoreProbable) {
  EXPECT_NEAR(binomial_test({9, 10}, 0.25), 31.0 / 1048576.0, 1e-17);
}

// 18 of 20 at chance 1/24: far in the tail the digits remain. Terms 18, 19, 20 over 24²⁰.
TEST(BinomialTest, KeepsItsDigitsInTheTail) {
  const double terms = 190.0 * 23.0 * 23.0 + 20.0 * 23.0 + 1.0;
  EXPECT_NEAR(binomial_test({18, 20}, 1.0 / 24.0) / (terms / std::pow(24.0, 20.0)), 1.0, 1e-11);
}

TEST(BinomialTest, KnowsCertainty) {
  EXPECT_EQ(binomial_test({0, 5}, 0.0), 1.0);
  EXPECT_EQ(binomial_test({1, 5}, 0.0), 0.0);
  EXPECT_EQ(binomial_test({5, 5}, 1.0), 1.0);
  EXPECT_EQ(binomial_test({4, 5}, 1.0), 0.0);
}

TEST(Proportion, RefusesWhatIsNoCount) {
  EXPECT_THROW(proportion({0, 0}), std::invalid_argument);
  EXPECT_THROW(wilson_interval({0, 0}), std::invalid_argument);
  EXPECT_THROW(clopper_pearson_interval({3, 2}), std::invalid_argument);
  EXPECT_THROW(wilson_interval({1, 2}, 1.0), std::invalid_argument);
  EXPECT_THROW(clopper_pearson_interval({1, 2}, 0.0), std::invalid_argument);
  EXPECT_THROW(binomial_test({1, 2}, -0.1), std::invalid_argument);
  EXPECT_THROW(binomial_test({1, 2}, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
