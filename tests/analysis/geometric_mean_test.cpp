// Holds the geometric mean to Student's interval of the logarithms.

#include "analysis/tests/geometric_mean.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(GeometricMean, HasStudentsIntervalOnTheLogarithmicScale) {
  // ln 1, ln 2, ln 4 are 0, ln 2, 2·ln 2: mean and SD ln 2, standard error ln 2/√3, t₂(.975) = 4.3026….
  const GeometricMean mean = geometric_mean(std::vector{1.0, 2.0, 4.0});
  EXPECT_EQ(mean.n, 3U);
  EXPECT_NEAR(mean.mean, 2.0, 1e-14);
  const double factor = std::exp(4.302652729749464 * std::log(2.0) / std::sqrt(3.0));
  ASSERT_TRUE(mean.interval);
  EXPECT_NEAR(mean.interval->low, 2.0 / factor, 1e-12);
  EXPECT_NEAR(mean.interval->high, 2.0 * factor, 1e-11);
}

TEST(GeometricMean, HasNoIntervalWithoutASpread) {
  EXPECT_FALSE(geometric_mean(std::vector{3.0}).interval);
  EXPECT_FALSE(geometric_mean(std::vector{0.1, 0.1, 0.1}).interval);
}

TEST(GeometricMean, RefusesWhatHasNoLogarithm) {
  EXPECT_THROW(geometric_mean(std::vector<double>{}), std::invalid_argument);
  EXPECT_THROW(geometric_mean(std::vector{1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(geometric_mean(std::vector{1.0, -2.0}), std::invalid_argument);
  EXPECT_THROW(geometric_mean(std::vector{1.0, std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
