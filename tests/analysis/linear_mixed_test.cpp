// Holds the linear mixed model to the analysis of variance, where both are the same, and to designs without a fit. Unbalanced
// designs are compared with R in tests/analysis/reference/lmm_NN.

#include "analysis/models/linear_mixed.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Participants × conditions; the design has a column for each condition but the first.
GroupedMeasurements measurements_of(const Eigen::MatrixXd& table) {
  GroupedMeasurements data{.design = Eigen::MatrixXd::Zero(table.size(), table.cols()),
                           .y = Eigen::VectorXd(table.size())};
  Eigen::Index at = 0;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    for (Eigen::Index column = 0; column < table.cols(); ++column, ++at) {
      data.design(at, 0) = 1.0;
      if (column > 0) data.design(at, column) = 1.0;
      data.y(at) = table(row, column);
      data.participant.push_back(static_cast<std::size_t>(row));
    }
  }
  return data;
}

Eigen::MatrixXd paired_table() {
  Eigen::MatrixXd table(5, 2);
  table << 3.0, 4.0, 5.0, 5.5, 8.0, 9.5, 2.0, 2.5, 6.0, 8.5;
  return table;
}

LinearMixedFit fitted(const GroupedMeasurements& data) {
  const auto answer = linear_mixed(data);
  if (std::holds_alternative<NoLinearMixed>(answer)) throw std::runtime_error("there is no fit");
  return std::get<LinearMixedFit>(answer);
}

NoLinearMixed reason(const GroupedMeasurements& data) {
  return std::get<NoLinearMixed>(linear_mixed(data));
}

// Differences 1, 0.5, 1.5, 0.5, 2.5: mean 1.2, Σ(d − 1.2)² = 2.8, SD √0.7, standard error √0.14. Of the differences 2σ² is the
// variance; the participants' means 3.5, 5.25, 8.75, 2.25, 7.25 have the variance σ_b² + σ²/2.
TEST(LinearMixed, OfTwoConditionsIsThePairedTTest) {
  const LinearMixedFit fit = fitted(measurements_of(paired_table()));
  const LinearMixedFit::Combination difference = fit.effect(1);
  EXPECT_NEAR(difference.estimate, 1.2, 1e-12);
  EXPECT_NEAR(difference.standard_error, std::sqrt(0.14), 1e-12);
  EXPECT_NEAR(difference.df, 4.0, 1e-9);
  EXPECT_NEAR(fit.residual_variance(), 0.35, 1e-12);
  const double mean = (3.5 + 5.25 + 8.75 + 2.25 + 7.25) / 5.0;
  double squares = 0.0;
  for (const double one : {3.5, 5.25, 8.75, 2.25, 7.25}) squares += (one - mean) * (one - mean);
  EXPECT_NEAR(fit.participant_variance(), squares / 4.0 - 0.175, 1e-12);
  EXPECT_NEAR(fit.intraclass_correlation(),
              fit.participant_variance() / (fit.participant_variance() + 0.35), 1e-14);
  // t₄(.975) = 2.776445…
  EXPECT_NEAR(difference.interval.low, 1.2 - 2.7764451051977987 * std::sqrt(0.14), 1e-8);
  EXPECT_NEAR(difference.interval.high, 1.2 + 2.7764451051977987 * std::sqrt(0.14), 1e-8);
}

TEST(LinearMixed, OfSeveralConditionsIsTheRepeatedMeasuresAnova) {
  Eigen::MatrixXd table(4, 3);
  table << 1.0, 2.0, 4.0, 3.0, 3.0, 5.0, 2.0, 4.0, 3.5, 6.0, 7.0, 9.0;
  const Eigen::VectorXd of_participant = table.rowwise().mean();
  const Eigen::RowVectorXd of_condition = table.colwise().mean();
  const Eigen::MatrixXd rest =
      (table.colwise() - of_participant).rowwise() - (of_condition.array() - table.mean()).matrix();
  const double error = rest.squaredNorm() / 6.0;
  const double between = 4.0 * (of_condition.array() - table.mean()).square().sum() / 2.0;
  const LinearMixedFit fit = fitted(measurements_of(table));
  const LinearMixedFit::JointTest test = fit.joint_test({.first = 1, .count = 2});
  EXPECT_NEAR(fit.residual_variance(), error, 1e-10);
  EXPECT_NEAR(test.F, between / error, 1e-9);
  EXPECT_EQ(test.df1, 2.0);
  EXPECT_NEAR(test.df2, 6.0, 1e-8);
  const LinearMixedFit::JointTest one = fit.joint_test({.first = 2, .count = 1});
  EXPECT_NEAR(one.F, std::pow(fit.effect(2).t, 2.0), 1e-10);
  EXPECT_NEAR(one.p, fit.effect(2).p, 1e-10);
}

// A number that is added to all changes the intercept alone, even if it is large.
TEST(LinearMixed, DependsOnDifferencesOnly) {
  const GroupedMeasurements data = measurements_of(paired_table());
  const LinearMixedFit at_0 = fitted(data);
  for (const double added : {1e6, 1e12}) {  // the sums are those of halves, which are exact
    SCOPED_TRACE(added);
    GroupedMeasurements shifted = data;
    shifted.y.array() += added;
    const LinearMixedFit fit = fitted(shifted);
    EXPECT_NEAR(fit.beta()(0), at_0.beta()(0) + added, 1e-15 * added + 1e-6);
    EXPECT_NEAR(fit.beta()(1), at_0.beta()(1), 1e-8);
    EXPECT_NEAR(fit.residual_variance(), at_0.residual_variance(), 1e-8);
    EXPECT_NEAR(fit.standard_error()(0), at_0.standard_error()(0), 1e-8);
    EXPECT_NEAR(fit.log_likelihood(), at_0.log_likelihood(), 1e-8);
  }
}

// Of times in milliseconds since 1970 a covariate has the spread of a session.
TEST(LinearMixed, HasACovariateWhoseSpreadIsSmall) {
  GroupedMeasurements data = measurements_of(paired_table());
  data.design.col(1) << 0, 7, 1, 6, 2, 5, 3, 4, 8, 9;
  const LinearMixedFit at_0 = fitted(data);
  data.design.col(1).array() += 1.7e12;
  EXPECT_THAT(dependent_columns(data.design), IsEmpty());
  EXPECT_NEAR(fitted(data).beta()(1), at_0.beta()(1), 1e-8);
  data.design.col(1).setConstant(1.7e12 + 0.1);
  EXPECT_THAT(dependent_columns(data.design), ElementsAre(1));
}

TEST(LinearMixed, RecoversWhatItsDataWereDrawnFrom) {
  Random random(7);
  GroupedMeasurements data{.design = Eigen::MatrixXd::Ones(4000, 2), .y = Eigen::VectorXd(4000)};
  for (std::size_t participant = 0; participant < 200; ++participant) {
    const double own = 0.5 * random.normal();
    for (std::size_t trial = 0; trial < 20; ++trial) {
      const auto row = static_cast<Eigen::Index>(20 * participant + trial);
      data.design(row, 1) = static_cast<double>(trial) / 10.0;
      data.y(row) = 1.0 + own - 0.2 * data.design(row, 1) + 0.8 * random.normal();
      data.participant.push_back(participant);
    }
  }
  const LinearMixedFit fit = fitted(data);
  const LinearMixedFit::Combination trend = fit.effect(1);
  EXPECT_NEAR(trend.estimate, -0.2, 3.0 * trend.standard_error);
  EXPECT_LT(trend.p, 1e-6);
  EXPECT_NEAR(trend.df, 3799.0, 1.0);  // 4000 − 200 participants − 1 effect within them
  EXPECT_NEAR(fit.participant_variance(), 0.25, 0.08);
  EXPECT_NEAR(fit.residual_variance(), 0.64, 0.05);
}

TEST(LinearMixed, HasAReasonInPlaceOfAFit) {
  Eigen::MatrixXd one_row(3, 1);
  one_row << 1.0, 2.0, 4.0;
  EXPECT_EQ(reason(measurements_of(one_row)), NoLinearMixed::too_few_rows);
  EXPECT_EQ(reason(measurements_of(paired_table().topRows(1))),
            NoLinearMixed::too_few_participants);
  EXPECT_EQ(reason(measurements_of(Eigen::MatrixXd::Constant(4, 2, 0.1))),
            NoLinearMixed::no_residual_variance);
  // The participants differ by constants, and so do the conditions.
  Eigen::MatrixXd additive(3, 2);
  additive << 1.0, 1.5, 2.0, 2.5, 7.0, 7.5;
  EXPECT_EQ(reason(measurements_of(additive)), NoLinearMixed::no_residual_variance);
  // The conditions alone determine every number, of which 1/3 and 2/3 are rounded.
  for (const double unit : {1.0, 1.0 / 3.0, 1e-9}) {
    Eigen::MatrixXd determined(8, 2);
    determined.col(0).setConstant(0.0);
    determined.col(1).setConstant(unit);
    EXPECT_EQ(reason(measurements_of(determined)), NoLinearMixed::no_residual_variance) << unit;
    determined.array() += 2.0 / 3.0;
    EXPECT_EQ(reason(measurements_of(determined)), NoLinearMixed::no_residual_variance) << unit;
  }
  // All participants have the same mean.
  Eigen::MatrixXd alike(3, 3);
  alike << 1.0, 2.0, 3.0, 3.0, 1.0, 2.0, 2.0, 3.0, 1.0;
  EXPECT_EQ(reason(measurements_of(alike)), NoLinearMixed::no_participant_variance);
  GroupedMeasurements twice = measurements_of(paired_table());
  twice.design.conservativeResize(Eigen::NoChange, 3);
  twice.design.col(2) = 3.0 - 2.0 * twice.design.col(1).array();
  EXPECT_EQ(reason(twice), NoLinearMixed::dependent_effects);
  // Two participants in two groups: nothing is left to estimate their variance from.
  GroupedMeasurements groups = measurements_of(paired_table().topRows(2));
  groups.design.col(1) << 0.0, 0.0, 1.0, 1.0;
  EXPECT_EQ(reason(groups), NoLinearMixed::too_few_participants);
}

TEST(LinearMixed, RefusesDataThatAreNone) {
  GroupedMeasurements data = measurements_of(paired_table());
  data.participant.pop_back();
  EXPECT_THROW(linear_mixed(data), std::invalid_argument);
  data = measurements_of(paired_table());
  data.y(3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(linear_mixed(data), std::invalid_argument);
  data = measurements_of(paired_table());
  data.design(3, 0) = 0.0;
  EXPECT_THROW(linear_mixed(data), std::invalid_argument);
  const LinearMixedFit fit = fitted(measurements_of(paired_table()));
  EXPECT_THROW(fit.combination(Eigen::VectorXd::Zero(2)), std::invalid_argument);
  EXPECT_THROW(fit.joint_test({.first = 1, .count = 2}), std::invalid_argument);
}

TEST(LinearMixed, FindsColumnsThatCombineOthers) {
  Eigen::MatrixXd design(6, 5);
  design.col(0).setOnes();
  design.col(1) << 1, 2, 3, 4, 5, 6;
  design.col(2).setConstant(0.1);
  design.col(3) << 0, 1, 0, 1, 0, 1;
  design.col(4) = 1e6 + 2.0 * design.col(1).array() - design.col(3).array();
  EXPECT_THAT(dependent_columns(design), ElementsAre(2, 4));
  design(0, 4) += 1.0;
  EXPECT_THAT(dependent_columns(design), ElementsAre(2));
  EXPECT_THAT(dependent_columns(design.leftCols(2)), IsEmpty());
}

}  // namespace
}  // namespace asperity
