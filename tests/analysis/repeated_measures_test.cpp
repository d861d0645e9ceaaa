// Holds the analysis of variance to t tests, and to tables without any error.

#include "analysis/tests/repeated_measures.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

const AnovaEffect& effect(const AnovaTable& table, std::size_t i) { return table.effects.at(i); }

// Two levels: F is the square of the paired t. Differences 1, 2, 3, 2: t = 2/(√(2/3)/2).
TEST(RepeatedMeasures, OfTwoLevelsAreAPairedT) {
  RepeatedMeasures data{.levels = {2}};
  data.y.resize(4, 2);
  data.y << 0, 1, 5, 7, 2, 5, 1, 3;
  const AnovaTable table = repeated_measures_anova(data);
  EXPECT_NEAR(*effect(table, 0).F, 24.0, 1e-12);
  EXPECT_EQ(effect(table, 0).df2, 3.0);
  EXPECT_FALSE(effect(table, 0).sphericity);
}

// With groups of equal size both kinds of sums of squares are the same, with others not.
TEST(RepeatedMeasures, DependOnTheTypeOnlyForUnequalGroups) {
  RepeatedMeasures data{.levels = {2}, .group = {0, 0, 1, 1}, .groups = 2};
  data.y.resize(4, 2);
  data.y << 0, 1, 5, 7, 2, 9, 1, 3;
  const auto squares = [&](SumsOfSquares type) {
    return effect(repeated_measures_anova(data, type), 1).sum_of_squares;
  };
  EXPECT_NEAR(squares(SumsOfSquares::type_2), squares(SumsOfSquares::type_3), 1e-12);
  data.group = {0, 1, 1, 1};
  EXPECT_GT(std::abs(squares(SumsOfSquares::type_2) - squares(SumsOfSquares::type_3)), 0.1);
}

TEST(RepeatedMeasures, HaveNoMauchlyTestWithFewerPeopleThanContrasts) {
  RepeatedMeasures data{.levels = {4}};
  data.y.resize(3, 4);
  data.y << 1, 3, 2, 5, 2, 2, 6, 4, 0, 4, 3, 9;
  const AnovaTable table = repeated_measures_anova(data);
  const auto& sphericity = effect(table, 0).sphericity;
  ASSERT_TRUE(sphericity);
  EXPECT_FALSE(sphericity->mauchly);
  EXPECT_GE(*sphericity->gg, 1.0 / 3.0);
}

TEST(RepeatedMeasures, WithoutAnyErrorHaveNoF) {
  RepeatedMeasures data{.y = Eigen::MatrixXd::Ones(4, 3), .levels = {3}};
  const AnovaTable table = repeated_measures_anova(data);
  EXPECT_FALSE(effect(table, 0).F);
  EXPECT_FALSE(effect(table, 0).p);
}

// Every participant gives the same number everywhere, and 0.1 is none that a computer has.
TEST(RepeatedMeasures, OfEqualNumbersHaveNoEffectMadeOfRounding) {
  RepeatedMeasures data{.levels = {2, 3}};
  data.y = Eigen::VectorXd::LinSpaced(6, 0.1, 5.3).replicate(1, 6);
  const AnovaTable table = repeated_measures_anova(data);
  ASSERT_EQ(table.effects.size(), 3U);
  for (const AnovaEffect& each : table.effects) {
    EXPECT_EQ(each.sum_of_squares, 0.0);
    EXPECT_EQ(each.error_sum_of_squares, 0.0);
    EXPECT_FALSE(each.F);
    EXPECT_FALSE(each.pes);
    EXPECT_FALSE(each.omega2);
  }
  // A real effect of a part in a thousand million is none of rounding.
  data.y.col(0).array() += 1e-9;
  EXPECT_GT(effect(repeated_measures_anova(data), 0).sum_of_squares, 1e-20);
}

TEST(RepeatedMeasures, RefuseTablesThatAreNone) {
  EXPECT_THROW(repeated_measures_anova({.y = Eigen::MatrixXd::Ones(1, 3), .levels = {3}}),
               std::invalid_argument);
  EXPECT_THROW(repeated_measures_anova({.y = Eigen::MatrixXd::Ones(4, 3), .levels = {2}}),
               std::invalid_argument);
  EXPECT_THROW(
      repeated_measures_anova(
          {.y = Eigen::MatrixXd::Ones(4, 3), .levels = {3}, .group = {0, 0, 0, 0}, .groups = 2}),
      std::invalid_argument);
}

// On 1, 2, 4 the quadratic contrast is orthogonal to 1 and to the levels.
TEST(OrthonormalPolynomials, AreOrthonormalOnUnequalLevels) {
  const Eigen::MatrixXd p = orthonormal_polynomials(Eigen::Vector3d(1, 2, 4), 2);
  EXPECT_NEAR((p.transpose() * p - Eigen::Matrix2d::Identity()).norm(), 0.0, 1e-14);
  EXPECT_NEAR(p.colwise().sum().norm(), 0.0, 1e-14);
  EXPECT_GT(p(2, 0), 0.0);
  EXPECT_NEAR(p(0, 1) / p(1, 1), -2.0 / 3.0, 1e-13);
  EXPECT_THROW(orthonormal_polynomials(Eigen::Vector3d(1, 2, 2), 2), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
