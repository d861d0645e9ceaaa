// Holds numbers of participants to rounds of a design and to the binomial distribution.

#include "analysis/power/recruitment.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/numbers/proportion.h"

namespace asperity {
namespace {

TEST(Recruitment, RoundsUpToWholeRoundsOfTheDesign) {
  EXPECT_EQ(rounded_up_to_multiple(22.3, 1), 23U);
  EXPECT_EQ(rounded_up_to_multiple(22.3, 8), 24U);
  EXPECT_EQ(rounded_up_to_multiple(24.0, 8), 24U);
  EXPECT_EQ(rounded_up_to_multiple(24.0 + 1e-12, 8), 24U);
  EXPECT_EQ(rounded_up_to_multiple(24.1, 8), 32U);
  EXPECT_EQ(rounded_up_to_multiple(0.4, 6), 6U);
  EXPECT_THROW(rounded_up_to_multiple(0.0, 4), std::invalid_argument);
  EXPECT_THROW(rounded_up_to_multiple(3.0, 0), std::invalid_argument);
}

// 24/(0.9·0.95) = 28.07.
TEST(Recruitment, OnAverageDividesByTheProportionThatIsRetained) {
  const Recruitment recruited = recruitment(24, {.dropout = 0.1, .exclusion = 0.05});
  EXPECT_DOUBLE_EQ(recruited.retained, 0.855);
  EXPECT_EQ(recruited.on_average, 29U);
}

TEST(Recruitment, OfWholeQuotientsIsNotRoundedUp) {
  EXPECT_EQ(recruitment(18, {.dropout = 0.1}).on_average, 20U);
}

TEST(Recruitment, AssuredIsTheLeastNumberWithItsProbability) {
  const Recruitment recruited = recruitment(24, {.dropout = 0.1, .exclusion = 0.05}, 0.9);
  const auto enough = [](std::size_t number) {
    return binomial_upper_tail({.hits = 24, .trials = number}, 0.855);
  };
  EXPECT_GE(enough(recruited.assured), 0.9);
  EXPECT_LT(enough(recruited.assured - 1), 0.9);
}

// One of at least: 1 − 0.5^N ≥ 0.9 first holds for N = 4.
TEST(Recruitment, AssuredOfOneIsGeometric) {
  EXPECT_EQ(recruitment(1, {.dropout = 0.5}, 0.9).assured, 4U);
}

TEST(Recruitment, WithoutLossesIsWhatIsNeeded) {
  const Recruitment recruited = recruitment(24, {});
  EXPECT_EQ(recruited.on_average, 24U);
  EXPECT_EQ(recruited.assured, 24U);
}

TEST(Recruitment, RefusesImpossibleRates) {
  EXPECT_THROW(recruitment(24, {.dropout = 1.0}), std::invalid_argument);
  EXPECT_THROW(recruitment(24, {.exclusion = -0.1}), std::invalid_argument);
  EXPECT_THROW(recruitment(0, {}), std::invalid_argument);
  EXPECT_THROW(recruitment(24, {}, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
