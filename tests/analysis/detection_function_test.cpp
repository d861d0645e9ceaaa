// Fits the psychometric functions of simulated observers of yes/no and same–different tasks.

#include "analysis/psychometric/detection_function.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/choices/decision_rules.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

/// Half of the trials without a difference, the others at six differences.
std::vector<PsychometricBlock> simulated_blocks(const DetectionFunction& observer,
                                                std::uint64_t trials_of_level, Random& random) {
  std::vector<PsychometricBlock> blocks{{.x = 0.0, .trials = 6 * trials_of_level}};
  for (const double x : {0.25, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    blocks.push_back({.x = x, .trials = trials_of_level});
  }
  for (PsychometricBlock& block : blocks) {
    for (std::uint64_t i = 0; i < block.trials; ++i) {
      block.hits += random.uniform() < observer.value(block.x) ? 1 : 0;
    }
  }
  return blocks;
}

constexpr DetectionFunction kYesNo{
    .task = DetectionTask::yes_no, .alpha = 1.2, .beta = 1.3, .criterion = 0.8, .lambda = 0.02};
constexpr DetectionFunction kSameDifferent{.task = DetectionTask::same_different,
                                           .alpha = 0.8,
                                           .beta = 1.1,
                                           .criterion = 1.6,
                                           .lambda = 0.02};

TEST(DetectionFunctions, HaveTheFalseAlarmsAndTheHitsOfTheDecisionRules) {
  EXPECT_NEAR(probability_of_yes(DetectionTask::yes_no, 0.0, 0.7), normal_below(-0.7), 1e-15);
  const double false_alarm = probability_of_yes(DetectionTask::same_different, 0.0, 1.1);
  EXPECT_NEAR(same_different_criterion(false_alarm), 1.1, 1e-12);
  EXPECT_NEAR(probability_of_yes(DetectionTask::same_different, 1.4, 1.1),
              same_different_hit_rate(1.4, false_alarm, DecisionRule::differencing), 1e-12);
  EXPECT_DOUBLE_EQ(kYesNo.dprime(1.2), 1.0);
}

// With 99.9 % intervals, 40 observers of each task miss the truth with a probability of about 8 % if one miss is excluded;
// two misses have a probability of 0.3 %.
TEST(DetectionFunctions, ContainThePlantedDifferenceInTheirIntervals) {
  Random random(11);
  for (const DetectionFunction& observer : {kYesNo, kSameDifferent}) {
    int misses = 0;
    for (int i = 0; i < 40; ++i) {
      const DetectionFit fit =
          fit_detection(simulated_blocks(observer, 40, random),
                        {.task = observer.task, .lambda = 0.02, .confidence = 0.999});
      ASSERT_EQ(fit.status, DetectionStatus::ok);
      if (!fit.alpha) continue;
      misses += observer.alpha < fit.alpha->low || observer.alpha > fit.alpha->high ? 1 : 0;
    }
    EXPECT_LE(misses, 1);
  }
}

// 400 observers: the standard error of a coverage of 95 % is 1.1 %.
TEST(DetectionFunctions, HaveIntervalsThatCoverNearTheirConfidence) {
  Random random(12);
  for (const DetectionFunction& observer : {kYesNo, kSameDifferent}) {
    int covers = 0;
    int intervals = 0;
    for (int i = 0; i < 400; ++i) {
      const DetectionFit fit = fit_detection(simulated_blocks(observer, 40, random),
                                             {.task = observer.task, .lambda = 0.02});
      if (!fit.alpha) continue;
      ++intervals;
      covers += observer.alpha >= fit.alpha->low && observer.alpha <= fit.alpha->high ? 1 : 0;
    }
    EXPECT_GT(intervals, 380);
    EXPECT_NEAR(static_cast<double>(covers) / intervals, 0.95, 0.035);
  }
}

TEST(DetectionFunctions, RecoverAllParametersFromManyTrials) {
  Random random(13);
  for (const DetectionFunction& observer : {kYesNo, kSameDifferent}) {
    const DetectionFit fit = fit_detection(simulated_blocks(observer, 40'000, random),
                                           {.task = observer.task, .lambda = 0.02});
    ASSERT_EQ(fit.status, DetectionStatus::ok);
    EXPECT_NEAR(fit.function.alpha, observer.alpha, 0.03);
    EXPECT_NEAR(fit.function.beta, observer.beta, 0.05);
    EXPECT_NEAR(fit.function.criterion, observer.criterion, 0.03);
    EXPECT_EQ(fit.deviance_df, 4.0);
    EXPECT_LT(fit.deviance, 25.0);
  }
}

TEST(DetectionFunctions, StateWhyThereIsNone) {
  const DetectionModel model{.task = DetectionTask::yes_no, .lambda = 0.02};
  const auto status = [&model](const std::vector<PsychometricBlock>& blocks) {
    return fit_detection(blocks, model).status;
  };
  EXPECT_EQ(status({{1.0, 10, 5}, {2.0, 10, 8}}), DetectionStatus::no_data);
  EXPECT_EQ(status({{0.0, 10, 10}, {1.0, 10, 10}}), DetectionStatus::all_yes);
  EXPECT_EQ(status({{0.0, 10, 0}, {1.0, 10, 0}}), DetectionStatus::all_no);
  EXPECT_EQ(status({{0.0, 20, 10}, {1.0, 10, 3}, {2.0, 10, 2}}), DetectionStatus::not_increasing);
  // Every exponent would fit.
  EXPECT_EQ(status({{0.0, 20, 4}, {1.0, 20, 15}}), DetectionStatus::one_difference);
  const DetectionFit step = fit_detection(
      std::vector<PsychometricBlock>{{0.0, 20, 0}, {1.0, 10, 0}, {2.0, 10, 10}, {3.0, 10, 10}},
      model);
  EXPECT_EQ(step.status, DetectionStatus::separated);
  ASSERT_TRUE(step.bracket);
  EXPECT_EQ(step.bracket->low, 1.0);
  EXPECT_EQ(step.bracket->high, 2.0);
  EXPECT_THROW(fit_detection(std::vector<PsychometricBlock>{{-1.0, 2, 1}}, model),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
