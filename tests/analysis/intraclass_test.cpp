// Holds intraclass correlations to the published example and to their limits.

#include "analysis/intraclass.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// Six targets of four judges [Shrout 1979], table 2; the correlations are those of their table 4, to two
// digits.
Eigen::MatrixXd published() {
  Eigen::MatrixXd ratings(6, 4);
  ratings << 9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7;
  return ratings;
}

TEST(Reliability, IsThatOfThePublishedExample) {
  const auto reliability = reliability_of(published());
  ASSERT_TRUE(reliability);
  constexpr std::array kPublished{0.17, 0.29, 0.71, 0.44, 0.62, 0.91};
  for (std::size_t i = 0; i < kPublished.size(); ++i) {
    EXPECT_NEAR(reliability->correlations[i].value, kPublished[i], 0.005)
        << reliability->correlations[i].name;
  }
  const IntraclassCorrelation& consistency = reliability->correlations[2];
  EXPECT_EQ(consistency.name, "ICC3");
  EXPECT_EQ(consistency.df2, 15.0);
  ASSERT_TRUE(consistency.interval);
  EXPECT_LT(consistency.interval->low, consistency.value);
  EXPECT_GT(consistency.interval->high, consistency.value);
}

TEST(Reliability, OfJudgesWhoDifferByAConstantIsConsistentAndNotInAgreement) {
  Eigen::MatrixXd ratings(4, 2);
  ratings << 1, 3, 2, 4, 4, 6, 7, 9;
  const auto reliability = reliability_of(ratings);
  ASSERT_TRUE(reliability);
  EXPECT_EQ(reliability->correlations[2].value, 1.0);
  EXPECT_TRUE(std::isinf(reliability->correlations[2].F));
  EXPECT_FALSE(reliability->correlations[2].interval);
  EXPECT_LT(reliability->correlations[1].value, 1.0);
  EXPECT_EQ(reliability->standard_error_of_measurement, 0.0);
}

// The raters have equal means, and contradict each other on the targets. ICC2 and its lower limit are below −1/2, where
// Spearman's and Brown's formula would give a correlation of 6 for the mean of three ratings.
TEST(Reliability, OfTheMeanOfRatingsThatContradictEachOtherIsMinusInfinity) {
  Eigen::MatrixXd ratings(4, 3);
  ratings << 1, 2, 3, 2, 3, 1, 3, 1, 2, 2, 2, 3;
  const auto reliability = reliability_of(ratings);
  ASSERT_TRUE(reliability);
  const IntraclassCorrelation& one = reliability->correlations[1];
  const IntraclassCorrelation& mean = reliability->correlations[4];
  ASSERT_TRUE(one.interval);
  EXPECT_LT(one.value, -0.5);
  EXPECT_EQ(mean.value, -std::numeric_limits<double>::infinity());
  ASSERT_TRUE(mean.interval);
  EXPECT_EQ(mean.interval->low, -std::numeric_limits<double>::infinity());
  const double high = one.interval->high;
  EXPECT_NEAR(mean.interval->high, 3.0 * high / (1.0 + 2.0 * high), 1e-12);
}

TEST(Reliability, IsThereOnlyWhereSomethingDiffers) {
  EXPECT_FALSE(reliability_of(Eigen::MatrixXd::Constant(3, 3, 0.1)));
  EXPECT_THROW(reliability_of(Eigen::MatrixXd::Ones(3, 1)), std::invalid_argument);
  EXPECT_THROW(reliability_of(Eigen::MatrixXd::Constant(3, 3, std::nan(""))),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
