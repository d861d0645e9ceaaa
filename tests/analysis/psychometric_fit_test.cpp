// Fits psychometric functions to the exact proportions of known ones, and to data without a fit.

#include "analysis/psychometric/psychometric_fit.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/psychometric/psychometric_bootstrap.h"
#include "analysis/psychometric/psychometric_maximum.h"

namespace asperity {
namespace {

using Blocks = std::vector<PsychometricBlock>;

constexpr std::uint64_t kMany = 1'000'000'000;

// Hits of so many trials that rounding to whole numbers is negligible.
Blocks blocks_of(const PsychometricFunction& f, const std::vector<double>& levels) {
  Blocks blocks;
  for (const double x : levels) {
    blocks.push_back({.x = x,
                      .trials = kMany,
                      .hits = static_cast<std::uint64_t>(
                          std::llround(f.value(x) * static_cast<double>(kMany)))});
  }
  return blocks;
}

TEST(PsychometricFit, RecoversEveryShapeAndBothRates) {
  for (const PsychometricShape shape : {PsychometricShape::logistic, PsychometricShape::normal,
                                        PsychometricShape::gumbel, PsychometricShape::weibull}) {
    const PsychometricFunction truth{
        .shape = shape, .alpha = 1.2, .beta = 1.6, .gamma = 0.1, .lambda = 0.04};
    const Blocks blocks = blocks_of(truth, {0.2, 0.6, 0.9, 1.2, 1.5, 2.0, 3.0, 5.0});
    const PsychometricModel model{
        .shape = shape, .gamma = std::nullopt, .lambda = std::nullopt, .greatest_lambda = 0.1};
    const PsychometricMaximum fit = maximise_psychometric(blocks, model);
    EXPECT_NEAR(fit.function.alpha, truth.alpha, 1e-5);
    EXPECT_NEAR(fit.function.beta, truth.beta, 1e-4);
    EXPECT_NEAR(fit.function.gamma, truth.gamma, 1e-5);
    EXPECT_NEAR(fit.function.lambda, truth.lambda, 1e-5);
    EXPECT_FALSE(fit.beta_at_bound);
  }
}

TEST(PsychometricFunction, HasTheAskedPerformanceAtItsThreshold) {
  for (const PsychometricShape shape : {PsychometricShape::logistic, PsychometricShape::normal,
                                        PsychometricShape::gumbel, PsychometricShape::weibull}) {
    const PsychometricFunction f{
        .shape = shape, .alpha = 0.7, .beta = 2.0, .gamma = 0.25, .lambda = 0.02};
    const double x = f.inverse(0.6);
    EXPECT_NEAR(f.value(x), 0.6, 1e-14);
    EXPECT_NEAR(f.slope(x), (f.value(x + 1e-6) - f.value(x - 1e-6)) / 2e-6, 1e-8);
  }
}

PsychometricStatus status_of(const Blocks& blocks, const PsychometricModel& model = {}) {
  return judge(blocks, model).status;
}

TEST(PsychometricJudgement, StatesWhyDataHaveNoFit) {
  EXPECT_EQ(status_of({}), PsychometricStatus::no_data);
  EXPECT_EQ(status_of({{1, 4, 4}, {2, 4, 4}}), PsychometricStatus::all_correct);
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 0}, {3, 0, 0}}), PsychometricStatus::all_wrong);
  EXPECT_EQ(status_of({{1, 4, 1}, {1, 4, 3}, {2, 0, 0}}), PsychometricStatus::one_level);
  EXPECT_EQ(status_of({{0, 4, 0}, {2, 4, 3}}, {.shape = PsychometricShape::weibull}),
            PsychometricStatus::one_level);
  const Blocks two_levels{{1, 9, 2}, {2, 9, 7}};
  EXPECT_EQ(status_of(two_levels), PsychometricStatus::ok);
  EXPECT_EQ(status_of(two_levels, {.lambda = std::nullopt}), PsychometricStatus::too_few_levels);
  EXPECT_EQ(status_of({{1, 9, 2}, {2, 9, 5}, {3, 9, 7}}, {.lambda = std::nullopt}),
            PsychometricStatus::ok);
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 2}, {3, 4, 4}}), PsychometricStatus::quasi_separated);
  EXPECT_EQ(status_of({{1, 4, 1}, {2, 4, 2}, {3, 4, 4}}), PsychometricStatus::ok);
  // With a guess rate of 1/2, only incorrect responses below a step are improbable.
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 4}}, {.gamma = 0.5}), PsychometricStatus::ok);
  const PsychometricJudgement step = judge(Blocks{{5, 4, 4}, {1, 4, 0}, {2, 4, 0}}, {});
  EXPECT_EQ(step.status, PsychometricStatus::separated);
  EXPECT_EQ(step.bracket->low, 2.0);
  EXPECT_EQ(step.bracket->high, 5.0);
}

// A step between guessing and knowing: as steep as the levels allow, and no standard errors.
TEST(PsychometricFit, LimitsTheSlopeToWhatTheLevelsDetermine) {
  const Blocks blocks{{1, 20, 10}, {2, 20, 10}, {3, 20, 20}, {4, 20, 20}};
  const auto fit = fit_psychometric(blocks, {.model = {.gamma = 0.5}, .performance = 0.75});
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->beta_at_bound);
  EXPECT_FALSE(fit->precision);
  EXPECT_NEAR(fit->function.beta, 2.0 * std::log(99.0), 1e-9);  // 0.01 to 0.99 within 1
  EXPECT_GT(fit->threshold, 2.0);
  EXPECT_LT(fit->threshold, 3.0);
}

// With γ = λ = 0 the likelihood is concave in slope and intercept, and at a slope of 0 its
// derivative is proportional to Σ x·(k − n·p̄): where that is not positive, no increasing function is
// likelier than the constant p̄.
TEST(PsychometricFit, DoesNotExistWhereHitsDoNotRise) {
  const Blocks falling{{1, 20, 19}, {2, 20, 15}, {3, 20, 11}, {4, 20, 8}, {5, 20, 4}, {6, 20, 1}};
  const Blocks flat{{1, 20, 10}, {2, 20, 10}, {3, 20, 10}};
  const Blocks hump{{1, 20, 8}, {2, 20, 12}, {3, 20, 8}};
  const Blocks last_up{{1, 20, 19}, {2, 20, 15}, {3, 20, 11}, {4, 20, 4}, {5, 20, 1}, {6, 20, 15}};
  const Blocks barely{{1, 20, 10}, {2, 20, 10}, {3, 20, 11}};
  for (const PsychometricShape shape : {PsychometricShape::logistic, PsychometricShape::normal,
                                        PsychometricShape::gumbel, PsychometricShape::weibull}) {
    const PsychometricQuestion question{.model = {.shape = shape}};
    for (const Blocks& blocks : {falling, flat, last_up}) {
      EXPECT_EQ(status_of(blocks, question.model), PsychometricStatus::ok);
      EXPECT_FALSE(fit_psychometric(blocks, question));
    }
    // In ln x the lowest of the three levels is further from the middle one.
    EXPECT_EQ(fit_psychometric(hump, question).has_value(), shape == PsychometricShape::weibull);
    EXPECT_TRUE(fit_psychometric(barely, question));
    EXPECT_FALSE(maximise_psychometric(falling, question.model).increases);
    EXPECT_NEAR(maximise_psychometric(falling, question.model).log_likelihood,
                maximise_psychometric(Blocks(falling.rbegin(), falling.rend()), question.model)
                    .log_likelihood,
                1e-9);
  }
  // A guessing rate: below chance there is nothing to fit, above it there is.
  const PsychometricQuestion guessing{.model = {.gamma = 0.5}, .performance = 0.75};
  EXPECT_FALSE(fit_psychometric(Blocks{{1, 20, 9}, {2, 20, 8}, {3, 20, 9}}, guessing));
  EXPECT_FALSE(fit_psychometric(Blocks{{1, 20, 14}, {2, 20, 12}, {3, 20, 10}}, guessing));
  EXPECT_TRUE(fit_psychometric(Blocks{{1, 20, 10}, {2, 20, 12}, {3, 20, 14}}, guessing));
}

// Constant functions near 41/80 are as likely with α = −∞ as nearly with ∞. Those near 18/100 have
// α = ∞: no large α is rejected.
TEST(PsychometricFit, HasAnOpenProfileWhereAConstantIsNotRejected) {
  const PsychometricQuestion question{};
  const auto barely =
      fit_psychometric(Blocks{{1, 20, 10}, {2, 20, 10}, {3, 20, 10}, {6, 20, 11}}, question);
  ASSERT_TRUE(barely && barely->precision);
  EXPECT_FALSE(barely->profile_low);
  EXPECT_FALSE(barely->profile_high);
  const auto steep =
      fit_psychometric(Blocks{{1, 20, 1}, {2, 20, 6}, {3, 20, 13}, {4, 20, 19}}, question);
  ASSERT_TRUE(steep && steep->precision);
  EXPECT_LT(*steep->profile_low, steep->function.alpha);
  EXPECT_GT(*steep->profile_high, steep->function.alpha);
  const auto low = fit_psychometric(
      Blocks{{1, 20, 2}, {2, 20, 3}, {3, 20, 4}, {4, 20, 4}, {5, 20, 5}}, question);
  ASSERT_TRUE(low && low->precision);
  ASSERT_TRUE(low->profile_low);
  EXPECT_FALSE(low->profile_high);
  EXPECT_LT(*low->profile_low, low->function.alpha);
}

// φ = X²/df multiplies the variance, and z becomes Student's limit.
TEST(PsychometricFit, AllowsForMoreThanBinomialVariation) {
  const PsychometricQuestion question{.model = {.shape = PsychometricShape::normal}};
  const auto wild = fit_psychometric(
      Blocks{{1, 20, 1}, {2, 20, 9}, {3, 20, 5}, {4, 20, 17}, {5, 20, 13}}, question);
  ASSERT_TRUE(wild && wild->overdispersed);
  EXPECT_NEAR(*wild->dispersion, *wild->pearson / 3.0, 1e-12);
  EXPECT_GT(*wild->dispersion, 1.5);
  const double factor = std::sqrt(*wild->dispersion);
  EXPECT_NEAR(wild->overdispersed->threshold_se, factor * wild->precision->threshold_se, 1e-12);
  EXPECT_NEAR(wild->overdispersed->beta_se, factor * wild->precision->beta_se, 1e-12);
  constexpr double kStudent = 3.1824463052842638;  // 97.5 % with 3 degrees of freedom
  EXPECT_NEAR(wild->overdispersed->threshold.high,
              wild->threshold + kStudent * wild->overdispersed->threshold_se, 1e-9);
  const auto tame = fit_psychometric(
      Blocks{{1, 20, 2}, {2, 20, 5}, {3, 20, 10}, {4, 20, 15}, {5, 20, 18}}, question);
  ASSERT_TRUE(tame && tame->overdispersed);
  EXPECT_LT(*tame->dispersion, 1.0);
  EXPECT_EQ(tame->overdispersed->alpha_se, tame->precision->alpha_se);
}

// The highest of many levels has lapses only: fixed at 0, they flatten the function.
TEST(PsychometricFit, StatesWhatAFixedLapseRateDoes) {
  const Blocks lapsing{{1, 100, 2},  {2, 100, 16}, {3, 100, 50}, {4, 100, 80},
                       {5, 100, 93}, {6, 100, 94}, {7, 100, 95}, {8, 100, 95}};
  const auto fixed = fit_psychometric(lapsing, {});
  ASSERT_TRUE(fixed && fixed->free_lapses);
  EXPECT_NEAR(fixed->free_lapses->lambda, 0.05, 0.01);
  EXPECT_GT(fixed->free_lapses->likelihood_ratio, 10.0);
  const auto free = fit_psychometric(lapsing, {.model = {.lambda = std::nullopt}});
  ASSERT_TRUE(free);
  EXPECT_FALSE(free->free_lapses);
  EXPECT_NEAR(fixed->free_lapses->threshold, free->threshold, 1e-6);
}

TEST(ParametricBootstrap, AgreesWithLargeSamplesAndTestsTheFit) {
  const PsychometricQuestion question{};
  const Blocks good{{1, 200, 24}, {2, 200, 54}, {3, 200, 100}, {4, 200, 146}, {5, 200, 176}};
  const auto fit = fit_psychometric(good, question);
  ASSERT_TRUE(fit && fit->precision);
  const ParametricBootstrap boot = parametric_bootstrap(good, *fit, question, 400);
  EXPECT_EQ(boot.thresholds.valid, 400U);
  EXPECT_NEAR(*boot.thresholds.standard_error, fit->precision->threshold_se,
              0.15 * fit->precision->threshold_se);
  EXPECT_NEAR(boot.deviance_p.value(), *fit->deviance_p, 0.08);
  EXPECT_EQ(boot.deviance_p, parametric_bootstrap(good, *fit, question, 400).deviance_p);
  const Blocks bad{{1, 200, 24}, {2, 200, 104}, {3, 200, 60}, {4, 200, 156}, {5, 200, 176}};
  const auto wrong = fit_psychometric(bad, question);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(parametric_bootstrap(bad, *wrong, question, 99).deviance_p, 0.01);
}

TEST(PsychometricFit, RefusesImpossibleCounts) {
  const PsychometricModel without_guessing{.shape = PsychometricShape::weibull};
  EXPECT_THROW(judge(Blocks{{0, 10, 1}, {1, 10, 2}, {2, 10, 5}}, without_guessing),
               std::invalid_argument);
  EXPECT_EQ(status_of({{0, 10, 0}, {1, 10, 2}, {2, 10, 5}}, without_guessing),
            PsychometricStatus::ok);
  EXPECT_EQ(status_of({{0, 10, 1}, {1, 10, 2}, {2, 10, 5}},
                      {.shape = PsychometricShape::weibull, .gamma = std::nullopt}),
            PsychometricStatus::ok);
  EXPECT_THROW(judge(Blocks{{1, 4, 5}}, {}), std::invalid_argument);
  EXPECT_THROW(judge(Blocks{{-1, 4, 2}}, {.shape = PsychometricShape::weibull}),
               std::invalid_argument);
  EXPECT_THROW(fit_psychometric(Blocks{{1, 4, 4}}, {}), std::invalid_argument);
}

// The grid of one data set is used for the next one only if the model and the levels are the same.
TEST(PsychometricFit, IsTheSameWithTheStartsOfAnotherDataSet) {
  const Blocks first{{1, 20, 4}, {2, 20, 8}, {3, 20, 15}, {4, 20, 19}};
  const Blocks counts{{1, 20, 2}, {2, 20, 11}, {3, 20, 13}, {4, 20, 18}};
  const Blocks levels{{1, 20, 2}, {2, 20, 11}, {3, 20, 13}, {5, 20, 18}};
  const Blocks fewer{{1, 20, 2}, {2, 20, 11}, {3, 20, 13}};
  PsychometricStarts starts{};
  for (const PsychometricModel& model :
       {PsychometricModel{}, PsychometricModel{.gamma = std::nullopt, .lambda = std::nullopt},
        PsychometricModel{.shape = PsychometricShape::weibull, .gamma = 0.1},
        PsychometricModel{.lambda = 0.02}}) {
    for (const Blocks& blocks : {first, counts, levels, fewer, first}) {
      const PsychometricMaximum kept = maximise_psychometric(blocks, model, starts);
      const PsychometricMaximum fresh = maximise_psychometric(blocks, model);
      EXPECT_EQ(kept.log_likelihood, fresh.log_likelihood);
      EXPECT_EQ(kept.function.alpha, fresh.function.alpha);
      EXPECT_EQ(kept.function.beta, fresh.function.beta);
    }
  }
}

// The values of a grid are those of the likelihood, in every bit.
TEST(PsychometricLikelihood, IsTheSameFromLogProbabilities) {
  const Blocks blocks{{1, 20, 0}, {2, 20, 11}, {3, 20, 20}, {4, 20, 18, 0.5}};
  const PsychometricLikelihood data(blocks, {.gamma = std::nullopt});
  for (const double gamma : {0.0, 0.2}) {
    const CurveParameters at(2.2, 0.3, gamma, 0.0);
    EXPECT_EQ(data.value(data.log_probabilities(at)), data.value(at));
  }
}

// F is 0.2, 0.5 and 0.8: 10^t is 0.22, 0.69 and 1.61, and t rises by some 0.43 per unit of x.
TEST(PsychometricFit, KeepsTheSlopeWithinTheLimitsOfTheModel) {
  const std::vector<PsychometricBlock> blocks{{.x = -1.0, .trials = 20, .hits = 12},
                                              {.x = 0.0, .trials = 20, .hits = 15},
                                              {.x = 1.0, .trials = 20, .hits = 18}};
  PsychometricModel model{.shape = PsychometricShape::gumbel, .gamma = 0.5};
  const PsychometricMaximum free = maximise_psychometric(blocks, model);
  ASSERT_NEAR(free.function.beta, 0.43, 0.05);
  const auto slope_within = [&](double least, double greatest) {
    model.slope = SlopeRange{.least = least, .greatest = greatest};
    return maximise_psychometric(blocks, model);
  };
  EXPECT_NEAR(slope_within(0.1, 2.0).function.beta, free.function.beta, 1e-5);
  EXPECT_NEAR(slope_within(0.6, 2.0).function.beta, 0.6, 1e-9);
  EXPECT_NEAR(slope_within(0.1, 0.3).function.beta, 0.3, 1e-9);
  EXPECT_LT(slope_within(0.6, 2.0).log_likelihood, free.log_likelihood);
  EXPECT_THROW(slope_within(2.0, 1.0), std::invalid_argument);
  EXPECT_THROW(
      fit_psychometric(blocks, {.model = {.shape = PsychometricShape::gumbel,
                                          .gamma = 0.5,
                                          .slope = SlopeRange{.least = 1.0, .greatest = 2.0}}}),
      std::invalid_argument);
}

}  // namespace
}  // namespace asperity
