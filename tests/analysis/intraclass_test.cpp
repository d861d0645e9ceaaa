// Holds intraclass correlations to the published example and to their limits.

#include "analysis/scales/intraclass.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

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

// ICC() of R's package psych 2.2.9 (lmer = FALSE), whose limits are those of McGraw and Wong (1996),
// to the digits that it was printed with.
TEST(Reliability, HasTheLimitsOfR) {
  const auto reliability = reliability_of(published());
  ASSERT_TRUE(reliability);
  struct Expected {
    std::string_view name{};
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
  };
  constexpr std::array<Expected, 6> kOfR{{
      {"ICC1", 0.165741768405, -0.132932324875, 0.722560062328},
      {"ICC2", 0.289763779528, 0.018786513375, 0.761084369649},
      {"ICC3", 0.714840714841, 0.342464765034, 0.945858259955},
      {"ICC1k", 0.442797133679, -0.884442155238, 0.912415420341},
      {"ICC2k", 0.620050547599, 0.071136815303, 0.927232040168},
      {"ICC3k", 0.909315542377, 0.675674713816, 0.985891678169},
  }};
  for (std::size_t i = 0; i < kOfR.size(); ++i) {
    const IntraclassCorrelation& one = reliability->correlations[i];
    EXPECT_EQ(one.name, kOfR[i].name);
    EXPECT_NEAR(one.value, kOfR[i].value, 1e-11) << one.name;
    ASSERT_TRUE(one.interval);
    EXPECT_NEAR(one.interval->low, kOfR[i].low, 1e-10) << one.name;
    EXPECT_NEAR(one.interval->high, kOfR[i].high, 1e-10) << one.name;
  }
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
