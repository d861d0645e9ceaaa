// Holds circular triads and agreement to counts of all outcomes and to published examples.

#include "analysis/choices/circular_triads.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/analysis/computed_in_r/r_results.h"

namespace asperity {
namespace {

Comparison judged(std::size_t first, std::size_t second, std::optional<std::size_t> winner) {
  return {.first = first, .second = second, .winner = winner};
}

// One triad A > B > C > A is as circular as three items can be.
TEST(Consistency, CountsCircularTriads) {
  const std::vector<std::size_t> circle{1, 1, 1};
  EXPECT_EQ(consistency(circle).circular_triads, 1.0);
  EXPECT_EQ(consistency(circle).zeta, 0.0);
  const std::vector<std::size_t> order{3, 2, 1, 0};
  EXPECT_EQ(consistency(order).circular_triads, 0.0);
  EXPECT_EQ(consistency(order).zeta, 1.0);
  // Six items, of which three beat each other in a circle: one triad of at most eight.
  const std::vector<std::size_t> mostly_ordered{5, 4, 3, 1, 1, 1};
  EXPECT_EQ(consistency(mostly_ordered).circular_triads, 1.0);
  EXPECT_EQ(consistency(mostly_ordered).zeta, 0.875);
}

TEST(Consistency, RefusesWinsThatAreNotOfAllPairs) {
  EXPECT_THROW(consistency(std::vector<std::size_t>{1, 0}), std::invalid_argument);
  EXPECT_THROW(consistency(std::vector<std::size_t>{1, 1, 0}), std::invalid_argument);
}

TEST(WinsOfJudge, AreThoseOfOneComparisonOfEachPair) {
  std::vector<Comparison> all{judged(0, 1, 1), judged(2, 1, 2), judged(0, 2, 2)};
  const WinsOfJudge wins = wins_of_judge(all, 3);
  EXPECT_FALSE(wins.problem);
  EXPECT_EQ(wins.wins, (std::vector<std::size_t>{0, 1, 2}));
  all.push_back(judged(1, 0, 1));
  EXPECT_EQ(wins_of_judge(all, 3).problem, IncompletePairs::pair_repeated);
  EXPECT_TRUE(wins_of_judge(all, 3).wins.empty());
  all.resize(2);
  EXPECT_EQ(wins_of_judge(all, 3).problem, IncompletePairs::pair_missing);
  all.push_back(judged(0, 2, {}));
  EXPECT_EQ(wins_of_judge(all, 3).problem, IncompletePairs::tie);
  EXPECT_THROW(wins_of_judge(all, 2), std::invalid_argument);
}

// R examined every triad of every outcome.
TEST(CircularTriads, HaveTheDistributionOfAllOutcomes) {
  const RResults expected("paired_comparisons_expected.csv");
  for (std::size_t items = 4; items <= 6; ++items) {
    const IntegerDistribution distribution = circular_triad_distribution(items);
    const double all = std::exp2(static_cast<double>(items * (items - 1) / 2));
    for (std::size_t d = 0; d < distribution.probability.size(); ++d) {
      EXPECT_EQ(distribution.probability[d] * all,
                expected.at("triads." + std::to_string(items), d));
    }
    EXPECT_FALSE(expected.has("triads." + std::to_string(items),
                              std::to_string(distribution.probability.size())));
  }
}

// Each of the K(K−1)(K−2)/6 triads is circular with probability 1/4, and two of them are uncorrelated:
// the mean is a quarter of their number, the variance 3/16 of it [Kendall 1940].
TEST(CircularTriads, HaveTheMeanAndVarianceOfIndependentTriads) {
  for (std::size_t items = 3; items <= kMostItemsForExactTriads; ++items) {
    const IntegerDistribution distribution = circular_triad_distribution(items);
    const auto triads = static_cast<double>(items * (items - 1) * (items - 2) / 6);
    EXPECT_NEAR(distribution.mean(), triads / 4.0, 1e-10);
    EXPECT_NEAR(distribution.variance(), triads * 3.0 / 16.0, 1e-9);
  }
}

TEST(TriadTest, IsExactForFewItems) {
  // 24 of the 64 outcomes of four items have no circular triad, 40 at most one.
  EXPECT_EQ(triad_test(0, 4).p, 0.375);
  EXPECT_EQ(triad_test(1, 4).p, 0.625);
  EXPECT_EQ(triad_test(2, 4).p, 1.0);
  EXPECT_TRUE(triad_test(0, 4).exact);
  EXPECT_FALSE(triad_test(0, 4).approximation);
}

TEST(TriadTest, IsApproximateForManyItems) {
  const IntegerDistribution exact = circular_triad_distribution(10);
  for (const std::size_t d : {10U, 15U, 20U, 25U, 30U, 35U, 39U}) {
    const TriadTest test = triad_test(d, 10);
    ASSERT_TRUE(test.approximation);
    EXPECT_EQ(test.p, exact.lower_tail(static_cast<std::int64_t>(d)));
    EXPECT_NEAR(*upper_tail(*test.approximation), test.p, 0.011) << d;
  }
  const TriadTest many = triad_test(30, 11);
  EXPECT_FALSE(many.exact);
  EXPECT_EQ(many.p, *upper_tail(*many.approximation));
  // ν = 11·10·9/49, χ² = 8/7·(165/4 − 30 − ½) + ν.
  EXPECT_NEAR(many.approximation->df, 990.0 / 49.0, 1e-12);
  EXPECT_NEAR(many.approximation->value, 8.0 / 7.0 * 10.75 + 990.0 / 49.0, 1e-12);
}

TEST(TriadTest, RefusesImpossibleNumbers) {
  EXPECT_THROW(triad_test(3, 4), std::invalid_argument);
  EXPECT_THROW(triad_test(0, 2), std::invalid_argument);
  EXPECT_THROW(circular_triad_distribution(11), std::invalid_argument);
}

// R counted all 6⁶ numbers of wins in the six pairs of four items.
// The mean of the exact distribution, on the scale of ζ.
TEST(Consistency, HasTheMeanOfTheDistributionUnderGuessing) {
  for (const std::size_t items : {3U, 4U, 5U, 8U}) {
    const IntegerDistribution distribution = circular_triad_distribution(items);
    const auto most = static_cast<double>(distribution.probability.size() - 1);
    EXPECT_NEAR(mean_zeta_under_guessing(items), 1.0 - distribution.mean() / most, 1e-12) << items;
  }
  EXPECT_NEAR(mean_zeta_under_guessing(4), 0.5, 1e-15);
  EXPECT_THROW(mean_zeta_under_guessing(2), std::invalid_argument);
}

TEST(JudgesAgreement, IsThatOfR) {
  const RResults expected("paired_comparisons_expected.csv");
  Comparisons counts{.wins = Eigen::MatrixXd::Zero(4, 4), .ties = Eigen::MatrixXd::Zero(4, 4)};
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      counts.wins(i, j) =
          expected.at("agreement.wins", std::to_string(i + 1) + '|' + std::to_string(j + 1));
    }
  }
  const auto agreement = judges_agreement(counts);
  ASSERT_TRUE(agreement);
  EXPECT_EQ(agreement->judges, 5U);
  EXPECT_NEAR(agreement->u, expected.at("agreement", "u"), 1e-12);
  EXPECT_NEAR(agreement->p, expected.at("agreement", "p"), 1e-12);
  ASSERT_TRUE(agreement->approximation);
  EXPECT_NEAR(agreement->approximation->value, expected.at("agreement", "chi_squared"), 1e-10);
  EXPECT_NEAR(agreement->approximation->df, expected.at("agreement", "df"), 1e-10);
  EXPECT_EQ(agreement->least, -0.2);
}

// All three judges alike: each of the three pairs is unanimous with probability 1/4.
TEST(JudgesAgreement, IsOneForJudgesWhoAgree) {
  Comparisons counts{.wins = Eigen::MatrixXd::Zero(3, 3), .ties = Eigen::MatrixXd::Zero(3, 3)};
  counts.wins(0, 1) = counts.wins(0, 2) = counts.wins(1, 2) = 3.0;
  const auto agreement = judges_agreement(counts);
  ASSERT_TRUE(agreement);
  EXPECT_EQ(agreement->u, 1.0);
  EXPECT_NEAR(agreement->p, 1.0 / 64.0, 1e-15);
  EXPECT_NEAR(agreement->least, -1.0 / 3.0, 1e-15);
}

// Two judges who contradict each other on every pair have the least agreement, and p = 1.
TEST(JudgesAgreement, IsLeastForTwoJudgesWhoContradictEachOther) {
  Comparisons counts{.wins = Eigen::MatrixXd::Ones(3, 3), .ties = Eigen::MatrixXd::Zero(3, 3)};
  counts.wins.diagonal().setZero();
  const auto agreement = judges_agreement(counts);
  ASSERT_TRUE(agreement);
  EXPECT_EQ(agreement->u, -1.0);
  EXPECT_EQ(agreement->least, -1.0);
  EXPECT_EQ(agreement->p, 1.0);
  EXPECT_FALSE(agreement->approximation);
}

TEST(JudgesAgreement, RequiresTheSameJudgesForEachPair) {
  Comparisons counts{.wins = Eigen::MatrixXd::Zero(3, 3), .ties = Eigen::MatrixXd::Zero(3, 3)};
  counts.wins(0, 1) = counts.wins(0, 2) = counts.wins(1, 2) = 3.0;
  Comparisons tied = counts;
  tied.ties(0, 1) = tied.ties(1, 0) = 1.0;
  EXPECT_FALSE(judges_agreement(tied));
  counts.wins(2, 1) = 1.0;
  EXPECT_FALSE(judges_agreement(counts));
  counts.wins = counts.wins.cwiseMin(1.0);
  counts.wins(2, 1) = 0.0;
  EXPECT_FALSE(judges_agreement(counts));  // a single judge
}

}  // namespace
}  // namespace asperity
