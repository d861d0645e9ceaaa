// Holds the crossed mixed model to a second program (Python: dense Newton for the mode, Nelder and
// Mead for the maximum, plain central differences for the errors) and to integration by brute force.

#include "analysis/models/crossed_binomial.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/models/mixed_logit.h"

namespace asperity {
namespace {

/// Eight participants, four items, two conditions, three trials each.
struct SmallCrossing {
  std::vector<CrossedHits> responses{};
  CrossedModel model{};
};

SmallCrossing small_crossing(BinomialLink link) {
  constexpr std::array kHits{1, 2, 3, 3, 2, 3, 1, 1, 2, 2, 3, 3, 3, 2, 2, 1, 1, 2, 1, 2, 1, 3,
                             1, 1, 3, 3, 3, 2, 3, 3, 2, 3, 2, 3, 3, 3, 3, 3, 2, 2, 2, 3, 2, 3,
                             2, 3, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 2, 2, 1, 1, 2, 3, 3, 2};
  SmallCrossing made{.model = {.link = link, .design = Eigen::MatrixXd::Ones(kHits.size(), 2)}};
  for (std::size_t i = 0; i < kHits.size(); ++i) {
    made.responses.push_back({.count = {.hits = static_cast<std::uint64_t>(kHits[i]), .trials = 3},
                              .participant = i / 8,
                              .item = i / 2 % 4});
    made.model.design(static_cast<Eigen::Index>(i), 1) = static_cast<double>(i % 2);
  }
  return made;
}

void expect_fit(BinomialLink link, const std::array<double, 5>& numbers,
                const std::array<double, 2>& errors) {
  const SmallCrossing data = small_crossing(link);
  const CrossedAnswer answer = crossed_fit(data.responses, data.model);
  ASSERT_TRUE(answer.fit);
  EXPECT_NEAR(answer.fit->beta(0), numbers[0], 1e-7);
  EXPECT_NEAR(answer.fit->beta(1), numbers[1], 1e-7);
  EXPECT_NEAR(answer.fit->sigma_participants, numbers[2], 1e-7);
  EXPECT_NEAR(answer.fit->sigma_items, numbers[3], 1e-7);
  EXPECT_NEAR(answer.fit->log_likelihood, numbers[4], 1e-9);
  EXPECT_NEAR(answer.fit->standard_error(0), errors[0], 2e-6);
  EXPECT_NEAR(answer.fit->standard_error(1), errors[1], 2e-6);
}

TEST(CrossedFit, IsTheMaximumOfAnotherProgramWithTheLogit) {
  expect_fit(BinomialLink::logit,
             {1.200993899, 0.546906472, 0.922000711, 0.461973039, -60.6774987049},
             {0.4837842, 0.3741524});
}

TEST(CrossedFit, IsTheMaximumOfAnotherProgramWithTheProbit) {
  expect_fit(BinomialLink::probit,
             {0.718190575, 0.315446457, 0.541426108, 0.274478615, -60.4561070764},
             {0.2820812, 0.2161014});
}

// One participant effect at a time given both item effects: ∫∫ Π_p ∫ … du dv₁ dv₂ on grids.
double integrated(const std::vector<CrossedHits>& responses, double intercept, double sigma_p,
                  double sigma_i, std::size_t participants) {
  constexpr double kStep = 0.25;
  constexpr int kHalf = 24;  // six standard deviations
  double sum = 0.0;
  for (int first = -kHalf; first <= kHalf; ++first) {
    for (int second = -kHalf; second <= kHalf; ++second) {
      const std::array<double, 2> v{kStep * first, kStep * second};
      double logarithm = -0.5 * (v[0] * v[0] + v[1] * v[1]);
      for (std::size_t person = 0; person < participants; ++person) {
        double inner = 0.0;
        for (int place = -kHalf; place <= kHalf; ++place) {
          const double u = kStep * place;
          double density = -0.5 * u * u;
          for (std::size_t item = 0; item < 2; ++item) {
            const HitCount& count = responses[2 * person + item].count;
            const double eta = intercept + sigma_p * u + sigma_i * v[item];
            const auto hits = static_cast<double>(count.hits);
            density += hits * eta - static_cast<double>(count.trials) * std::log1p(std::exp(eta)) +
                       std::lgamma(static_cast<double>(count.trials) + 1.0) -
                       std::lgamma(hits + 1.0) -
                       std::lgamma(static_cast<double>(count.trials) - hits + 1.0);
          }
          inner += std::exp(density);
        }
        logarithm += std::log(inner * kStep / std::sqrt(2.0 * std::acos(-1.0)));
      }
      sum += std::exp(logarithm);
    }
  }
  return std::log(sum * kStep * kStep / (2.0 * std::acos(-1.0)));
}

TEST(CrossedFit, IsNearTheMaximumOfTheIntegralItself) {
  constexpr std::array<std::uint64_t, 10> kHits{31, 22, 36, 30, 18, 9, 27, 15, 34, 29};
  std::vector<CrossedHits> responses{};
  for (std::size_t i = 0; i < kHits.size(); ++i) {
    responses.push_back(
        {.count = {.hits = kHits[i], .trials = 40}, .participant = i / 2, .item = i % 2});
  }
  const CrossedModel model{.design = Eigen::MatrixXd::Ones(10, 1)};
  const CrossedAnswer answer = crossed_fit(responses, model);
  ASSERT_TRUE(answer.fit);
  const CrossedFit& fit = *answer.fit;
  const auto exact = [&](double intercept, double sigma_p, double sigma_i) {
    return integrated(responses, intercept, sigma_p, sigma_i, 5);
  };
  const double there = exact(fit.beta(0), fit.sigma_participants, fit.sigma_items);
  EXPECT_NEAR(fit.log_likelihood, there, 0.03);
  for (const double factor : {0.85, 1.15}) {
    EXPECT_LT(exact(fit.beta(0), factor * fit.sigma_participants, fit.sigma_items), there);
    EXPECT_LT(exact(fit.beta(0), fit.sigma_participants, factor * fit.sigma_items), there);
    EXPECT_LT(exact(fit.beta(0) + 0.2 * (factor - 1.0), fit.sigma_participants, fit.sigma_items),
              there);
  }
}

// Without items the model is that of mixed_logit, whose integral is exact.
TEST(CrossedFit, OfParticipantsAloneIsNearThatByQuadrature) {
  constexpr std::array<std::uint64_t, 8> kHits{31, 22, 36, 30, 18, 9, 27, 15};
  std::vector<CrossedHits> responses{};
  std::vector<GroupedHits> grouped{};
  CrossedModel model{.design = Eigen::MatrixXd::Ones(8, 2), .items_vary = false};
  for (std::size_t i = 0; i < kHits.size(); ++i) {
    const HitCount count{.hits = kHits[i], .trials = 40};
    responses.push_back({.count = count, .participant = i});
    grouped.push_back({.count = count, .second_group = i % 2 == 1});
    model.design(static_cast<Eigen::Index>(i), 1) = static_cast<double>(i % 2);
  }
  const CrossedAnswer laplace = crossed_fit(responses, model);
  const auto integrated_fit = mixed_logit(grouped);
  const auto* quadrature = std::get_if<MixedLogit>(&integrated_fit);
  ASSERT_TRUE(laplace.fit);
  ASSERT_NE(quadrature, nullptr);
  EXPECT_NEAR(laplace.fit->beta(1), quadrature->beta.second_group, 5e-3);
  EXPECT_NEAR(laplace.fit->sigma_participants, quadrature->sigma, 5e-3);
  EXPECT_NEAR(laplace.fit->standard_error(1), quadrature->standard_error.second_group, 5e-3);
}

std::vector<CrossedHits> responses_of(const std::vector<std::vector<std::uint64_t>>& hits,
                                      std::uint64_t trials) {
  std::vector<CrossedHits> made{};
  for (std::size_t p = 0; p < hits.size(); ++p) {
    for (std::size_t i = 0; i < hits[p].size(); ++i) {
      made.push_back(
          {.count = {.hits = hits[p][i], .trials = trials}, .participant = p, .item = i});
    }
  }
  return made;
}

CrossedModel intercept_of(const std::vector<CrossedHits>& responses) {
  return {.design = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(responses.size()), 1)};
}

TEST(CrossedFit, DoesNotExistWhereTheLikelihoodHasNoMaximum) {
  // Participants who are always correct or never; items likewise; a scale of both; no error at all.
  for (const auto& hits : {std::vector<std::vector<std::uint64_t>>{{3, 3, 3}, {0, 0, 0}, {3, 3, 3}},
                           {{3, 0, 3}, {3, 0, 3}, {3, 0, 3}},
                           {{3, 3, 3}, {3, 3, 0}, {3, 0, 0}},
                           {{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}}) {
    const std::vector<CrossedHits> responses = responses_of(hits, 3);
    const CrossedAnswer answer = crossed_fit(responses, intercept_of(responses));
    EXPECT_FALSE(answer.fit);
    EXPECT_EQ(answer.problem, CrossedProblem::no_maximum);
  }
}

// The same covariate in another unit and from another zero: coefficients follow, likelihood and variances do not change.
TEST(CrossedFit, DoesNotDependOnTheUnitOfACovariate) {
  SmallCrossing data = small_crossing(BinomialLink::logit);
  data.model.design.conservativeResize(Eigen::NoChange, 3);
  for (Eigen::Index row = 0; row < data.model.design.rows(); ++row) {
    data.model.design(row, 2) = std::sin(static_cast<double>(row));
  }
  const CrossedAnswer first = crossed_fit(data.responses, data.model);
  ASSERT_TRUE(first.fit);
  constexpr double kUnit = 0.001;
  constexpr double kZero = 20.0;
  data.model.design.col(2) = kUnit * data.model.design.col(2).array() + kZero * kUnit;
  const CrossedAnswer second = crossed_fit(data.responses, data.model);
  ASSERT_TRUE(second.fit);
  EXPECT_NEAR(second.fit->beta(2) * kUnit, first.fit->beta(2), 1e-7);
  EXPECT_NEAR(second.fit->standard_error(2) * kUnit, first.fit->standard_error(2), 1e-6);
  EXPECT_NEAR(second.fit->beta(0) + kZero * kUnit * second.fit->beta(2), first.fit->beta(0), 1e-6);
  EXPECT_NEAR(second.fit->sigma_items, first.fit->sigma_items, 1e-7);
  EXPECT_NEAR(second.fit->log_likelihood, first.fit->log_likelihood, 1e-9);
}

// One response at a covariate of exactly 0 is not a reference level.
TEST(CrossedFit, ExistsWhereTheOnlyResponseAtZeroIsAHit) {
  SmallCrossing data = small_crossing(BinomialLink::logit);
  data.model.design.col(1).setOnes();
  for (Eigen::Index row = 0; row < data.model.design.rows(); ++row) {
    data.model.design(row, 1) =
        static_cast<double>(row % 7) - 3.0 + 0.01 * static_cast<double>(row);
  }
  data.responses.at(10).count = {.hits = 3, .trials = 3};
  data.model.design(10, 1) = 0.0;
  EXPECT_TRUE(crossed_fit(data.responses, data.model).fit);
}

TEST(CrossedFit, NamesTheVarianceThatIsEstimatedAsNone) {
  const std::vector<CrossedHits> alike =
      responses_of({{9, 9, 9}, {3, 3, 3}, {7, 7, 7}, {5, 5, 5}}, 10);
  const CrossedAnswer items = crossed_fit(alike, intercept_of(alike));
  EXPECT_FALSE(items.fit);
  EXPECT_EQ(items.problem, CrossedProblem::no_item_variance);
  const std::vector<CrossedHits> same = responses_of({{5, 5}, {5, 5}, {5, 5}}, 10);
  EXPECT_EQ(crossed_fit(same, intercept_of(same)).problem, CrossedProblem::no_variance);
}

TEST(CrossedFit, ErrsByParticipantsAndByItems) {
  CrossedFit fit{.standard_error = Eigen::VectorXd::Constant(1, 0.5),
                 .sigma_participants = 0.6,
                 .sigma_items = 0.8};
  const SampledError both = intercept_error(fit, 10, 4);
  EXPECT_NEAR(both.standard_error * both.standard_error, 0.25 + 0.36 / 90.0 + 0.64 / 12.0, 1e-12);
  EXPECT_EQ(both.df, 3.0);
  EXPECT_THROW(intercept_error(fit, 10, 1), std::invalid_argument);
  fit.sigma_items = 0.0;
  EXPECT_EQ(intercept_error(fit, 10, 4).df, 3.0) << "an estimate of 0 makes no sample larger";
  const SampledError participants = intercept_error(fit, 10, 1);
  EXPECT_NEAR(participants.standard_error * participants.standard_error, 0.254, 1e-12);
  EXPECT_EQ(participants.df, 9.0);
}

/// Twelve trials of each of twenty participants, two of whom miss two.
std::vector<CrossedHits> near_ceiling() {
  std::vector<CrossedHits> responses{};
  for (std::size_t i = 0; i < 20; ++i) {
    responses.push_back({.count = {.hits = i < 2 ? 10U : 12U, .trials = 12}, .participant = i});
  }
  return responses;
}

CrossedModel integrated_intercept(std::size_t rows) {
  return {.design = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(rows), 1),
          .items_vary = false,
          .likelihood = MarginalLikelihood::quadrature};
}

// Simpson's rule over z from −9 to 9 in 4000 steps: ∫ C(12, k)·p^k·(1 − p)^(12 − k)·φ(z)dz, p = 1/(1 + exp(−β − σz)).
TEST(CrossedFit, IntegratesOneInterceptExactly) {
  const std::vector<CrossedHits> responses = near_ceiling();
  for (const auto& [beta, sigma] : {std::pair{6.6, 2.6}, {9.0, 6.0}, {1.0, 0.3}}) {
    double expected = 0.0;
    for (const double hits : {10.0, 12.0}) {
      constexpr int kSteps = 4000;
      double integral = 0.0;
      for (int step = 0; step <= kSteps; ++step) {
        const double z = -9.0 + 18.0 * step / kSteps;
        const double p = 1.0 / (1.0 + std::exp(-beta - sigma * z));
        const double ways = hits == 10.0 ? 66.0 : 1.0;
        const double weight = step == 0 || step == kSteps ? 1.0 : (step % 2 == 1 ? 4.0 : 2.0);
        integral += weight * ways * std::pow(p, hits) * std::pow(1.0 - p, 12.0 - hits) *
                    0.3989422804014327 * std::exp(-0.5 * z * z);
      }
      expected += (hits == 10.0 ? 2.0 : 18.0) * std::log(integral * 18.0 / kSteps / 3.0);
    }
    const CrossedFit at{.beta = Eigen::VectorXd::Constant(1, beta), .sigma_participants = sigma};
    EXPECT_NEAR(crossed_log_likelihood(responses, integrated_intercept(responses.size()), at),
                expected, 1e-8)
        << beta << ' ' << sigma;
  }
}

// By adaptive quadrature with 25 points, R's lme4 finds β = 6.6 and σ = 2.6; Laplace's approximation is at 9.4 and 6.5.
TEST(CrossedFit, IsNotInflatedNearTheCeilingWithQuadrature) {
  const std::vector<CrossedHits> responses = near_ceiling();
  const CrossedAnswer exact = crossed_fit(responses, integrated_intercept(responses.size()));
  ASSERT_TRUE(exact.fit);
  EXPECT_NEAR(exact.fit->beta(0), 6.6, 0.1);
  EXPECT_NEAR(exact.fit->sigma_participants, 2.6, 0.1);
  CrossedModel both = integrated_intercept(responses.size());
  both.items_vary = true;
  EXPECT_THROW(crossed_fit(responses, both), std::invalid_argument);
}

TEST(CrossedFit, RefusesWhatIsNoModel) {
  const std::vector<CrossedHits> responses = responses_of({{1, 2}, {2, 1}}, 3);
  EXPECT_THROW(crossed_fit(responses, {.design = Eigen::MatrixXd::Ones(3, 1)}),
               std::invalid_argument);
  EXPECT_THROW(crossed_fit(responses, {.design = Eigen::MatrixXd::Ones(4, 2)}),
               std::invalid_argument);
  CrossedModel none = intercept_of(responses);
  none.participants_vary = none.items_vary = false;
  EXPECT_THROW(crossed_fit(responses, none), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
