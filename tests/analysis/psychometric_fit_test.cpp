// Fits functions to the very shares that known ones give, and holds what has no fit to its word.

#include "analysis/psychometric_fit.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/psychometric_maximum.h"

namespace asperity {
namespace {

using Blocks = std::vector<PsychometricBlock>;

constexpr std::uint64_t kMany = 1'000'000'000;

// Shares of so many trials that rounding them to counts says nothing.
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

TEST(PsychometricFunction, IsAtItsThresholdWhatWasAsked) {
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

TEST(PsychometricJudgement, HasAWordForDataWithoutAFit) {
  EXPECT_EQ(status_of({}), PsychometricStatus::no_data);
  EXPECT_EQ(status_of({{1, 4, 4}, {2, 4, 4}}), PsychometricStatus::all_correct);
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 0}, {3, 0, 0}}), PsychometricStatus::all_wrong);
  EXPECT_EQ(status_of({{1, 4, 1}, {1, 4, 3}, {2, 0, 0}}), PsychometricStatus::one_level);
  EXPECT_EQ(status_of({{0, 4, 1}, {2, 4, 3}}, {.shape = PsychometricShape::weibull}),
            PsychometricStatus::one_level);
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 2}, {3, 4, 4}}), PsychometricStatus::quasi_separated);
  EXPECT_EQ(status_of({{1, 4, 1}, {2, 4, 2}, {3, 4, 4}}), PsychometricStatus::ok);
  // With a rate of guessing the wrong answers below a step are not the likeliest.
  EXPECT_EQ(status_of({{1, 4, 0}, {2, 4, 4}}, {.gamma = 0.5}), PsychometricStatus::ok);
  const PsychometricJudgement step = judge(Blocks{{5, 4, 4}, {1, 4, 0}, {2, 4, 0}}, {});
  EXPECT_EQ(step.status, PsychometricStatus::separated);
  EXPECT_EQ(step.bracket->low, 2.0);
  EXPECT_EQ(step.bracket->high, 5.0);
}

// A step between guessing and knowing: as steep as the levels allow, and no standard errors.
TEST(PsychometricFit, StopsAtTheSlopeThatTheLevelsCanTell) {
  const Blocks blocks{{1, 20, 10}, {2, 20, 10}, {3, 20, 20}, {4, 20, 20}};
  const PsychometricFit fit =
      fit_psychometric(blocks, {.model = {.gamma = 0.5}, .performance = 0.75});
  EXPECT_TRUE(fit.beta_at_bound);
  EXPECT_FALSE(fit.precision);
  EXPECT_NEAR(fit.function.beta, 2.0 * std::log(99.0), 1e-9);  // 0.01 to 0.99 within 1
  EXPECT_GT(fit.threshold, 2.0);
  EXPECT_LT(fit.threshold, 3.0);
}

TEST(PsychometricFit, RefusesImpossibleCounts) {
  EXPECT_THROW(judge(Blocks{{1, 4, 5}}, {}), std::invalid_argument);
  EXPECT_THROW(judge(Blocks{{-1, 4, 2}}, {.shape = PsychometricShape::weibull}),
               std::invalid_argument);
  EXPECT_THROW(fit_psychometric(Blocks{{1, 4, 4}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
