// Scales of items where the answer can be written down.

#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/choices/bradley_terry.h"
#include "analysis/choices/comparison_graph.h"
#include "analysis/choices/first_choice.h"
#include "analysis/choices/mallows.h"
#include "analysis/choices/plackett_luce.h"
#include "analysis/choices/thurstone.h"
#include "analysis/tests/friedman.h"

namespace asperity {
namespace {

/// `won` of `won + lost` for the first of two items, who is presented first in half of them.
std::vector<Comparison> duel(std::size_t won, std::size_t lost) {
  std::vector<Comparison> all{};
  for (std::size_t i = 0; i < won + lost; ++i) {
    const std::size_t first = i % 2;
    all.push_back(
        {.participant = i, .first = first, .second = 1 - first, .winner = i < won ? 0U : 1U});
  }
  return all;
}

// ln(9/3) with √(1/9 + 1/3).
TEST(BradleyTerry, IsTheLogOddsForTwo) {
  const auto fit = bradley_terry(duel(9, 3), 2);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->abilities.value(0) - fit->abilities.value(1), std::log(3.0), 1e-12);
  EXPECT_NEAR(fit->abilities.standard_error()(1), std::sqrt(1.0 / 9.0 + 1.0 / 3.0), 1e-12);
  EXPECT_NEAR(fit->abilities.worth()(0), 0.75, 1e-12);
  EXPECT_NEAR(fit->deviance, 0.0, 1e-10);
  EXPECT_EQ(fit->df, 0U);
}

TEST(BradleyTerry, RefusesAnItemThatAlwaysWinsWhereFirthAnswers) {
  const std::vector<Comparison> all = duel(5, 0);
  EXPECT_FALSE(bradley_terry(all, 2));
  const auto firth = firth_bradley_terry(count_comparisons(all, 2));
  ASSERT_TRUE(firth);
  // For one pair Firth's correction is half a win for either: ln(5.5/0.5).
  EXPECT_NEAR(firth->value(0) - firth->value(1), std::log(11.0), 1e-10);
}

// Equal items: each side and the tie in the proportions 1 : 1 : ν.
TEST(Davidson, GivesTiesTheirOwnWorth) {
  std::vector<Comparison> all = duel(6, 6);
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back({.participant = i, .first = 0, .second = 1, .winner = {}});
  const auto fit = davidson(count_comparisons(all, 2));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->abilities.value(1), 0.0, 1e-10);
  EXPECT_NEAR(fit->log_tie, std::log(3.0 / 6.0), 1e-10);
}

TEST(ComparisonGraph, NeedsAWayBothWays) {
  Eigen::MatrixXd wins = Eigen::MatrixXd::Zero(3, 3);
  wins(0, 1) = wins(1, 2) = 1.0;
  EXPECT_TRUE(connected(wins));
  EXPECT_FALSE(strongly_connected(wins));
  wins(2, 0) = 1.0;
  EXPECT_TRUE(strongly_connected(wins));
  wins(1, 2) = wins(2, 0) = 0.0;
  EXPECT_FALSE(connected(wins));
}

// Among two, the better of two unit normals: Φ(Δ/√2) = 0.75; Case V counts in SD of the difference.
TEST(Thurstone, HasTwoUnits) {
  const double z = 0.6744897501960817;
  const std::vector<double> means = first_choice_means(std::vector<double>{0.75, 0.25});
  EXPECT_NEAR(means[0] - means[1], std::sqrt(2.0) * z, 1e-12);
  const Comparisons counts = count_comparisons(duel(9, 3), 2);
  const auto squares = thurstone_least_squares(counts);
  EXPECT_NEAR(squares->scale(0) - squares->scale(1), z, 1e-12);
  const auto likelihood = thurstone_likelihood(counts);
  EXPECT_NEAR(-likelihood->abilities.value(1), z, 1e-12);
}

TEST(FirstChoice, HoldsForSharesAtTheEdge) {
  const std::vector<double> means =
      first_choice_means(std::vector<double>{0.997, 0.001, 0.001, 0.001});
  EXPECT_NEAR(means[1], means[3], 1e-12);
  EXPECT_GT(means[0], means[1] + 3.0);
  EXPECT_THROW(first_choice_means(std::vector<double>{1.0, 0.0}), std::invalid_argument);
}

// A ranking of two is one comparison; first choices of three have the shares as worths.
TEST(PlackettLuce, IsLucesModelForFirstChoices) {
  std::vector<Ranking> rankings{};
  const std::vector<std::size_t> chosen{0, 0, 0, 1, 1, 2};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Ranking one{.participant = i, .ranked = {chosen[i]}};
    for (std::size_t item = 0; item < 3; ++item) {
      if (item != chosen[i]) one.behind.push_back(item);
    }
    rankings.push_back(one);
  }
  const auto fit = plackett_luce(rankings, 3);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->log_worths.worth()(0), 3.0 / 6.0, 1e-10);
  EXPECT_NEAR(fit->log_worths.worth()(2), 1.0 / 6.0, 1e-10);
  EXPECT_NEAR(fit->equal_log_likelihood, -6.0 * std::log(3.0), 1e-12);
}

/// First choices among three by participants of `trials` trials each.
std::vector<Ranking> first_choices(const std::vector<std::array<std::size_t, 3>>& counts) {
  std::vector<Ranking> rankings{};
  for (std::size_t person = 0; person < counts.size(); ++person) {
    for (std::size_t item = 0; item < 3; ++item) {
      rankings.push_back({.participant = person,
                          .ranked = {item},
                          .behind = {(item + 1) % 3, (item + 2) % 3},
                          .times = counts[person][item]});
    }
  }
  return rankings;
}

// All sets are the same, so that a participant of n trials has the share h = n/N of the information:
// the influence on a centred log-worth is scaled by 1/√(1 − h), and the covariances of these
// influences under the model are (δ·h_g − h_g·h_k)/√((1 − h_g)(1 − h_k)) times a constant.
TEST(PlackettLuce, HasErrorsOverParticipantsThatFollowTheirTrials) {
  const std::vector<std::array<std::size_t, 3>> counts{{4, 5, 3}, {10, 2, 8}, {1, 2, 1},
                                                       {3, 6, 0}, {7, 7, 6},  {2, 9, 1}};
  const auto fit = plackett_luce(first_choices(counts), 3);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->centred_errors.size(), 3U);
  const Eigen::VectorXd p = fit->log_worths.worth();
  std::vector<double> trials{};
  double all = 0.0;
  for (const auto& own : counts) {
    trials.push_back(static_cast<double>(own[0] + own[1] + own[2]));
    all += trials.back();
  }
  double trace = 0.0;
  double trace_of_square = 0.0;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double h = trials[g] / all;
      const double other = trials[k] / all;
      const double gamma = ((g == k ? h : 0.0) - h * other) / std::sqrt((1.0 - h) * (1.0 - other));
      trace += g == k ? gamma : 0.0;
      trace_of_square += gamma * gamma;
    }
  }
  for (Eigen::Index item = 0; item < 3; ++item) {
    double squares = 0.0;
    for (std::size_t g = 0; g < counts.size(); ++g) {
      Eigen::Vector3d influence;
      for (Eigen::Index j = 0; j < 3; ++j) {
        const auto chosen = static_cast<double>(counts[g][static_cast<std::size_t>(j)]);
        influence(j) = (chosen / p(j) - trials[g]) / all;
      }
      const double centred = influence(item) - influence.mean();
      squares += centred * centred / (1.0 - trials[g] / all);
    }
    const ClusteredError& error = fit->centred_errors[static_cast<std::size_t>(item)];
    EXPECT_NEAR(error.standard_error, std::sqrt(squares), 1e-9);
    EXPECT_NEAR(error.df, trace * trace / trace_of_square, 1e-9);
  }
}

// Participants of equal trials: the correction is G/(G − 1), with G − 1 degrees of freedom.
TEST(PlackettLuce, HasTheErrorsOfEqualClusters) {
  const auto fit =
      plackett_luce(first_choices({{4, 5, 3}, {6, 2, 4}, {8, 2, 2}, {3, 6, 3}, {4, 4, 4}}), 3);
  ASSERT_TRUE(fit);
  const Eigen::VectorXd uncorrected = fit->clustered.about_mean().standard_error();
  for (std::size_t i = 0; i < 3; ++i) {
    const ClusteredError& error = fit->centred_errors.at(i);
    EXPECT_NEAR(error.standard_error,
                std::sqrt(5.0 / 4.0) * uncorrected(static_cast<Eigen::Index>(i)), 1e-9);
    EXPECT_NEAR(error.df, 4.0, 1e-9);
  }
}

TEST(PlackettLuce, HasNoErrorsOverFewParticipantsOrOfTheirAgreement) {
  EXPECT_TRUE(plackett_luce(first_choices({{4, 5, 3}, {6, 2, 4}, {8, 2, 2}, {3, 6, 3}}), 3)
                  ->centred_errors.empty());
  const auto alike =
      plackett_luce(first_choices({{4, 5, 3}, {4, 5, 3}, {4, 5, 3}, {4, 5, 3}, {4, 5, 3}}), 3);
  EXPECT_EQ(alike->centred_errors.at(0).standard_error, 0.0);
}

TEST(BradleyTerry, HasTheErrorsOfEqualClusters) {
  std::vector<Comparison> all{};
  const std::vector<std::size_t> won{3, 5, 2, 4, 6, 5};
  for (std::size_t person = 0; person < won.size(); ++person) {
    for (std::size_t winner = 0; winner < 2; ++winner) {
      all.push_back({.participant = person,
                     .first = 0,
                     .second = 1,
                     .winner = winner,
                     .times = winner == 0 ? won[person] : 8 - won[person]});
    }
  }
  const auto fit = bradley_terry(all, 2);
  ASSERT_TRUE(fit);
  const Eigen::VectorXd uncorrected = fit->clustered.about_mean().standard_error();
  EXPECT_NEAR(fit->centred_errors.at(1).standard_error, std::sqrt(6.0 / 5.0) * uncorrected(1),
              1e-9);
  EXPECT_NEAR(fit->centred_errors.at(1).df, 5.0, 1e-9);
}

// All three rows alike: W = 1, X² = 3·2, and F has nothing left to divide by.
TEST(FriedmanTest, FindsFullAgreement) {
  Eigen::MatrixXd judgements(3, 3);
  judgements << 1, 2, 3, 10, 20, 30, -1, 0, 5;
  const FriedmanTest test = friedman_test(judgements);
  EXPECT_NEAR(test.concordance, 1.0, 1e-12);
  EXPECT_NEAR(test.chi_squared, 6.0, 1e-12);
  EXPECT_TRUE(std::isinf(test.f));
  EXPECT_EQ(test.f_p, 0.0);
}

TEST(Midranks, AreSharedByEqualNumbers) {
  EXPECT_EQ(midranks(std::vector<double>{3.0, 1.0, 3.0, 2.0}),
            (std::vector<double>{3.5, 1.0, 3.5, 2.0}));
}

// 1, 2 and 3 in favour: 2 of the 8 patterns of signs are as extreme.
TEST(SignedRankTest, CountsPatternsOfSigns) {
  const SignedRankTest test = signed_rank_test(std::vector<double>{0.5, 2.0, 0.0, 7.0});
  EXPECT_EQ(test.n, 3U);
  EXPECT_EQ(test.positive, 6.0);
  EXPECT_NEAR(test.p, 0.25, 1e-15);
  EXPECT_EQ(test.rank_biserial, 1.0);
}

// Two items: F is 0 or 2, P ∝ 1 : e^{2θ}; three of four right gives θ = ½·ln 3.
TEST(MallowsFit, SolvesTwoItems) {
  const MallowsFit fit = mallows_fit(std::vector<std::size_t>{2, 2, 2, 0}, 2);
  EXPECT_NEAR(fit.theta, 0.5 * std::log(3.0), 1e-12);
  EXPECT_NEAR(fit.finite->standard_error, 1.0 / std::sqrt(4.0 * 0.75), 1e-12);
  EXPECT_TRUE(std::isinf(mallows_fit(std::vector<std::size_t>{2, 2}, 2).theta));
  EXPECT_LT(mallows_fit(std::vector<std::size_t>{0}, 2).theta, 0.0);
}

}  // namespace
}  // namespace asperity
