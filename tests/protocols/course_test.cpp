// The course of a session whose levels a procedure chooses.

#include "protocols/plan/course.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric_function.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/plan/block_design.h"
#include "tests/protocols/example.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two tracks of a 2-down/1-up staircase for each of two explorations, and a fixed block after them.
json staircases() {
  return json::parse(R"({
    "format": "asperity.protocol/2", "kind": "discrimination", "design": "improved", "name": "staircases",
    "version": "1.0.0", "title": "Staircases",
    "consent": {"version": "1.0", "statement": "I take part of my own free will."},
    "factors": {"stroking": {"levels": ["slow", "fast"]}, "shade": {"levels": ["a", "b", "c"]}},
    "stimuli": {"scaled": {"model": "pd_gradient", "surface": "ball", "tool": "ball",
                           "parameters": {"texture_gain": 1}}},
    "bodies": {"ball": {"shape": "sphere", "diameter_m": 0.02, "axis": "z"}},
    "explorations": {"slow": {}, "fast": {}},
    "blocks": {
      "tracks": {
        "crossed": ["stroking"], "drawn": ["shade"], "exploration": {"factor": "stroking"},
        "vary": {"parameter": "texture_gain", "of": "comparison", "relative_to": "standard",
                 "levels_percent": {"lowest": 10, "highest": 100, "step": 10}},
        "procedure": {"method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10],
                      "stop": {"trials": 6}, "tracks": [{"start": 60}, {"start": 20}]},
        "presented": [{"role": "standard", "stimulus": "scaled"}, {"role": "comparison", "stimulus": "scaled"}],
        "positions": "balanced",
        "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}},
      "after": {
        "phase": "practice", "exploration": "slow",
        "vary": {"parameter": "texture_gain", "of": "comparison", "relative_to": "standard", "levels_ratio": [2, 3]},
        "presented": [{"role": "standard", "stimulus": "scaled"}, {"role": "comparison", "stimulus": "scaled"}],
        "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
    "flow": [{"screen": "Welcome"}, {"run": "tracks", "break_every_trials": 5, "pause": {"minimum_s": 10}},
             {"run": "after"}, {"screen": "Goodbye"}]})");
}

Protocol protocol_of(const json& file) {
  ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  for (const Diagnostic& problem : reading.problems) {
    ADD_FAILURE() << problem.pointer << ": " << problem.message;
  }
  return reading.protocol.value_or(Protocol{});
}

double gain_of(const Trial& trial) { return std::get<double>(trial.factors.at("texture_gain")); }

/// The comparison is chosen in two of three trials of a track, first at its second step.
TrialOutcome outcome_by_step(const Trial& trial) {
  return {.answer = TrialOutcome::Answer{.value = gain_of(trial),
                                         .counts_down = trial.track->step % 3 != 1}};
}

Course answered_course(const Protocol& protocol, std::uint64_t seed) {
  Course course(protocol, {.seed = seed});
  while (const Trial* const trial = course.awaited()) course.advance(outcome_by_step(*trial));
  return course;
}

TEST(Course, OfAProtocolWithoutProceduresIsCompleteAtOnce) {
  json file = staircases();
  file["blocks"].erase("tracks");
  file["flow"].erase(1);
  file["factors"].erase("stroking");
  file["blocks"]["after"]["phase"] = "main";
  file["blocks"]["after"]["positions"] = "balanced";
  const Protocol protocol = protocol_of(file);
  Course course(protocol, {.seed = 3});
  EXPECT_EQ(course.awaited(), nullptr);
  EXPECT_EQ(course.plan().trials.size(), 2U);
  EXPECT_EQ(course.trials_before_last_outcome(), 2U);
  EXPECT_THROW(course.advance({}), std::logic_error);
}

TEST(Course, EndsWithTheTrialWhoseOutcomeDeterminesTheNext) {
  const Protocol protocol = protocol_of(staircases());
  Course course(protocol, {.seed = 3});
  ASSERT_EQ(course.plan().trials.size(), 1U);
  ASSERT_EQ(course.awaited(), &course.plan().trials.back());
  EXPECT_EQ(course.plan().blocks, 2);
  const Trial& first = course.plan().trials.front();
  for (std::size_t trial = 1; trial < 24; ++trial) {
    course.advance(outcome_by_step(*course.awaited()));
    ASSERT_EQ(course.plan().trials.size(), trial + 1);
  }
  course.advance(outcome_by_step(*course.awaited()));
  EXPECT_EQ(course.awaited(), nullptr);
  EXPECT_EQ(course.plan().trials.size(), 26U);
  EXPECT_EQ(course.trials_before_last_outcome(), 24U);
  EXPECT_EQ(&first, &course.plan().trials.front()) << "a reference remains valid";
  EXPECT_TRUE(std::holds_alternative<Protocol::Screen>(course.plan().steps.back()));
}

TEST(Course, ProposesTheLevelsOfTheProcedureOfEachTrack) {
  const Protocol protocol = protocol_of(staircases());
  const Course course = answered_course(protocol, 11);
  std::map<int, std::vector<double>> percent{};
  for (const Trial& trial : course.plan().trials) {
    if (trial.track) percent[trial.track->track].push_back(100.0 * (gain_of(trial) - 1.0));
  }
  ASSERT_EQ(percent.size(), 4U);
  const auto& settings = protocol.blocks.at("tracks").procedure->tracks;
  for (auto& [track, levels] : percent) {
    const ProcedureSettings& own = settings[static_cast<std::size_t>(track - 1) % 2];
    std::vector<LevelAnswer> answers{};
    for (std::size_t step = 0; step < levels.size(); ++step) {
      const NextStep next = next_step(own, answers, Random(0));
      EXPECT_NEAR(levels[step], std::get<NextLevel>(next).level, 1e-9) << track << '/' << step;
      answers.push_back({.level = std::get<NextLevel>(next).level, .is_correct = step % 3 != 0});
    }
    EXPECT_TRUE(std::holds_alternative<TrackEnd>(next_step(own, answers, Random(0))));
  }
}

TEST(Course, InterleavesTracksInRoundsInAnOrderOfTheSeed) {
  const Protocol protocol = protocol_of(staircases());
  std::set<std::vector<int>> orders{};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::vector<int> tracks{};
    const Course course = answered_course(protocol, seed);
    for (const Trial& trial : course.plan().trials) {
      if (trial.track) tracks.push_back(trial.track->track);
    }
    ASSERT_EQ(tracks.size(), 24U);
    for (std::size_t round = 0; round < 6; ++round) {
      const auto begin = tracks.begin() + static_cast<std::ptrdiff_t>(4 * round);
      EXPECT_THAT(std::vector<int>(begin, begin + 4), testing::UnorderedElementsAre(1, 2, 3, 4));
    }
    orders.insert(tracks);
  }
  EXPECT_EQ(orders.size(), 3U);
}

TEST(Course, RunsTracksOneAfterAnotherInFixedOrder) {
  json file = staircases();
  file["blocks"]["tracks"]["order"] = "fixed";
  const Protocol protocol = protocol_of(file);
  std::vector<int> tracks{};
  const Course course = answered_course(protocol, 1);
  for (const Trial& trial : course.plan().trials) {
    if (trial.track) tracks.push_back(trial.track->track);
  }
  EXPECT_TRUE(std::is_sorted(tracks.begin(), tracks.end()));
}

TEST(Course, BalancesPositionsAndDrawnLevelsInEveryTrack) {
  const Protocol protocol = protocol_of(staircases());
  std::map<int, int> comparison_first{};
  std::map<int, std::map<std::string, int>> shades{};
  const Course course = answered_course(protocol, 5);
  for (const Trial& trial : course.plan().trials) {
    if (!trial.track) continue;
    comparison_first[trial.track->track] += trial.presentations[0].role == "comparison" ? 1 : 0;
    ++shades[trial.track->track][text_of(trial.factors.at("shade"))];
  }
  for (const auto& [track, count] : comparison_first) EXPECT_EQ(count, 3) << track;
  for (const auto& [track, counts] : shades) {
    for (const auto& [shade, count] : counts) EXPECT_EQ(count, 2) << track << shade;
  }
}

TEST(Course, PresentsTheLevelAgainAfterATrialThatDoesNotCount) {
  json file = staircases();
  file["blocks"]["tracks"]["procedure"]["tracks"] = json::parse(R"([{"start": 60}])");
  file["blocks"]["tracks"].erase("crossed");
  file["blocks"]["tracks"]["exploration"] = "slow";
  file["factors"].erase("stroking");
  const Protocol protocol = protocol_of(file);
  Course course(protocol, {.seed = 1});
  course.advance({.answer = TrialOutcome::Answer{.value = 1.6, .counts_down = false}});
  EXPECT_DOUBLE_EQ(gain_of(*course.awaited()), 1.8);
  course.advance({});
  EXPECT_DOUBLE_EQ(gain_of(*course.awaited()), 1.8);
  EXPECT_EQ(course.awaited()->track, (TrackStep{.track = 1, .step = 3}));
  for (int i = 0; i < 5; ++i) course.advance(outcome_by_step(*course.awaited()));
  EXPECT_EQ(course.awaited(), nullptr) << "six answers, one trial without";
}

// A participant who has stopped responding does not get the same level for ever.
TEST(Course, EndsWithoutAnswersAtTwiceTheTrialsOfItsTracks) {
  const Protocol protocol = protocol_of(staircases());
  Course course(protocol, {.seed = 1});
  std::size_t trials = 0;
  for (; course.awaited() != nullptr && trials < 1000; ++trials) course.advance({});
  EXPECT_EQ(trials, 4U * 2U * 6U);
}

TEST(Course, MovesFromTheDeliveredLevel) {
  const Protocol protocol = protocol_of(staircases());
  Course course(protocol, {.seed = 1});
  const int track = course.awaited()->track->track;
  course.advance({.answer = TrialOutcome::Answer{.value = 1.3, .counts_down = false}});
  while (course.awaited()->track->track != track)
    course.advance(outcome_by_step(*course.awaited()));
  EXPECT_NEAR(gain_of(*course.awaited()), 1.5, 1e-9) << "30 % and a step of 20 %";
}

TEST(Course, HasItsBreaksBetweenTrialsAndNoneAtTheEnd) {
  const Protocol protocol = protocol_of(staircases());
  const Plan plan = answered_course(protocol, 1).plan();
  std::vector<std::size_t> breaks{};
  std::size_t trials = 0;
  for (const PlanStep& step : plan.steps) {
    if (std::holds_alternative<TrialStep>(step)) ++trials;
    if (std::holds_alternative<Protocol::Break>(step)) breaks.push_back(trials);
  }
  EXPECT_THAT(breaks, ElementsAre(5, 10, 15, 20));
}

TEST(Course, StatesTrackAndStepInThePlanOnlyWhereThereAreTracks) {
  const Protocol protocol = protocol_of(staircases());
  const Plan plan = answered_course(protocol, 1).plan();
  EXPECT_THAT(json_of(plan.trials.front()), HasSubstr(R"("repetition":1,"track":)"));
  EXPECT_THAT(json_of(plan.trials.back()), testing::Not(HasSubstr("track\":")));
}

TEST(Course, HasAnExampleOfItself) {
  const Protocol protocol = protocol_of(staircases());
  const Plan plan = example_plan(protocol, {.seed = 1});
  EXPECT_EQ(plan.trials.size(), 26U);
  EXPECT_GT(cost_of(protocol, plan).total_s,
            cost_of(protocol, make_plan(protocol, {1, 0})).total_s);
}

TEST(Course, CanPresentEveryLevelOfItsGrid) {
  const Protocol protocol = protocol_of(staircases());
  std::set<std::pair<std::string, double>> levels{};
  for (const Trial& trial : possible_trials(protocol)) {
    if (trial.block == "tracks")
      levels.insert({text_of(trial.factors.at("stroking")), gain_of(trial)});
  }
  EXPECT_EQ(levels.size(), 20U);
}

TEST(DesignOfABlock, IsStatedInASentence) {
  const Protocol protocol = protocol_of(staircases());
  const Plan plan = example_plan(protocol, {.seed = 1});
  const std::string design = design_of(protocol, protocol.blocks.at("tracks"), plan);
  EXPECT_THAT(
      design,
      HasSubstr("2-down/1-up staircase (70.7 %), 6 trials × 2 interleaved tracks, for each of 2 "
                "conditions, about "));
  EXPECT_THAT(design, HasSubstr("; standard error of the log10 threshold at least 0."));
}

// At its best level a trial of a Weibull function with the slope 1.3 has an information of about 0.55 about log10 α
// (γ 0.5, λ 0.02); the bound cannot be below that of all trials at that level.
TEST(DesignOfABlock, HasAnErrorThatMoreTrialsMakeSmaller) {
  json file = staircases();
  const auto error_of = [&file](int trials) {
    file["blocks"]["tracks"]["procedure"]["stop"]["trials"] = trials;
    return least_threshold_error(protocol_of(file).blocks.at("tracks")).value();
  };
  const double with_20 = error_of(20);
  const double with_80 = error_of(80);
  EXPECT_NEAR(with_20 / with_80, 2.0, 0.15);
  PsychometricFunction f{.shape = PsychometricShape::weibull,
                         .alpha = 1.0,
                         .beta = kIncrementSlope,
                         .gamma = 0.5,
                         .lambda = 0.02};
  double most = 0.0;
  for (double x = 0.1; x < 5.0; x += 0.01) {
    const double psi = f.value(x);
    const double by_log10 =
        (f.value(x * 1.0001) - f.value(x / 1.0001)) / (2.0 * std::log10(1.0001));
    most = std::max(most, by_log10 * by_log10 / (psi * (1.0 - psi)));
  }
  EXPECT_GE(with_80, 1.0 / std::sqrt(most * 160.0));
  EXPECT_LT(with_80, 2.0 / std::sqrt(most * 160.0));
}

TEST(DesignOfABlock, HasNoErrorWhereNothingIsCorrect) {
  Protocol protocol = protocol_of(staircases());
  Protocol::Block& block = protocol.blocks.at("tracks");
  block.questions.front().judgement = DiscriminationJudgement::comparison;
  EXPECT_EQ(least_threshold_error(block), std::nullopt);
}

/// A fault of a file: what is set, where, and the problem.
struct PlantedFault {
  const char* patch;
  const char* pointer;
  const char* message;
};

class FaultOfAProcedure : public testing::TestWithParam<PlantedFault> {};

TEST_P(FaultOfAProcedure, IsReportedAtItsPlaceWithTheRemedy) {
  json file = staircases();
  file["blocks"]["tracks"].merge_patch(json::parse(GetParam().patch));
  const ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  std::vector<std::string> found{};
  for (const Diagnostic& problem : reading.problems) {
    found.push_back(problem.pointer + ": " + problem.message);
  }
  EXPECT_THAT(found, testing::Contains(
                         HasSubstr(std::string("/blocks/tracks") + GetParam().pointer + ": ")))
      << GetParam().message;
  EXPECT_THAT(found, testing::Contains(HasSubstr(GetParam().message)));
  for (const Diagnostic& problem : reading.problems) EXPECT_GT(problem.line, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Planted, FaultOfAProcedure,
    testing::Values(
        PlantedFault{R"({"procedure": {"stop": null}})", "/procedure", "there is no stopping rule"},
        PlantedFault{R"({"procedure": {"steps": [0]}})", "/procedure/steps",
                     "does not change the level"},
        PlantedFault{R"({"procedure": {"steps": [15]}})", "/procedure/steps",
                     "not a whole number of steps of the grid"},
        PlantedFault{R"({"procedure": {"steps": null}})", "/procedure", "there is no step"},
        PlantedFault{R"({"procedure": {"tracks": [{"start": 200}]}})", "/procedure/tracks/0/start",
                     "outside the bounds 10 and 100"},
        PlantedFault{R"({"procedure": {"tracks": [{"start": 15}]}})", "/procedure/tracks/0/start",
                     "use the nearest level"},
        PlantedFault{R"({"procedure": {"tracks": null}})", "/procedure", "no start is stated"},
        PlantedFault{R"({"procedure": {"target": 0.75}})", "/procedure/target", "has no such key"},
        PlantedFault{R"({"vary": {"levels_percent": [10, 20]}})", "/vary/levels_percent",
                     "state the levels as a grid"},
        PlantedFault{R"({"vary": {"levels_percent": {"lowest": 50, "highest": 40}}})",
                     "/vary/levels_percent/highest", "the grid is empty"},
        PlantedFault{R"({"vary": {"levels_percent": {"highest": 2000}}})",
                     "/vary/levels_percent/highest", "it must be a number from 0 to 10"},
        PlantedFault{R"({"vary": {"levels_percent": {"lowest": -90, "highest": -10}},
                         "procedure": {"tracks": [{"start": -50}]}})",
                     "/procedure/method", "below the standard lower levels are easier"},
        PlantedFault{R"({"all_pairs": {"factor": "nope"}})", "/all_pairs",
                     "does not compare surfaces"},
        PlantedFault{R"({"repetitions": 3})", "/repetitions",
                     "the procedure determines the trials"},
        PlantedFault{R"({"procedure": {"stop": {"trials": 600}}})", "/procedure",
                     "too many for a participant"}));

TEST(FaultOfAProcedure, WithoutAParameterToVary) {
  json file = staircases();
  file["blocks"]["tracks"].erase("vary");
  const ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  std::vector<std::string> found{};
  for (const Diagnostic& problem : reading.problems) found.push_back(problem.message);
  EXPECT_THAT(found, testing::Contains(HasSubstr("add \"vary\"")));
}

TEST(FaultOfAProcedure, IsOneNameForTwoParameters) {
  json file = staircases();
  file["stimuli"]["scaled"]["parameters"]["tool_gain"] = 1;
  file["blocks"]["after"]["vary"]["factor"] = "level";
  file["blocks"]["tracks"]["vary"]["factor"] = "level";
  file["blocks"]["after"]["vary"]["parameter"] = "step";
  const ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  std::vector<std::string> found{};
  for (const Diagnostic& problem : reading.problems) {
    found.push_back(problem.pointer + ": " + problem.message);
  }
  EXPECT_THAT(found, testing::Contains(testing::AllOf(HasSubstr("/blocks/after/vary/factor: "),
                                                      HasSubstr("under the name \"level\""))));
}

TEST(FaultOfAProcedure, IsAnExplorationThatPutsTrialsOff) {
  json file = staircases();
  file["explorations"]["fast"]["on_failure"] = "requeue_at_end_of_block";
  file["explorations"]["fast"]["maximum_repeats"] = 1;
  const ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].pointer, "/explorations/fast/on_failure");
}

TEST(FaultOfAProcedure, IsTheFormatWithoutProcedures) {
  json file = staircases();
  file["format"] = "asperity.protocol/1";
  const ProtocolReading reading =
      read_protocol_with_problems(file.dump(1), "file.json", test::example_models());
  ASSERT_EQ(reading.problems.size(), 1U);
  EXPECT_EQ(reading.problems[0].pointer, "/format");
  EXPECT_THAT(reading.problems[0].message, HasSubstr("\"procedure\""));
}

}  // namespace
}  // namespace asperity
