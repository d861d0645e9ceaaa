// The grid of functions of a prior, and the threshold that the responses leave.

#include "analysis/psychometric/threshold_prior.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/psychometric/function_table.h"

namespace asperity {
namespace {

ThresholdPrior small_prior() {
  return {.performance = 0.75,
          .thresholds = {.lowest = 1.0, .highest = 100.0, .count = 5},
          .slopes = {.lowest = 1.0, .highest = 4.0, .count = 3},
          .lapses = {.lowest = 0.0, .highest = 0.06, .count = 4}};
}

TEST(ThresholdPrior, HasTheThresholdsAtItsPerformanceWithAllLapseRates) {
  const auto functions = functions_of(small_prior(), {});
  ASSERT_EQ(functions.size(), 5U * 3U * 4U);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    // In steps of √10: 1, 3.16, 10, 31.6 and 100.
    const double threshold = std::pow(10.0, 0.5 * static_cast<double>(i / 12));
    EXPECT_NEAR(functions[i].value(threshold), 0.75, 1e-12);
  }
}

TEST(ThresholdPrior, GroupsTheFunctionsThatDifferInNuisancesAlone) {
  const std::vector<std::vector<NuisanceParameter>> choices{
      {},
      {NuisanceParameter::slope},
      {NuisanceParameter::lapse},
      {NuisanceParameter::slope, NuisanceParameter::lapse}};
  const std::vector<std::size_t> sizes{1, 3, 4, 12};
  for (std::size_t choice = 0; choice < choices.size(); ++choice) {
    const auto functions = functions_of(small_prior(), choices[choice]);
    const std::size_t of_group = functions_of_group(small_prior(), choices[choice]);
    ASSERT_EQ(of_group, sizes[choice]);
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const PsychometricFunction& first = functions[i - i % of_group];
      EXPECT_NEAR(functions[i].inverse(0.75), first.inverse(0.75), 1e-9);
      if (choice == 0 || choice == 2) {
        EXPECT_EQ(functions[i].beta, first.beta);
      }
      if (choice == 0 || choice == 1) {
        EXPECT_EQ(functions[i].lambda, first.lambda);
      }
    }
  }
}

TEST(ThresholdPrior, GivesTheSamePosteriorFromCountsAndFromSingleResponses) {
  const auto functions = functions_of(small_prior(), {});
  const FunctionTable table(functions, 1, {2.0, 5.0, 20.0});
  Eigen::ArrayXd weights = table.uniform();
  for (const auto& [level, is_hit] :
       {std::pair{0U, true}, std::pair{1U, false}, std::pair{1U, true}, std::pair{2U, true},
        std::pair{1U, true}, std::pair{0U, false}}) {
    table.respond(weights, level, is_hit);
  }
  const std::vector<PsychometricBlock> blocks{{.x = 2.0, .trials = 2, .hits = 1},
                                              {.x = 5.0, .trials = 3, .hits = 2},
                                              {.x = 20.0, .trials = 1, .hits = 1}};
  const std::vector<double> from_counts = posterior_of(functions, blocks);
  const auto size = static_cast<Eigen::Index>(from_counts.size());
  const Eigen::Map<const Eigen::ArrayXd> expected(from_counts.data(), size);
  EXPECT_NEAR((weights - expected).abs().maxCoeff(), 0.0, 1e-14);
}

// Without responses: log10 of the threshold is uniform between −¼ and 2¼, half a step beyond the ends. Its mean is 1, its
// 2.5 % quantile −0.25 + 0.025·2.5 = −0.1875, and two of five thresholds are at the ends.
TEST(CredibleThreshold, SpreadsTheProbabilitiesOverTheStepsOfThePrior) {
  const ThresholdPrior prior = small_prior();
  const auto functions = functions_of(prior, {});
  const std::vector<double> weights = posterior_of(functions, {});
  const CredibleThreshold own =
      credible_threshold(prior, functions, weights, {.performance = 0.75, .confidence = 0.95});
  EXPECT_NEAR(std::log10(own.value), 1.0, 1e-12);
  EXPECT_NEAR(std::log10(own.interval.low), -0.1875, 1e-9);
  EXPECT_NEAR(std::log10(own.interval.high), 2.1875, 1e-9);
  EXPECT_NEAR(own.at_ends, 0.4, 1e-12);
}

// A single slope and lapse rate: the threshold at 90 % is the same multiple of that at 75 % for every function.
TEST(CredibleThreshold, MovesToAnotherPerformanceByTheFunctions) {
  ThresholdPrior prior = small_prior();
  prior.slopes = {.lowest = 2.0, .highest = 2.0, .count = 1};
  prior.lapses = {.lowest = 0.02, .highest = 0.02, .count = 1};
  const auto functions = functions_of(prior, {});
  const std::vector<PsychometricBlock> blocks{{.x = 8.0, .trials = 20, .hits = 13},
                                              {.x = 16.0, .trials = 20, .hits = 18}};
  const std::vector<double> weights = posterior_of(functions, blocks);
  const auto at = [&](double performance) {
    return credible_threshold(prior, functions, weights, {.performance = performance});
  };
  // t(p) = −ln(1 − (p − ½)/0.48); the ratio is √(t(0.9)/t(0.75)).
  const double ratio = std::sqrt(std::log(1.0 - 0.4 / 0.48) / std::log(1.0 - 0.25 / 0.48));
  EXPECT_NEAR(at(0.9).value / at(0.75).value, ratio, 1e-9);
  EXPECT_NEAR(at(0.9).interval.low / at(0.75).interval.low, ratio, 1e-9);
  EXPECT_NEAR(at(0.9).interval.high / at(0.75).interval.high, ratio, 1e-9);
  EXPECT_LT(at(0.75).interval.low, at(0.75).value);
}

TEST(ThresholdPrior, HasTheGuessRateOfTheTask) {
  ThresholdPrior prior = small_prior();
  prior.guess_rate = 1.0 / 3.0;
  prior.performance = 0.45;  // too low for two alternatives
  const auto functions = functions_of(prior, {});
  for (const PsychometricFunction& f : functions) EXPECT_EQ(f.value(0.0), prior.guess_rate);
  EXPECT_NEAR(functions.front().value(prior.thresholds.lowest), 0.45, 1e-12);
  prior.guess_rate = 0.5;
  EXPECT_THROW(functions_of(prior, {}), std::invalid_argument);
}

TEST(ThresholdPrior, RefusesRangesWithoutFunctions) {
  const auto refused = [](const auto& change) {
    ThresholdPrior prior = small_prior();
    change(prior);
    EXPECT_THROW(functions_of(prior, {}), std::invalid_argument);
  };
  refused([](ThresholdPrior& prior) { prior.thresholds.lowest = 0.0; });
  refused([](ThresholdPrior& prior) { prior.slopes.count = 0; });
  refused([](ThresholdPrior& prior) { prior.lapses.highest = -0.1; });
  refused([](ThresholdPrior& prior) { prior.performance = 0.95; });
  refused([](ThresholdPrior& prior) { prior.performance = 0.5; });
  refused([](ThresholdPrior& prior) { prior.thresholds.count = 1; });
}

}  // namespace
}  // namespace asperity
