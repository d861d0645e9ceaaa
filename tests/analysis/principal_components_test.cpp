// Holds principal components to R, to their identities, and to cases that can be written down.

#include "analysis/scales/principal_components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/analysis/computed_in_r/r_results.h"

namespace asperity {
namespace {

Eigen::MatrixXd six_scales() {
  const RTable table("scales.csv");
  Eigen::MatrixXd values(static_cast<Eigen::Index>(table.rows()), 6);
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (Eigen::Index scale = 0; scale < 6; ++scale) {
      values(row, scale) =
          table.number(static_cast<std::size_t>(row), static_cast<std::size_t>(scale));
    }
  }
  return values;
}

// R's prcomp takes singular values of the table: another algorithm, which agrees to about 10⁻¹³ times
// the ratio of the largest to the smallest eigenvalue.
TEST(PrincipalComponents, AreThoseOfR) {
  const auto components = principal_components(six_scales());
  ASSERT_TRUE(components);
  const RResults expected("scales_expected.csv");
  for (Eigen::Index j = 0; j < 6; ++j) {
    const std::string component = std::to_string(j + 1);
    EXPECT_NEAR(components->eigenvalues(j), expected.at("eigenvalue", component), 1e-10);
    EXPECT_NEAR(components->proportion(j), expected.at("eigenvalue", component) / 6.0, 1e-10);
    for (Eigen::Index scale = 0; scale < 6; ++scale) {
      EXPECT_NEAR(components->loadings(scale, j),
                  expected.at("loading", std::to_string(scale + 1) + '|' + component), 1e-9);
    }
    for (const Eigen::Index item : {1, 17, 40}) {
      EXPECT_NEAR(components->scores(item - 1, j),
                  expected.at("score", std::to_string(item) + '|' + component), 1e-9);
    }
  }
}

// Correlation r: eigenvalues 1 ± r, and both scales load √((1 + r)/2) on the first component.
TEST(PrincipalComponents, OfTwoScalesFollowFromTheirCorrelation) {
  Eigen::MatrixXd values(4, 2);
  values << 1, 10, 2, 30, 3, 20, 4, 40;  // ranks 1 to 4 and 1 3 2 4: r = 0.8
  const auto components = principal_components(values);
  ASSERT_TRUE(components);
  EXPECT_NEAR(components->eigenvalues(0), 1.8, 1e-12);
  EXPECT_NEAR(components->eigenvalues(1), 0.2, 1e-12);
  EXPECT_NEAR(components->loadings(0, 0), std::sqrt(0.9), 1e-12);
  EXPECT_NEAR(components->loadings(1, 0), std::sqrt(0.9), 1e-12);
  EXPECT_NEAR(components->loadings(0, 1), std::sqrt(0.1),
              1e-12);  // of equal ones the first is positive
  EXPECT_NEAR(components->loadings(1, 1), -std::sqrt(0.1), 1e-12);
}

TEST(PrincipalComponents, HaveScoresWhoseVariancesAreTheEigenvalues) {
  const auto components = principal_components(six_scales());
  ASSERT_TRUE(components);
  const Eigen::MatrixXd covariance =
      components->scores.transpose() * components->scores / (40.0 - 1.0);
  EXPECT_LT(
      (covariance - Eigen::MatrixXd(components->eigenvalues.asDiagonal())).cwiseAbs().maxCoeff(),
      1e-12);
  EXPECT_LT(components->scores.colwise().sum().cwiseAbs().maxCoeff(), 1e-11);
}

TEST(PrincipalComponents, DoNotDependOnUnitsAndTurnWithTheDirectionOfAScale) {
  const Eigen::MatrixXd values = six_scales();
  Eigen::MatrixXd others = values;
  others.col(3) = 1000.0 * values.col(3).array() + 7.0;
  others.col(5) *= -1.0;
  const auto before = principal_components(values);
  const auto after = principal_components(others);
  ASSERT_TRUE(before && after);
  EXPECT_LT((before->eigenvalues - after->eigenvalues).cwiseAbs().maxCoeff(), 1e-11);
  // Scale 6 has the largest loading on component 1, and stays positive: the others turn.
  EXPECT_NEAR(after->loadings(5, 0), before->loadings(5, 0), 1e-10);
  EXPECT_NEAR(after->loadings(4, 0), -before->loadings(4, 0), 1e-10);
}

// Scale 3 is the sum of the first two: the last eigenvalue is 0, and its component is empty.
TEST(PrincipalComponents, OfDependentScalesEndWithEmptyComponents) {
  Eigen::MatrixXd values = six_scales().leftCols(3);
  values.col(2) = values.col(0) + values.col(1);
  const auto components = principal_components(values);
  ASSERT_TRUE(components);
  EXPECT_EQ(components->eigenvalues(2), 0.0);
  EXPECT_EQ(components->loadings.col(2).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(components->scores.col(2).cwiseAbs().maxCoeff(), 0.0);
}

TEST(PrincipalComponents, DoNotExistWhereAScaleIsConstant) {
  Eigen::MatrixXd values = six_scales();
  EXPECT_FALSE(constant_column(values));
  values.col(2).setConstant(0.1);
  ASSERT_TRUE(constant_column(values));
  EXPECT_EQ(*constant_column(values), 2);
  EXPECT_FALSE(principal_components(values));
}

TEST(PrincipalComponents, RefuseImpossibleTables) {
  EXPECT_THROW(principal_components(Eigen::MatrixXd::Random(2, 4)), std::invalid_argument);
  EXPECT_THROW(principal_components(Eigen::MatrixXd::Random(5, 1)), std::invalid_argument);
  Eigen::MatrixXd values = six_scales();
  values(0, 0) = std::nan("");
  EXPECT_THROW(principal_components(values), std::invalid_argument);
}

// 1000 data sets against 40 000 in R. The standard error of a percentile is √(p·q/n)/density, here at
// most about 0.008; five of them.
TEST(ParallelAnalysis, HasTheLimitsOfR) {
  const auto components = principal_components(six_scales());
  ASSERT_TRUE(components);
  const ParallelAnalysis analysis = parallel_analysis(components->eigenvalues, 40);
  const RResults expected("scales_expected.csv");
  for (Eigen::Index j = 0; j < 6; ++j) {
    const std::string component = std::to_string(j + 1);
    EXPECT_NEAR(analysis.limits(j), expected.at("parallel.limit", component), 0.04);
    EXPECT_NEAR(analysis.means(j), expected.at("parallel.mean", component), 0.02);
  }
  EXPECT_EQ(analysis.data_sets, 1000U);
  EXPECT_EQ(analysis.retained, 2U);  // the scales were made of two common variables
}

TEST(ParallelAnalysis, HasTheSameBitsInWhateverOrderDataSetsAreComputed) {
  const Eigen::VectorXd eigenvalues = Eigen::Vector3d(1.9, 0.7, 0.4);
  const Random random(7);
  const ParallelAnalysis in_order = parallel_analysis(eigenvalues, 12, {.data_sets = 50}, random);
  std::vector<Eigen::VectorXd> backwards{};
  for (std::uint64_t i = 50; i-- > 0;) {
    backwards.push_back(eigenvalues_of_noise({.rows = 12, .columns = 3}, random.split(i)));
  }
  const ParallelAnalysis jobs = compared_with_noise(eigenvalues, backwards);
  EXPECT_EQ(in_order.limits, jobs.limits);
  EXPECT_EQ(in_order.means, jobs.means);
  EXPECT_NE(in_order.limits,
            parallel_analysis(eigenvalues, 12, {.data_sets = 50}, Random(8)).limits);
}

TEST(ParallelAnalysis, RetainsNoComponentAfterOneThatItRejects) {
  const std::vector<Eigen::VectorXd> noise{Eigen::Vector3d(1.5, 1.0, 0.5)};
  EXPECT_EQ(compared_with_noise(Eigen::Vector3d(1.4, 1.1, 0.5), noise).retained, 0U);
  EXPECT_EQ(compared_with_noise(Eigen::Vector3d(1.6, 0.8, 0.6), noise).retained, 1U);
}

TEST(ParallelAnalysis, RefusesImpossibleQuestions) {
  const Eigen::VectorXd eigenvalues = Eigen::Vector3d(1.9, 0.7, 0.4);
  EXPECT_THROW(parallel_analysis(eigenvalues, 12, {.data_sets = 0}), std::invalid_argument);
  EXPECT_THROW(parallel_analysis(eigenvalues, 2), std::invalid_argument);
  EXPECT_THROW(parallel_analysis(eigenvalues, 12, {.data_sets = 5, .percentile = 1.0}),
               std::invalid_argument);
  const std::vector<Eigen::VectorXd> noise{Eigen::Vector2d(1.5, 0.5)};
  EXPECT_THROW(compared_with_noise(eigenvalues, noise), std::invalid_argument);
}

/// Correlation of two scales over the items without the participants' deviations, from sums over cells.
double corrected_correlation(const std::vector<Eigen::MatrixXd>& participants) {
  const auto n = static_cast<double>(participants.size());
  const Eigen::Index items = participants.front().rows();
  const auto mean_of_cell = [&](Eigen::Index item, Eigen::Index scale) {
    double sum = 0.0;
    for (const Eigen::MatrixXd& own : participants) sum += own(item, scale);
    return sum / n;
  };
  const auto product = [&](Eigen::Index j, Eigen::Index k) {
    double of_means = 0.0;
    double of_rest = 0.0;
    const auto grand = [&](Eigen::Index scale) {
      double sum = 0.0;
      for (Eigen::Index item = 0; item < items; ++item) sum += mean_of_cell(item, scale);
      return sum / static_cast<double>(items);
    };
    for (Eigen::Index item = 0; item < items; ++item) {
      of_means += (mean_of_cell(item, j) - grand(j)) * (mean_of_cell(item, k) - grand(k));
      for (const Eigen::MatrixXd& own : participants) {
        const auto rest = [&](Eigen::Index scale) {
          return own(item, scale) - mean_of_cell(item, scale) - own.col(scale).mean() +
                 grand(scale);
        };
        of_rest += rest(j) * rest(k);
      }
    }
    return of_means - of_rest / (n * (n - 1.0));
  };
  return product(0, 1) / std::sqrt(product(0, 0) * product(1, 1));
}

// Two scales with the correlation r have the first proportion p = (1 + r)/2, and ln(p/(1 − p)) = 2·artanh r.
TEST(CorrectedComponents, OfTwoScalesAreThoseOfTheirCorrectedCorrelation) {
  Random random(11);
  std::vector<Eigen::MatrixXd> participants(6, six_scales().leftCols(2));
  for (Eigen::MatrixXd& own : participants) {
    own.col(1) = own.col(0);
    for (Eigen::Index item = 0; item < own.rows(); ++item)
      own(item, 1) += 0.8 * static_cast<double>(item % 3);
    for (double& rating : own.reshaped()) rating += 0.7 * random.normal();
  }
  const double of_all = 2.0 * std::atanh(corrected_correlation(participants));
  std::vector<double> pseudo_values{};
  for (std::size_t left_out = 0; left_out < 6; ++left_out) {
    std::vector<Eigen::MatrixXd> others = participants;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    pseudo_values.push_back(6.0 * of_all - 5.0 * 2.0 * std::atanh(corrected_correlation(others)));
  }
  double mean = 0.0;
  for (const double one : pseudo_values) mean += one / 6.0;
  double squares = 0.0;
  for (const double one : pseudo_values) squares += (one - mean) * (one - mean);
  const double half = 2.570581835636314 * std::sqrt(squares / 5.0 / 6.0);  // t of 5 df, 97.5 %
  const auto corrected = corrected_components(participants);
  ASSERT_TRUE(corrected && corrected->proportions.at(0));
  const ComponentEstimate& first = *corrected->proportions[0];
  const auto logistic = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  EXPECT_NEAR(first.corrected, logistic(of_all), 1e-9);
  EXPECT_NEAR(first.interval.low, logistic(of_all - half), 1e-9);
  EXPECT_NEAR(first.interval.high, logistic(of_all + half), 1e-9);
}

// Deviations of the size of the items' differences: over 24 studies of eight participants the observed first proportion is too
// small on average, and the corrected one is not.
TEST(CorrectedComponents, HaveTheFirstProportionWithoutTheDeviations) {
  Eigen::MatrixXd values = six_scales().leftCols(3);
  for (Eigen::Index item = 0; item < values.rows(); ++item) {
    const double common = values(item, 0);
    values(item, 1) = common + 1.2 * static_cast<double>(item % 3);
    values(item, 2) = common - 1.5 * static_cast<double>(item % 2);
  }
  const double truth = principal_components(values)->proportion(0);
  Random random(3);
  double observed = 0.0;
  double corrected = 0.0;
  constexpr int kStudies = 24;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<Eigen::MatrixXd> participants(8, values);
    for (Eigen::MatrixXd& own : participants) {
      for (double& rating : own.reshaped()) rating += 1.2 * random.normal();
    }
    observed += principal_components(mean_table(participants))->proportion(0) / kStudies;
    const auto found = corrected_components(participants);
    ASSERT_TRUE(found && found->proportions.at(0));
    const ComponentEstimate& first = *found->proportions[0];
    corrected += first.corrected / kStudies;
    EXPECT_LT(first.interval.low, first.corrected);
    EXPECT_GT(first.interval.high, first.corrected);
    EXPECT_LT(first.interval.high, 1.0);
  }
  EXPECT_LT(observed, truth);
  EXPECT_LT(std::abs(corrected - truth), 0.5 * std::abs(observed - truth));
}

TEST(CorrectedComponents, NeedFiveParticipantsWithEveryRating) {
  const Eigen::MatrixXd values = six_scales();
  Random random(4);
  std::vector<Eigen::MatrixXd> participants(5, values);
  for (Eigen::MatrixXd& own : participants) {
    for (double& rating : own.reshaped()) rating += 0.5 * random.normal();
  }
  EXPECT_TRUE(corrected_components(participants));
  EXPECT_FALSE(corrected_components(std::span(participants).first(4)));
  participants.front()(0, 0) = std::nan("");
  EXPECT_FALSE(corrected_components(participants));
  for (Eigen::MatrixXd& own : participants) own(0, 0) = std::nan("");
  participants.front()(0, 0) = 1.0;
  EXPECT_EQ(mean_table(participants)(0, 0), 1.0);
}

}  // namespace
}  // namespace asperity
