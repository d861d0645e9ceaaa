// Holds tails to closed forms, and to answers where the distribution has none.

#include "analysis/numbers/tail_probabilities.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// With two degrees of freedom χ² is exponential, and F with 2 and 2 has the tail 1/(1 + F).
TEST(TailProbabilities, AreTheClosedFormsWhereThereAreSome) {
  EXPECT_NEAR(*upper_tail(ChiSquaredStatistic{.value = 600.0, .df = 2.0}) / std::exp(-300.0), 1.0,
              1e-12);
  EXPECT_NEAR(*upper_tail(FStatistic{.value = 3.0, .df1 = 2.0, .df2 = 2.0}), 0.25, 1e-15);
  // One degree of freedom is Cauchy's distribution.
  EXPECT_NEAR(*two_sided_tail(TStatistic{.value = -1.0, .df = 1.0}), 0.5, 1e-15);
  EXPECT_NEAR(*t_limit({.confidence = 0.5, .df = 1.0}), 1.0, 1e-14);
}

TEST(TailProbabilities, HaveTheLimitsOfStatisticsWithoutBounds) {
  EXPECT_EQ(upper_tail(FStatistic{.value = kInfinite, .df1 = 1.0, .df2 = 3.0}), 0.0);
  EXPECT_EQ(two_sided_tail(TStatistic{.value = -kInfinite, .df = 3.0}), 0.0);
  EXPECT_EQ(upper_tail(TStatistic{.value = -kInfinite, .df = 3.0}), 1.0);
  EXPECT_EQ(upper_tail(ChiSquaredStatistic{.value = -1e-17, .df = 1.0}), 1.0);
}

TEST(TailProbabilities, AreNothingWhereNothingIsDefined) {
  EXPECT_FALSE(upper_tail(FStatistic{.value = 1.0, .df1 = 1.0, .df2 = 0.0}));
  EXPECT_FALSE(upper_tail(ChiSquaredStatistic{.value = 0.0, .df = 0.0}));
  EXPECT_FALSE(upper_tail(FStatistic{.value = kNoNumber, .df1 = 1.0, .df2 = 1.0}));
  EXPECT_FALSE(upper_tail(ChiSquaredStatistic{.value = kNoNumber, .df = 1.0}));
  EXPECT_FALSE(two_sided_tail(TStatistic{.value = 1.0, .df = -1.0}));
  EXPECT_FALSE(t_limit({.confidence = 0.95, .df = 0.0}));
}

}  // namespace
}  // namespace asperity
