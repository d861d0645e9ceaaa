// The probabilities of functions after responses, and the entropy expected of a level.

#include "analysis/psychometric/function_table.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Thresholds 1, 2 and 4; of each, slopes 1 and 3 with a lapse rate of 2 %. A slope follows the other of its threshold.
std::vector<PsychometricFunction> six_functions() {
  std::vector<PsychometricFunction> functions{};
  for (const double alpha : {1.0, 2.0, 4.0}) {
    for (const double beta : {1.0, 3.0}) {
      functions.push_back({.shape = PsychometricShape::weibull,
                           .alpha = alpha,
                           .beta = beta,
                           .gamma = 0.5,
                           .lambda = 0.02});
    }
  }
  return functions;
}

const std::vector<double> kTabulatedLevels{0.0, 0.5, 1.0, 2.0, 4.0, 8.0};

FunctionTable table_of(std::size_t of_group) {
  return {six_functions(), of_group, kTabulatedLevels};
}

double probability_of_hit(const FunctionTable& table, const Eigen::ArrayXd& weights, double x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < table.functions().size(); ++i) {
    sum += weights[static_cast<Eigen::Index>(i)] * table.functions()[i].value(x);
  }
  return sum;
}

/// After some responses, so that the functions are not equally probable.
Eigen::ArrayXd some_weights(const FunctionTable& table) {
  Eigen::ArrayXd weights = table.uniform();
  table.respond(weights, 3, true);
  table.respond(weights, 2, false);
  table.respond(weights, 4, true);
  return weights;
}

// The definition: both responses are tried, and the entropies afterwards averaged with their probabilities.
TEST(FunctionTable, ExpectsTheMeanOfTheEntropiesAfterBothResponses) {
  for (const std::size_t of_group : {1U, 2U, 3U, 6U}) {
    const FunctionTable table = table_of(of_group);
    const Eigen::ArrayXd weights = some_weights(table);
    const std::vector<double> expected = table.expected_entropies(weights);
    for (std::size_t level = 0; level < kTabulatedLevels.size(); ++level) {
      Eigen::ArrayXd after_hit = weights;
      Eigen::ArrayXd after_miss = weights;
      table.respond(after_hit, level, true);
      table.respond(after_miss, level, false);
      const double hit = probability_of_hit(table, weights, kTabulatedLevels[level]);
      EXPECT_NEAR(expected[level],
                  hit * table.entropy(after_hit) + (1.0 - hit) * table.entropy(after_miss), 1e-12);
    }
  }
}

// At x = 0 every function is at the guess rate: nothing can be learnt. Of one group nothing is unknown.
TEST(FunctionTable, ExpectsNothingOfALevelAtWhichAllFunctionsAgree) {
  const FunctionTable table = table_of(2);
  const Eigen::ArrayXd weights = some_weights(table);
  const std::vector<double> expected = table.expected_entropies(weights);
  EXPECT_NEAR(expected[0], table.entropy(weights), 1e-12);
  for (std::size_t level = 1; level < kTabulatedLevels.size(); ++level) {
    EXPECT_LT(expected[level], expected[0]);
  }
  EXPECT_NEAR(table_of(6).expected_entropies(weights)[3], 0.0, 1e-12);
}

// By hand: equally probable functions, ψ(2) of threshold 2 and both slopes ½ + 0.48·(1 − 1/e) = 0.8034. The entropy of three
// equally probable groups is ln 3.
TEST(FunctionTable, GivesTheProbabilitiesOfBayesTheorem) {
  const FunctionTable table = table_of(2);
  Eigen::ArrayXd weights = table.uniform();
  EXPECT_NEAR(table.entropy(weights), std::log(3.0), 1e-12);
  const double all = 6.0 * probability_of_hit(table, weights, 2.0);
  table.respond(weights, 3, true);
  EXPECT_NEAR(weights[2], (0.5 + 0.48 * (1.0 - std::exp(-1.0))) / all, 1e-12);
  EXPECT_NEAR(weights[2], weights[3], 1e-12);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
  EXPECT_NEAR(table.marginal(weights)[1], weights[2] + weights[3], 1e-12);
}

// The mean log likelihood of a guess between two alternatives: √(ψ·(1 − ψ)).
TEST(FunctionTable, TakesAResponseWithoutAChoiceAsTheMeanOfAGuess) {
  const FunctionTable table = table_of(1);
  Eigen::ArrayXd weights = some_weights(table);
  Eigen::ArrayXd expected = weights;
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    const double hit = table.functions()[static_cast<std::size_t>(i)].value(2.0);
    expected[i] *= std::sqrt(hit * (1.0 - hit));
  }
  expected /= expected.sum();
  Eigen::ArrayXd elsewhere = weights;
  table.guess(weights, 3, 0.5);
  table.guess_at(elsewhere, 2.0, 0.5);
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(weights[i], expected[i], 1e-12);
    EXPECT_NEAR(elsewhere[i], expected[i], 1e-12);
  }
}

TEST(FunctionTable, TakesALevelThatIsNotInTheTable) {
  const FunctionTable table = table_of(1);
  Eigen::ArrayXd by_table = some_weights(table);
  Eigen::ArrayXd by_level = by_table;
  Eigen::ArrayXd elsewhere = by_table;
  table.respond(by_table, 3, false);
  table.respond_at(by_level, 2.0, false);
  table.respond_at(elsewhere, 2.1, false);
  EXPECT_NEAR((by_table - by_level).abs().maxCoeff(), 0.0, 1e-15);
  EXPECT_GT((by_table - elsewhere).abs().maxCoeff(), 1e-4);
}

TEST(FunctionTable, RefusesWhatHasNoProbability) {
  EXPECT_THROW(FunctionTable({}, 1, kTabulatedLevels), std::invalid_argument);
  EXPECT_THROW(FunctionTable(six_functions(), 1, {}), std::invalid_argument);
  EXPECT_THROW(FunctionTable(six_functions(), 4, kTabulatedLevels), std::invalid_argument);
  const FunctionTable without_lapses(
      {{.shape = PsychometricShape::weibull, .alpha = 1.0, .beta = 8.0, .gamma = 0.5}}, 1, {100.0});
  Eigen::ArrayXd weights = without_lapses.uniform();
  EXPECT_THROW(without_lapses.respond(weights, 0, false), std::invalid_argument);
}

TEST(PlaceOfLeast, IsTheFirstOfValuesThatDifferByRounding) {
  const std::vector<double> values{2.0, 1.0 + 1e-13, 1.0, 1.5};
  EXPECT_EQ(place_of_least(values), 1U);
  const std::vector<double> distinct{2.0, 1.0 + 1e-7, 1.0, 1.5};
  EXPECT_EQ(place_of_least(distinct), 2U);
}

}  // namespace
}  // namespace asperity
