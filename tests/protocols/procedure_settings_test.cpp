// The problems of the settings of procedures, and the grid of their levels.

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/procedures/procedure.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

UpDownTrack valid_track() {
  return {.grid = {.scale = LevelScale::linear, .lowest = 1.0, .highest = 10.0, .step = 0.5},
          .start = 5.0,
          .rule = {.up = 1, .down = 2},
          .steps_up = {1.0, 0.5},
          .steps_down = {0.5},
          .stop = {.trials = 40}};
}

auto problem(const std::string& setting, const std::string& remedy) {
  return AllOf(
      Field(&ProcedureProblem::setting, setting),
      Field(&ProcedureProblem::message, testing::Property(&Phrase::english, HasSubstr(remedy))));
}

/// The problems of the valid track after a change.
template <typename Change>
std::vector<ProcedureProblem> problems_after(const Change& change) {
  UpDownTrack track = valid_track();
  change(track);
  return problems_of(TransformedUpDown{.track = track});
}

TEST(ProcedureSettings, OfAValidTrackHaveNoProblem) {
  EXPECT_THAT(problems_after([](UpDownTrack&) {}), testing::IsEmpty());
}

TEST(ProcedureSettings, NeedAStopRuleWithALimitOfTrials) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.stop = {}; }),
              ElementsAre(problem("stop", "state a maximum number of trials")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.stop = {.reversals = 8}; }),
              ElementsAre(problem("stop.trials", "never reverses; state")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.stop.reversals = 0; }),
              ElementsAre(problem("stop.reversals", "above 0")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.stop.clipped_moves = 0; }),
              ElementsAre(problem("stop.clipped_moves", "above 0")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.stop.trials = 1000000; }),
              ElementsAre(problem("stop.trials", "lower it")));
}

TEST(ProcedureSettings, NeedStepsThatStayOnTheGrid) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) {
                track.steps_up = {1.0, 0.0};
              }),
              ElementsAre(problem("steps_up", "must be above 0")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.steps_down = {}; }),
              ElementsAre(problem("steps_down", "state at least one")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.steps_down = {0.7}; }),
              ElementsAre(problem("steps_down",
                                  "the step 0.7 is not a whole number of steps of the grid (0.5); "
                                  "change the step or the grid")));
}

TEST(ProcedureSettings, NeedAGridWithLevels) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.grid.highest = 0.5; }),
              ElementsAre(problem("grid.highest", "the grid is empty")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.grid.step = 0.0; }),
              ElementsAre(problem("grid.step", "must be above 0")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.grid.step = 1e-9; }),
              ElementsAre(problem("grid.step", "use a larger step")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) {
                track.grid.highest = std::numeric_limits<double>::infinity();
              }),
              ElementsAre(problem("grid.highest", "not a finite number")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) {
                track.grid = {
                    .scale = LevelScale::decibel, .lowest = 0.0, .highest = 1.0, .step = 1.0};
              }),
              ElementsAre(problem("grid.lowest", "raise it, or use the scale linear")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) {
                track.grid = {
                    .scale = LevelScale::ratio, .lowest = 1.0, .highest = 2.0, .step = 1.0};
              }),
              ElementsAre(problem("grid.step", "above 1, such as 1.1 for steps of 10 %")));
}

TEST(ProcedureSettings, NeedAStartOnTheGrid) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.start = 10.5; }),
              ElementsAre(problem("start", "outside the bounds 1 and 10; choose")));
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.start = 5.2; }),
              ElementsAre(problem("start", "use the nearest level, 5")));
  EXPECT_THAT(
      problems_after([](UpDownTrack& track) { track.grid.step = 20.0; }),
      testing::Contains(problem("start", "the grid has only one level, 1; reduce its step")));
}

TEST(ProcedureSettings, NeedARuleThatCounts) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) { track.rule = {.up = 0, .down = 0}; }),
              ElementsAre(problem("up", "above 0"), problem("down", "above 0")));
}

TEST(ProcedureSettings, OfSeveralFaultsHaveAllProblems) {
  EXPECT_THAT(problems_after([](UpDownTrack& track) {
                track.stop = {};
                track.start = 50.0;
                track.steps_up = {0.0};
              }),
              ElementsAre(problem("stop", ""), problem("start", ""), problem("steps_up", "")));
}

TEST(ProcedureSettings, OfAWeightedTrackNeedATargetWithStepsOnTheGrid) {
  WeightedUpDown method{.grid = valid_track().grid,
                        .start = 5.0,
                        .target = 0.75,
                        .steps_down = {0.5},
                        .stop = {.trials = 40}};
  EXPECT_THAT(problems_of(method), testing::IsEmpty());
  method.target = 0.8;  // 4 steps; 0.8/(1 − 0.8) is not exactly 4
  EXPECT_THAT(problems_of(method), testing::IsEmpty());
  method.target = 0.7;
  EXPECT_THAT(problems_of(method), ElementsAre(problem("target", "a step up is 2.33")));
  method.target = 1.0;
  EXPECT_THAT(problems_of(method), ElementsAre(problem("target", "between 0 and 1")));
  method.target = 0.75;
  method.steps_down = {0.0};
  EXPECT_THAT(problems_of(method), ElementsAre(problem("steps_down", "above 0")));
}

TEST(ProcedureSettings, OfConstantStimuliNeedLevelsInOrder) {
  const auto problems = [](std::vector<double> levels, std::size_t repetitions) {
    return problems_of(ConstantStimuli{.levels = std::move(levels), .repetitions = repetitions});
  };
  EXPECT_THAT(problems({1.0, 2.0}, 5), testing::IsEmpty());
  EXPECT_THAT(problems({}, 5), ElementsAre(problem("levels", "state at least one")));
  EXPECT_THAT(problems({2.0, 1.0}, 5), ElementsAre(problem("levels", "in ascending order")));
  EXPECT_THAT(problems({1.0, 1.0}, 5), ElementsAre(problem("levels", "each once")));
  EXPECT_THAT(problems({1.0}, 0), ElementsAre(problem("repetitions", "1 or more")));
  EXPECT_THAT(problems({1.0, 2.0}, 60000), ElementsAre(problem("repetitions", "fewer")));
}

TEST(ProcedureSettings, WithProblemsAreRefused) {
  const ConstantStimuli none{};
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] { next_step(none, {}, Random(1)); }),
              testing::StartsWith("levels: there is no level"));
  EXPECT_THROW(simulated_track(
                   none, [](double) { return 1.0; }, Random(1)),
               std::invalid_argument);
  EXPECT_THROW(expected_trials(none, [](double) { return 1.0; }), std::invalid_argument);
}

TEST(LevelGrid, HasItsEndsAndEqualSteps) {
  const LevelGrid grid{.scale = LevelScale::linear, .lowest = 0.1, .highest = 0.5, .step = 0.1};
  const std::vector<double> levels = levels_of(grid);
  ASSERT_EQ(levels.size(), 5U);  // 0.5 is on the grid in spite of rounding
  EXPECT_EQ(levels.front(), 0.1);
  EXPECT_NEAR(levels.back(), 0.5, 1e-15);
  const LevelGrid octaves{.scale = LevelScale::ratio, .lowest = 1.0, .highest = 9.0, .step = 2.0};
  EXPECT_THAT(levels_of(octaves), ElementsAre(1, 2, 4, 8));
}

TEST(LevelGrid, FindsTheNearestLevelOnItsScale) {
  const LevelGrid octaves{.scale = LevelScale::ratio, .lowest = 1.0, .highest = 8.0, .step = 2.0};
  EXPECT_EQ(nearest_index(octaves, 2.8), 1U);  // √8 = 2.83 is the middle of 2 and 4
  EXPECT_EQ(nearest_index(octaves, 2.9), 2U);
  EXPECT_EQ(nearest_index(octaves, 1000.0), 3U);
  EXPECT_EQ(nearest_index(octaves, 0.001), 0U);
  EXPECT_EQ(nearest_index(octaves, 0.0), 0U);
  EXPECT_TRUE(is_on(octaves, 4.0));
  EXPECT_FALSE(is_on(octaves, 4.1));
  EXPECT_FALSE(is_on(octaves, 16.0));
  EXPECT_EQ(grid_steps(octaves, 8.0), 3U);
  EXPECT_EQ(grid_steps(octaves, 3.0), 0U);
}

}  // namespace
}  // namespace asperity
