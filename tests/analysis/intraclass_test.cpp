// Holds intraclass correlations to the published example and to their limits.

#include "analysis/intraclass.h"

#include <array>
#include <cmath>
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

TEST(Reliability, IsThereOnlyWhereSomethingDiffers) {
  EXPECT_FALSE(reliability_of(Eigen::MatrixXd::Constant(3, 3, 0.1)));
  EXPECT_THROW(reliability_of(Eigen::MatrixXd::Ones(3, 1)), std::invalid_argument);
  EXPECT_THROW(reliability_of(Eigen::MatrixXd::Constant(3, 3, std::nan(""))),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
