// Holds quantiles in buckets to the sorted numbers.

#include "analysis/power/positive_quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// The numbers 1.01^0, …, 1.01^999: the k-th smallest is 1.01^(k − 1).
TEST(PositiveQuantiles, DifferFromTheSortedNumbersByAThousandth) {
  PositiveQuantiles quantiles{};
  for (int i = 999; i >= 0; --i) quantiles.add(std::pow(1.01, i));
  EXPECT_EQ(quantiles.count(), 1000U);
  for (const double p : {0.0, 0.001, 0.5, 0.9, 1.0}) {
    const double rank = std::max(1.0, std::ceil(p * 1000.0));
    const double exact = std::pow(1.01, rank - 1.0);
    EXPECT_NEAR(*quantiles.quantile(p), exact, 0.001000001 * exact) << p;
  }
}

TEST(PositiveQuantiles, CountZeroAndInfinity) {
  PositiveQuantiles quantiles{};
  for (const double number : {0.0, 2.0, std::numeric_limits<double>::infinity()}) {
    quantiles.add(number);
  }
  EXPECT_EQ(quantiles.quantile(0.3), 0.0);
  EXPECT_NEAR(*quantiles.quantile(0.5), 2.0, 0.002);
  EXPECT_EQ(quantiles.quantile(1.0), std::numeric_limits<double>::infinity());
}

TEST(PositiveQuantiles, OfNoNumbersDoNotExist) { EXPECT_FALSE(PositiveQuantiles{}.quantile(0.5)); }

TEST(PositiveQuantiles, RefuseNegativeNumbersAndProbabilitiesOutsideTheRange) {
  PositiveQuantiles quantiles{};
  EXPECT_THROW(quantiles.add(-1.0), std::invalid_argument);
  EXPECT_THROW(quantiles.add(std::nan("")), std::invalid_argument);
  EXPECT_THROW(quantiles.quantile(1.1), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
