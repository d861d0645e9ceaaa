// Bootstrap intervals of psychometric functions of unforced choices.

#include "analysis/psychometric/unforced_bootstrap.h"

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/psychometric/psychometric_fit.h"

namespace asperity {
namespace {

const PsychometricModel kUnforcedModel{
    .shape = PsychometricShape::weibull, .gamma = 0.5, .lambda = 0.02};
const UnforcedQuestion kUnforcedQuestion{.model = kUnforcedModel, .performances = {0.75}};

/// `unsure` of 100 responses at each level, and the misses, with the hits of ψ for α = 10 and β = 2 on the whole.
std::vector<UnforcedBlock> unforced_levels(bool splits) {
  std::vector<UnforcedBlock> blocks{};
  for (const auto& [x, errors] : {std::pair{4.0, 42U}, {7.0, 31U}, {10.0, 20U}, {15.0, 7U}}) {
    // 2·errors responses "cannot tell" have the same expected hits as this number of errors.
    blocks.push_back(splits ? UnforcedBlock{x, 100 - 2 * errors, 0, 2 * errors}
                            : UnforcedBlock{x, 100 - errors, errors, 0});
  }
  return blocks;
}

TEST(SplitBlocks, CountTheMeanOfAGuess) {
  const PsychometricBlock block = split_block({.x = 2.0, .hits = 3, .misses = 4, .unsure = 5}, 3);
  EXPECT_EQ(block.trials, 12U);
  EXPECT_EQ(block.hits, 3U);
  EXPECT_DOUBLE_EQ(hits_of(block), 3.0 + 5.0 / 3.0);
  EXPECT_DOUBLE_EQ(hits_of(block) + misses_of(block), 12.0);
  EXPECT_THROW(split_block({}, 0), std::invalid_argument);
}

TEST(SplitBlocks, HaveTheFitOfCountsWithTheSameHits) {
  const auto fit_of = [](bool splits) {
    std::vector<PsychometricBlock> blocks{};
    for (const UnforcedBlock& block : unforced_levels(splits)) {
      blocks.push_back(split_block(block, 2));
    }
    return *fit_psychometric(blocks, {.model = kUnforcedModel, .performance = 0.75});
  };
  EXPECT_EQ(fit_of(true).threshold, fit_of(false).threshold);
  EXPECT_EQ(fit_of(true).function.beta, fit_of(false).function.beta);
}

TEST(PsychometricBlocks, RefuseMoreGuessedHitsThanTrialsWithoutAHit) {
  const std::vector<PsychometricBlock> blocks{
      {.x = 1.0, .trials = 5, .hits = 3, .guessed_hits = 2.5}, {.x = 2.0, .trials = 5, .hits = 3}};
  EXPECT_THROW(judge(blocks, kUnforcedModel), std::invalid_argument);
}

// A guess varies more than its mean: with every error split, the interval is narrower.
TEST(UnforcedBootstrap, IsNarrowerWhereGuessesAreReplaced) {
  const UnforcedBootstrap split =
      bootstrap_unforced(unforced_levels(true), 2, kUnforcedQuestion, 300);
  const UnforcedBootstrap forced =
      bootstrap_unforced(unforced_levels(false), 2, kUnforcedQuestion, 300);
  const auto& split_threshold = split.thresholds.front();
  const auto& forced_threshold = forced.thresholds.front();
  ASSERT_TRUE(split_threshold && forced_threshold && split.beta && forced.beta);
  EXPECT_GT(split.valid, 290U);
  EXPECT_LT(split_threshold->high - split_threshold->low,
            0.9 * (forced_threshold->high - forced_threshold->low));
}

// All draws of a step have the slope of the bound, which is no limit of a slope.
TEST(UnforcedBootstrap, HasNoIntervalOfASlopeAtItsBound) {
  const std::vector<UnforcedBlock> step{{.x = 1.0, .misses = 20},
                                        {.x = 2.0, .misses = 20},
                                        {.x = 3.0, .hits = 20},
                                        {.x = 4.0, .hits = 20}};
  const UnforcedQuestion question{
      .model = {.shape = PsychometricShape::normal, .gamma = 0.02, .lambda = 0.02},
      .performances = {0.5}};
  const UnforcedBootstrap bootstrap = bootstrap_unforced(step, 2, question, 20);
  EXPECT_EQ(bootstrap.valid, 20U);
  EXPECT_FALSE(bootstrap.beta);
}

TEST(UnforcedBootstrap, HasTheSameIntervalsForSeveralPerformancesAsForEach) {
  const std::vector<double> performances{0.75, 0.9};
  const UnforcedBootstrap both = bootstrap_unforced(
      unforced_levels(true), 2, {.model = kUnforcedModel, .performances = performances}, 60);
  ASSERT_EQ(both.thresholds.size(), 2U);
  for (std::size_t i = 0; i < performances.size(); ++i) {
    const UnforcedBootstrap one = bootstrap_unforced(
        unforced_levels(true), 2, {.model = kUnforcedModel, .performances = {performances[i]}}, 60);
    ASSERT_TRUE(both.thresholds[i] && one.thresholds.front());
    EXPECT_EQ(both.thresholds[i]->low, one.thresholds.front()->low);
    EXPECT_EQ(both.thresholds[i]->high, one.thresholds.front()->high);
    EXPECT_EQ(both.beta->low, one.beta->low);
  }
  EXPECT_GT(both.thresholds[1]->low, both.thresholds[0]->low);
}

}  // namespace
}  // namespace asperity
