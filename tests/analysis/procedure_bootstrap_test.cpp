// Intervals by running a procedure again: against the likelihood, and what they count.

#include "analysis/psychometric/procedure_bootstrap.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/psychometric/psychometric_fit.h"

namespace asperity {
namespace {

constexpr PsychometricFunction kTrue{
    .shape = PsychometricShape::weibull, .alpha = 1.0, .beta = 2.0, .gamma = 0.5, .lambda = 0.02};

/// The same levels for every observer, as often as stated.
ProcedureRun constant_levels(std::uint64_t trials) {
  return [trials](const PsychometricFunction& observer, const Random& of_run) {
    Random random = of_run.split("responses");
    std::vector<PsychometricBlock> blocks{};
    for (const double x : {0.4, 0.7, 1.0, 1.4, 2.0}) {
      PsychometricBlock block{.x = x, .trials = trials};
      for (std::uint64_t i = 0; i < trials; ++i) {
        block.hits += random.uniform() < observer.value(x) ? 1 : 0;
      }
      blocks.push_back(block);
    }
    return blocks;
  };
}

ProcedureBootstrapQuestion question_of_bootstrap(std::size_t repetitions = 200) {
  return {.family = {.thresholds = {.low = 0.2, .high = 5.0},
                     .slopes = {.least = 1.0, .greatest = 8.0}},
          .repetitions = repetitions};
}

// With many trials at constant levels the statistic has the distribution of χ², and all intervals are nearly equal.
TEST(ProcedureBootstrap, AgreesWithTheDeltaIntervalOfManyTrialsAtConstantLevels) {
  const ProcedureRun run = constant_levels(1000);
  const auto blocks = run(kTrue, Random(3));
  const auto found = bootstrap_procedure(blocks, question_of_bootstrap(400), run, Random(1));
  const auto fit = fit_psychometric(blocks, {.model = {.shape = PsychometricShape::weibull,
                                                       .gamma = 0.5,
                                                       .lambda = std::nullopt,
                                                       .greatest_lambda = 0.06},
                                             .performance = 0.75});
  ASSERT_TRUE(found.threshold && found.slope && fit && fit->precision);
  EXPECT_EQ(found.without, 0U);
  const ConfidenceInterval& delta = fit->precision->threshold;
  const double width = delta.high - delta.low;
  EXPECT_NEAR(found.threshold->low, delta.low, 0.25 * width);
  EXPECT_NEAR(found.threshold->high, delta.high, 0.25 * width);
  EXPECT_LT(found.slope->low, kTrue.beta);
  EXPECT_GT(found.slope->high, kTrue.beta);
}

TEST(ProcedureBootstrap, IsAFunctionOfItsStream) {
  const ProcedureRun run = constant_levels(12);
  const auto blocks = run(kTrue, Random(4));
  const auto one = bootstrap_procedure(blocks, question_of_bootstrap(), run, Random(1));
  const auto again = bootstrap_procedure(blocks, question_of_bootstrap(), run, Random(1));
  const auto other = bootstrap_procedure(blocks, question_of_bootstrap(), run, Random(2));
  EXPECT_EQ(one.threshold->low, again.threshold->low);
  EXPECT_EQ(one.threshold->high, again.threshold->high);
  EXPECT_NE(one.threshold->high, other.threshold->high);
}

TEST(ProcedureBootstrap, IsWiderForAGreaterConfidenceAndForFewerTrials) {
  const auto width_of = [](std::uint64_t trials, double confidence) {
    const ProcedureRun run = constant_levels(trials);
    ProcedureBootstrapQuestion question = question_of_bootstrap();
    question.confidence = confidence;
    const auto found = bootstrap_procedure(run(kTrue, Random(5)), question, run, Random(1));
    return found.threshold->high - found.threshold->low;
  };
  EXPECT_GT(width_of(40, 0.95), width_of(40, 0.68));
  EXPECT_GT(width_of(40, 0.95), width_of(400, 0.95));
}

TEST(ProcedureBootstrap, CountsRepetitionsWithoutAThreshold) {
  const ProcedureRun run = constant_levels(40);
  const auto blocks = run(kTrue, Random(6));
  std::size_t calls = 0;
  const auto every = [&](std::size_t n) {
    calls = 0;
    return ProcedureRun([&, n](const PsychometricFunction& observer, const Random& of_run) {
      auto drawn = run(observer, of_run);
      if (++calls % n == 0) {
        for (PsychometricBlock& block : drawn) block.hits = block.trials;  // all correct
      }
      return drawn;
    });
  };
  const std::size_t undisturbed =
      bootstrap_procedure(blocks, question_of_bootstrap(), run, Random(1)).without;
  const auto some = bootstrap_procedure(blocks, question_of_bootstrap(), every(4), Random(1));
  EXPECT_EQ(some.repetitions, 200U);
  EXPECT_GE(some.without, 50U);
  EXPECT_LE(some.without, 50U + undisturbed);
  EXPECT_TRUE(some.threshold);
  const auto all = bootstrap_procedure(blocks, question_of_bootstrap(), every(1), Random(1));
  EXPECT_EQ(all.without, 200U);
  EXPECT_FALSE(all.threshold || all.slope);
}

// The placement by the responses: a run that presents only what the last response decides has another critical value.
TEST(ProcedureBootstrap, DependsOnTheProcedureAndNotOnTheCountsAlone) {
  const ProcedureRun constant = constant_levels(12);
  const ProcedureRun adaptive = [](const PsychometricFunction& observer, const Random& of_run) {
    Random random = of_run.split("responses");
    std::vector<PsychometricBlock> blocks{
        {.x = 0.4}, {.x = 0.7}, {.x = 1.0}, {.x = 1.4}, {.x = 2.0}};
    std::size_t at = 4;
    for (int trial = 0; trial < 60; ++trial) {
      const bool is_hit = random.uniform() < observer.value(blocks[at].x);
      ++blocks[at].trials;
      blocks[at].hits += is_hit ? 1 : 0;
      if (is_hit && at > 0) --at;
      if (!is_hit) at = std::min<std::size_t>(4, at + 3);
    }
    std::erase_if(blocks, [](const PsychometricBlock& block) { return block.trials == 0; });
    return blocks;
  };
  const auto blocks = constant(kTrue, Random(7));
  const auto one = bootstrap_procedure(blocks, question_of_bootstrap(), constant, Random(1));
  const auto other = bootstrap_procedure(blocks, question_of_bootstrap(), adaptive, Random(1));
  EXPECT_NE(one.threshold->high, other.threshold->high);
}

TEST(ProcedureBootstrap, RefusesEmptyRangesAndSingleLevels) {
  const ProcedureRun run = constant_levels(12);
  const auto blocks = run(kTrue, Random(8));
  ProcedureBootstrapQuestion question = question_of_bootstrap();
  question.family.thresholds = {.low = 2.0, .high = 1.0};
  EXPECT_THROW(bootstrap_procedure(blocks, question, run, Random(1)), std::invalid_argument);
  question = question_of_bootstrap();
  question.family.slopes = {.least = 0.0, .greatest = 8.0};
  EXPECT_THROW(bootstrap_procedure(blocks, question, run, Random(1)), std::invalid_argument);
  const std::vector<PsychometricBlock> single{{.x = 1.0, .trials = 10, .hits = 7}};
  EXPECT_THROW(bootstrap_procedure(single, question_of_bootstrap(), run, Random(1)),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
