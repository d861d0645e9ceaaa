// Holds means, spreads and quantiles to numbers worked out by hand.

#include "analysis/numbers/summary.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// Of 1 … 10: h = 9·p, so 9·0.05 = 0.45 lies between 1 and 2.
TEST(Quantile, IsOfTypeSeven) {
  const std::vector<double> sorted{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.05), 1.45);
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.25), 3.25);
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.5), 5.5);
  EXPECT_DOUBLE_EQ(quantile(sorted, 0.95), 9.55);
  EXPECT_DOUBLE_EQ(quantile(sorted, 1.0), 10.0);
  EXPECT_EQ(quantile(std::array{4.0}, 0.3), 4.0);
}

TEST(Quantile, RefusesNothingAndAWrongProbability) {
  EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(quantile(std::array{4.0}, 1.1), std::invalid_argument);
  EXPECT_THROW(quantile(std::array{4.0}, std::nan("")), std::invalid_argument);
}

// 4, 1, 3, 2: mean 2.5, squares 5, sd √(5/3).
TEST(Summary, DoesNotCareForOrder) {
  const Summary summary = summary_of(std::array{4.0, 1.0, 3.0, 2.0}).value();
  EXPECT_EQ(summary.n, 4U);
  EXPECT_DOUBLE_EQ(summary.mean, 2.5);
  EXPECT_DOUBLE_EQ(summary.sd, std::sqrt(5.0 / 3.0));
  EXPECT_EQ(summary.minimum, 1.0);
  EXPECT_DOUBLE_EQ(summary.p05, 1.15);
  EXPECT_DOUBLE_EQ(summary.p50, 2.5);
  EXPECT_DOUBLE_EQ(summary.p95, 3.85);
  EXPECT_EQ(summary.maximum, 4.0);
}

// Squares about the mean, not the difference of two large sums.
TEST(Summary, KeepsTheSpreadOfLargeNumbers) {
  EXPECT_EQ(summary_of(std::array{1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0})->sd, 1.0);
}

TEST(Summary, OfOneSampleHasNoSpread) {
  const Summary summary = summary_of(std::array{7.0}).value();
  EXPECT_EQ(summary.sd, 0.0);
  EXPECT_EQ(summary.p05, 7.0);
}

TEST(Summary, IsAbsentWithoutSamplesAndRefusesNaN) {
  EXPECT_FALSE(summary_of({}));
  EXPECT_THROW(summary_of(std::array{1.0, std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
