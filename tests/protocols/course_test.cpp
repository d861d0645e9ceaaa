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

#include "analysis/psychometric/psychometric_function.h"
#include "protocols/plan/block_design.h"
#include "protocols/warnings/plan_warnings.h"
#include "protocols/warnings/warnings.h"
#include "tests/protocols/protocol_files.h"
#include "tests/protocols/untranslated.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two tracks of a 2-down/1-up staircase for each of two explorations, and a fixed block after them.
json staircases() {
  return json::parse(R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "staircases",
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

double gain_of(const Trial& trial) { return std::get<double>(trial.factors.at("texture_gain")); }

/// The comparison is chosen in two of three trials of a track, first at its second step.
TrialOutcome outcome_by_step(const Trial& trial) {
  return {.answer = TrialOutcome::Answer{.value = gain_of(trial),
                                         .outcome = forced_outcome(trial.track->step % 3 != 1)}};
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
  const Protocol protocol = test::valid(file);
  Course course(protocol, {.seed = 3});
  EXPECT_EQ(course.awaited(), nullptr);
  EXPECT_EQ(course.plan().trials.size(), 2U);
  EXPECT_EQ(course.trials_before_last_outcome(), 2U);
  EXPECT_THROW(course.advance({}), std::logic_error);
}

TEST(Course, EndsWithTheTrialWhoseOutcomeDeterminesTheNext) {
  const Protocol protocol = test::valid(staircases());
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
  const Protocol protocol = test::valid(staircases());
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
      answers.push_back(
          {.level = std::get<NextLevel>(next).level, .outcome = forced_outcome(step % 3 != 0)});
    }
    EXPECT_TRUE(std::holds_alternative<TrackEnd>(next_step(own, answers, Random(0))));
  }
}

// Psi weighs all levels for one: to determine a level twice would double the time of a simulated session.
TEST(Course, DeterminesEveryLevelOnceByTheRulesThatSessionsShare) {
  const Protocol protocol = test::valid(staircases());
  std::size_t determined = 0;
  RulesByBlock rules = rules_of(protocol);
  for (LevelRule& rule : rules.at("tracks")) {
    rule = [&determined, own = rule](std::span<const LevelAnswer> answers, const Random& of_track) {
      ++determined;
      return own(answers, of_track);
    };
  }
  Course course(protocol, {.seed = 11}, &rules);
  while (const Trial* const trial = course.awaited()) course.advance(outcome_by_step(*trial));
  EXPECT_EQ(determined, 28U) << "24 levels, and the ends of four tracks";
  const Course with_own_rules = answered_course(protocol, 11);
  ASSERT_EQ(course.plan().trials.size(), with_own_rules.plan().trials.size());
  for (std::size_t trial = 0; trial < course.plan().trials.size(); ++trial) {
    EXPECT_EQ(course.plan().trials[trial].factors, with_own_rules.plan().trials[trial].factors);
  }
}

TEST(Course, InterleavesTracksInRoundsInAnOrderOfTheSeed) {
  const Protocol protocol = test::valid(staircases());
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
  const Protocol protocol = test::valid(file);
  std::vector<int> tracks{};
  const Course course = answered_course(protocol, 1);
  for (const Trial& trial : course.plan().trials) {
    if (trial.track) tracks.push_back(trial.track->track);
  }
  EXPECT_TRUE(std::is_sorted(tracks.begin(), tracks.end()));
}

TEST(Course, BalancesPositionsAndDrawnLevelsInEveryTrack) {
  const Protocol protocol = test::valid(staircases());
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
  const Protocol protocol = test::valid(file);
  Course course(protocol, {.seed = 1});
  course.advance(
      {.answer = TrialOutcome::Answer{.value = 1.6, .outcome = LevelOutcome::incorrect}});
  EXPECT_DOUBLE_EQ(gain_of(*course.awaited()), 1.8);
  course.advance({});
  EXPECT_DOUBLE_EQ(gain_of(*course.awaited()), 1.8);
  EXPECT_EQ(course.awaited()->track, (TrackStep{.track = 1, .step = 3}));
  for (int i = 0; i < 5; ++i) course.advance(outcome_by_step(*course.awaited()));
  EXPECT_EQ(course.awaited(), nullptr) << "six answers, one trial without";
}

// A participant who has stopped responding does not get the same level for ever.
TEST(Course, EndsWithoutAnswersAtTwiceTheTrialsOfItsTracks) {
  const Protocol protocol = test::valid(staircases());
  Course course(protocol, {.seed = 1});
  std::size_t trials = 0;
  for (; course.awaited() != nullptr && trials < 1000; ++trials) course.advance({});
  EXPECT_EQ(trials, 4U * 2U * 6U);
}

TEST(Course, KnowsTheTrialsThatCanFollow) {
  const Protocol protocol = test::valid(staircases());
  Course course(protocol, {.seed = 4});
  std::size_t most = 0;
  for (int i = 0; course.awaited() != nullptr; ++i) {
    const std::vector<Trial> possible = course.possible_next();
    const double value = gain_of(*course.awaited());
    most = std::max(most, possible.size());
    Course after_correct = course;
    after_correct.advance({.answer = TrialOutcome::Answer{value, LevelOutcome::correct}});
    const std::size_t before = course.plan().trials.size();
    EXPECT_EQ(json_of(possible.at(0)), json_of(after_correct.plan().trials.at(before)));
    if (i % 4 == 3) {
      course.advance({});
    } else {
      course.advance({.answer = TrialOutcome::Answer{value, forced_outcome(i % 4 != 0)}});
    }
    const auto is_next = [&](const Trial& each) {
      return json_of(each) == json_of(course.plan().trials.at(before));
    };
    EXPECT_EQ(std::count_if(possible.begin(), possible.end(), is_next), 1) << "after trial " << i;
  }
  EXPECT_EQ(most, 3U);
  EXPECT_TRUE(course.possible_next().empty());
}

TEST(Course, KnowsTheTrialsThatCanFollowCannotTell) {
  json file = staircases();
  json& block = file["blocks"]["tracks"];
  block["question"]["allow_cannot_tell"] = true;
  block["procedure"] = {
      {"method", "weighted_up_down"}, {"start", 50}, {"steps", {10}}, {"stop", {{"trials", 6}}}};
  const Protocol protocol = test::valid(file);
  Course course(protocol, {.seed = 3});
  const int track = course.awaited()->track->track;
  std::size_t most = 0;
  while (const Trial* const trial = course.awaited()) {
    const std::vector<Trial> possible = course.possible_next();
    most = std::max(most, possible.size());
    const std::size_t before = course.plan().trials.size();
    const bool is_first = trial->track->track == track && trial->track->step == 1;
    const double gain = gain_of(*trial);
    course.advance({.answer = TrialOutcome::Answer{gain, LevelOutcome::unsure}});
    const auto is_next = [&](const Trial& each) {
      return json_of(each) == json_of(course.plan().trials.at(before));
    };
    EXPECT_EQ(std::count_if(possible.begin(), possible.end(), is_next), 1);
    if (!is_first) continue;
    while (course.awaited()->track->track != track) course.advance({});
    EXPECT_NEAR(gain_of(*course.awaited()), 1.6, 1e-9) << "50 % and one step down upwards";
  }
  EXPECT_LE(most, 4U);
}

TEST(Course, MovesFromTheDeliveredLevel) {
  const Protocol protocol = test::valid(staircases());
  Course course(protocol, {.seed = 1});
  const int track = course.awaited()->track->track;
  course.advance(
      {.answer = TrialOutcome::Answer{.value = 1.3, .outcome = LevelOutcome::incorrect}});
  while (course.awaited()->track->track != track)
    course.advance(outcome_by_step(*course.awaited()));
  EXPECT_NEAR(gain_of(*course.awaited()), 1.5, 1e-9) << "30 % and a step of 20 %";
}

json with_catch_trials(int every) {
  json file = staircases();
  file["blocks"]["tracks"]["procedure"]["catch_trials"] = {{"level", 200}, {"every", every}};
  return file;
}

/// Catch trials are answered in either way.
Course answered_with_catch_trials(const Protocol& protocol, std::uint64_t seed, bool well = true) {
  Course course(protocol, {.seed = seed});
  while (const Trial* const trial = course.awaited()) {
    course.advance(trial->catch_trial ? TrialOutcome{TrialOutcome::Answer{
                                            .value = 3.0, .outcome = forced_outcome(well)}}
                                      : outcome_by_step(*trial));
  }
  return course;
}

TEST(Course, HasOneCatchTrialAtARandomPlaceOfEachStretch) {
  const Protocol protocol = test::valid(with_catch_trials(4));
  std::set<std::size_t> places{};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Course course = answered_with_catch_trials(protocol, seed);
    std::map<std::size_t, int> of_stretch{};
    std::size_t trials = 0;
    for (const Trial& trial : course.plan().trials) {
      if (trial.block != "tracks") continue;
      if (trial.catch_trial) {
        ++of_stretch[trials / 4];
        places.insert(trials % 4);
        EXPECT_EQ(trial.repetition, 0);
        EXPECT_FALSE(trial.track);
        EXPECT_TRUE(trial.is_of_procedure());
        EXPECT_TRUE(trial.catch_trial->is_above_standard);
        EXPECT_DOUBLE_EQ(gain_of(trial), 3.0);
        EXPECT_THAT(json_of(trial), HasSubstr(R"("catch":"easy")"));
        EXPECT_THAT(trial.questions.front().correct, ElementsAre("comparison"));
      }
      ++trials;
    }
    EXPECT_GE(of_stretch.size(), trials / 4);
    for (const auto& [stretch, count] : of_stretch) EXPECT_EQ(count, 1) << stretch;
  }
  EXPECT_GT(places.size(), 1U);
}

TEST(Course, PresentsTheSameLevelsToItsTracksWithAndWithoutCatchTrials) {
  const auto levels_of = [](const Course& course) {
    std::map<std::pair<int, int>, double> levels{};
    for (const Trial& trial : course.plan().trials) {
      if (trial.track) levels[{trial.track->track, trial.track->step}] = gain_of(trial);
    }
    return levels;
  };
  const Protocol plain = test::valid(staircases());
  const Protocol caught = test::valid(with_catch_trials(5));
  const auto expected = levels_of(answered_course(plain, 9));
  EXPECT_EQ(expected.size(), 24U);
  EXPECT_EQ(levels_of(answered_with_catch_trials(caught, 9, true)), expected);
  EXPECT_EQ(levels_of(answered_with_catch_trials(caught, 9, false)), expected);
}

TEST(Course, GivesCatchTrialsEveryConditionInTurn) {
  const Protocol protocol = test::valid(with_catch_trials(2));
  std::vector<std::string> conditions{};
  const Course course = answered_with_catch_trials(protocol, 4);
  for (const Trial& trial : course.plan().trials) {
    if (trial.catch_trial) conditions.push_back(text_of(trial.factors.at("stroking")));
  }
  ASSERT_GE(conditions.size(), 20U);
  for (std::size_t i = 0; i + 1 < conditions.size(); i += 2) {
    EXPECT_NE(conditions[i], conditions[i + 1]) << i;
  }
}

TEST(Course, CountsCatchTrialsInItsLimitsAndExamples) {
  const Protocol protocol = test::valid(with_catch_trials(4));
  EXPECT_EQ(most_trials_of(protocol, protocol.blocks.at("tracks")), 24U + 8U);
  const Plan plan = example_plan(protocol, {.seed = 1});
  EXPECT_GE(plan.trials.size(), 26U + 8U - 1U);
  std::set<double> gains{};
  for (const Trial& trial : possible_trials(protocol)) {
    if (trial.block == "tracks") gains.insert(gain_of(trial));
  }
  EXPECT_EQ(gains.size(), 11U);
  EXPECT_EQ(*gains.rbegin(), 3.0);
  EXPECT_THAT(design_of(protocol, protocol.blocks.at("tracks"), plan).english(),
              HasSubstr("6 trials × 2 interleaved tracks, one catch trial in every 4 trials"));
}

TEST(CatchTrials, AreRefusedWhereTheyAreNotEasy) {
  json file = with_catch_trials(4);
  json& level = file["blocks"]["tracks"]["procedure"]["catch_trials"]["level"];
  level = 50;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/blocks/tracks/procedure/catch_trials/level: a catch trial "
                                    "must be easy")));
  level = -200;
  EXPECT_THAT(
      test::problems_in(file),
      testing::Contains(HasSubstr("on the same side, but the level is -200; use 100 or more")));
  level = 100;
  EXPECT_TRUE(test::problems_in(file).empty());
  level = 1e12;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/blocks/tracks/procedure/catch_trials/level: the level "
                                    "1e+12 is a value of")));
  level = 200;
  file["blocks"]["tracks"]["procedure"]["catch_trials"]["every"] = 25;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/catch_trials/every: the tracks of this block have at most 24 "
                                    "trials")));
  file["blocks"]["tracks"]["procedure"]["catch_trials"]["every"] = 1;
  EXPECT_THAT(test::problems_in(file), ElementsAre(HasSubstr("catch_trials/every")));
}

TEST(CatchTrials, OfAComparisonNeedTheDirectionOfTheQuestion) {
  json file = with_catch_trials(4);
  json& block = file["blocks"]["tracks"];
  block["question"]["judgement"] = "comparison";
  block["vary"]["levels_percent"] = {{"lowest", -50}, {"highest", 50}, {"step", 10}};
  block["procedure"]["tracks"] = json::parse(R"([{"start": 30}, {"start": -30}])");
  EXPECT_THAT(test::problems_in(file), ElementsAre(HasSubstr("/catch_trials: with the judgement")));
  const auto correct_at = [&](double level, const char* direction) {
    block["procedure"]["catch_trials"]["level"] = level;
    block["question"]["asks_for"] = direction;
    const Protocol protocol = test::valid(file);
    const Course course = answered_with_catch_trials(protocol, 1);
    for (const Trial& trial : course.plan().trials) {
      if (trial.catch_trial) return trial.questions.front().correct;
      EXPECT_TRUE(trial.block != "tracks" || trial.questions.front().correct.empty());
    }
    return std::vector<std::string>{};
  };
  EXPECT_THAT(correct_at(80, "more"), ElementsAre("comparison"));
  EXPECT_THAT(correct_at(80, "less"), ElementsAre("standard"));
  EXPECT_THAT(correct_at(-80, "more"), ElementsAre("standard"));
  EXPECT_THAT(correct_at(-80, "less"), ElementsAre("comparison"));
}

TEST(CatchTrials, OfAComparisonAreAsFarAsTheFarthestLevel) {
  json file = with_catch_trials(4);
  json& block = file["blocks"]["tracks"];
  block["question"]["judgement"] = "comparison";
  block["question"]["asks_for"] = "more";
  block["vary"]["levels_percent"] = {{"lowest", -10}, {"highest", 60}, {"step", 10}};
  block["procedure"]["tracks"] = json::parse(R"([{"start": 30}])");
  block["procedure"]["catch_trials"]["level"] = -20;
  EXPECT_THAT(test::problems_in(file), ElementsAre(HasSubstr("must be easy")));
  block["procedure"]["catch_trials"]["level"] = -60;
  EXPECT_TRUE(test::problems_in(file).empty());
}

/// Catch trials with two standards, in weighted tracks with the option "cannot tell".
json with_pairs_of_standards(const char* type) {
  json file = staircases();
  json& block = file["blocks"]["tracks"];
  block["question"]["allow_cannot_tell"] = true;
  block["procedure"] = {{"method", "weighted_up_down"},
                        {"start", 50},
                        {"steps", {10}},
                        {"stop", {{"trials", 6}}},
                        {"catch_trials", {{"type", type}, {"every", 4}}}};
  return file;
}

TEST(CatchTrials, WithoutASignalPresentTheStandardTwice) {
  const Protocol protocol = test::valid(with_pairs_of_standards("no_signal"));
  const Course course = answered_with_catch_trials(protocol, 6);
  std::size_t caught = 0;
  for (const Trial& trial : course.plan().trials) {
    if (!trial.catch_trial) {
      EXPECT_EQ(json_of(trial).find("\"catch\""), std::string::npos);
      continue;
    }
    ++caught;
    EXPECT_EQ(trial.catch_trial->type, CatchType::no_signal);
    EXPECT_NE(json_of(trial).find(R"("catch":"no_signal")"), std::string::npos);
    EXPECT_EQ(gain_of(trial), 1.0) << "of the standard";
    std::set<std::string> items{};
    ASSERT_EQ(trial.presentations.size(), 2U);
    for (const PlannedPresentation& planned : trial.presentations) {
      EXPECT_EQ(planned.role, "standard");
      EXPECT_EQ(std::get<double>(planned.stimulus.parameters.at("texture_gain")), 1.0);
      items.insert(planned.item);
    }
    EXPECT_EQ(items, (std::set<std::string>{"standard", "standard_2"}));
    EXPECT_THAT(trial.questions.front().correct, ElementsAre("cannot_tell"));
  }
  EXPECT_EQ(caught, 4U) << "of 12 trials in tracks";
}

TEST(CatchTrials, OfTheTypeEasyAreThoseWithoutAType) {
  const json without = with_catch_trials(4);
  json with = without;
  with["blocks"]["tracks"]["procedure"]["catch_trials"]["type"] = "easy";
  const auto plan_with = [](const json& file) {
    const Protocol protocol = test::valid(file);
    std::vector<std::string> plan{};
    const Course course = answered_with_catch_trials(protocol, 2);
    for (const Trial& trial : course.plan().trials) plan.push_back(json_of(trial));
    return plan;
  };
  EXPECT_EQ(plan_with(with), plan_with(without));
  with["blocks"]["tracks"]["procedure"]["catch_trials"].erase("level");
  EXPECT_THAT(test::problems_in(with), ElementsAre(HasSubstr("add \"level\"")));
}

TEST(CatchTrials, WithTwoStandardsAreRefusedWhereNoResponseIsCorrect) {
  json file = with_pairs_of_standards("no_signal");
  file["blocks"]["tracks"]["question"].erase("allow_cannot_tell");
  EXPECT_THAT(
      test::problems_in(file),
      ElementsAre(HasSubstr("/catch_trials/type: of two standards neither is the correct")));
  EXPECT_THAT(test::problems_in(with_pairs_of_standards("identical_pair")),
              ElementsAre(HasSubstr("set it to \"no_signal\"")));
  file = with_pairs_of_standards("no_signal");
  file["blocks"]["tracks"]["procedure"]["catch_trials"]["level"] = 200;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("applies only where \"type\" is \"easy\" or absent")));
}

TEST(CatchTrials, OfAComparisonWithConstantStimuliCanBeIdenticalPairs) {
  json file = with_pairs_of_standards("identical_pair");
  json& block = file["blocks"]["tracks"];
  block["question"]["judgement"] = "comparison";
  block["vary"]["levels_percent"] = {-40, -20, 0, 20, 40};
  block["procedure"] = {{"method", "constant_stimuli"},
                        {"repetitions", 3},
                        {"catch_trials", {{"type", "identical_pair"}, {"every", 4}}}};
  const Protocol protocol = test::valid(file);
  std::size_t caught = 0;
  Course course(protocol, {.seed = 1});
  while (const Trial* const trial = course.awaited()) {
    if (trial->catch_trial) {
      ++caught;
      EXPECT_THAT(trial->questions.front().correct, ElementsAre("cannot_tell"));
    }
    const double gain = gain_of(*trial);
    course.advance({.answer = TrialOutcome::Answer{gain, LevelOutcome::unsure}});
  }
  EXPECT_GE(caught, 8U);
  block["procedure"]["catch_trials"]["type"] = "no_signal";
  EXPECT_THAT(test::problems_in(file), ElementsAre(HasSubstr("set it to \"identical_pair\"")));
}

TEST(CatchTrials, AreNeededToExcludeParticipantsByTheirErrors) {
  json file = with_catch_trials(4);
  file["analysis"]["exclude"] = {{"more_catch_errors_than", 2}};
  const Protocol protocol = test::valid(file);
  ASSERT_TRUE(protocol.analysis.exclude);
  EXPECT_EQ(protocol.analysis.exclude->more_errors_than, 2);
  file["blocks"]["tracks"]["procedure"].erase("catch_trials");
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/analysis/exclude: no main block has catch trials")));
  file = with_catch_trials(4);
  file["analysis"]["exclude"] = {{"more_catch_errors_than", 2}, {"catch_error_rate_above", 0.2}};
  EXPECT_FALSE(test::problems_in(file).empty());
}

TEST(ExpectedTrials, AreExactWhereTracksEndByTheirNumberOfTrials) {
  json file = staircases();
  const Protocol fixed = test::valid(file);
  EXPECT_EQ(expected_trials(fixed), 26);
  EXPECT_FALSE(has_estimated_trials(fixed));
  EXPECT_EQ(expected_trials(test::valid(with_catch_trials(4))), 34);
  EXPECT_FALSE(has_estimated_trials(test::valid(with_catch_trials(4))));
  EXPECT_TRUE(has_estimated_trials(test::valid(with_catch_trials(6))))
      << "24 trials of tracks, in groups of 5 with a catch trial";
  file["blocks"]["tracks"]["procedure"]["stop"]["trials"] = 60;
  file["blocks"]["tracks"]["procedure"]["stop"]["reversals"] = 4;
  const Protocol estimated = test::valid(file);
  EXPECT_TRUE(has_estimated_trials(estimated));
  double mean = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    mean += static_cast<double>(example_plan(estimated, {.seed = seed}).trials.size()) / 40.0;
  }
  // The mean of 40 sessions of 4 tracks, whose standard deviation is about 4 trials each.
  EXPECT_NEAR(expected_trials(estimated), mean, 4.0);
}

/// The warning of levels that are practised with feedback.
std::vector<std::string> training_warnings_of(const json& file) {
  std::vector<std::string> warnings{};
  for (const Diagnostic& warning : warnings_about(test::valid(file), "file.json")) {
    warnings.push_back(warning.pointer + ": " + warning.message.english());
    EXPECT_EQ(test::untranslated(warning.message), "");
  }
  return warnings;
}

TEST(TrainedLevels, AreWarnedOfWhereAMainBlockMeasuresThem) {
  json file = staircases();
  json& practice = file["blocks"]["after"];
  practice["feedback"] = "correctness";
  EXPECT_THAT(training_warnings_of(file),
              ElementsAre(HasSubstr("/blocks/after/vary: participants practise with feedback at "
                                    "the level 2, which the block \"tracks\" measures; practise at "
                                    "levels between or beyond those that are measured")));
  practice["vary"]["levels_ratio"] = {2.05, 3};
  EXPECT_TRUE(training_warnings_of(file).empty());
  practice["vary"].erase("levels_ratio");
  practice["vary"]["levels"] = {1.3, 2.05};
  EXPECT_THAT(training_warnings_of(file), ElementsAre(HasSubstr("the level 1.3,")));
  practice["feedback"] = "none";
  EXPECT_TRUE(training_warnings_of(file).empty());
}

TEST(StaircaseTargets, AreWarnedOfWhereTheyAreNotThePointOfEquality) {
  json file = staircases();
  json& block = file["blocks"]["tracks"];
  block["question"] = {{"name", "rougher"}, {"prompt", "Rougher?"}, {"judgement", "comparison"}};
  block["vary"]["levels_percent"] = {{"lowest", -90}, {"highest", 90}, {"step", 10}};
  EXPECT_THAT(training_warnings_of(file),
              ElementsAre(HasSubstr("/blocks/tracks/procedure/method: the levels converge on 70.7 "
                                    "%, but the point of subjective equality lies at 50 %")));
  block["procedure"]["down"] = 1;
  EXPECT_TRUE(training_warnings_of(file).empty());
}

TEST(Groups, AreWarnedOfWhereTheyAloneReadNoScreen) {
  json file = staircases();
  file["flow"] = {{{"run", "tracks"}}, {{"run", "after"}}};
  file["factors"]["training"] = {{"levels", {"haptic", "visual"}}};
  file["groups"] = {{"factor", "training"}};
  EXPECT_TRUE(training_warnings_of(file).empty()) << "no group reads a screen";
  file["flow"].push_back(json{{"screen", "Stroke."}, {"groups", {"haptic"}}});
  EXPECT_THAT(training_warnings_of(file),
              ElementsAre(HasSubstr("/flow: participants of the group \"visual\" read no screen")));
  file["flow"].push_back(json{{"screen", "Look."}, {"groups", {"visual"}}});
  EXPECT_TRUE(training_warnings_of(file).empty());
}

std::vector<std::string> plan_warnings_of(const json& file) {
  const Protocol protocol = test::valid(file);
  std::vector<std::string> warnings{};
  for (const Diagnostic& warning :
       warnings_about_plan(protocol, "file.json", example_plan(protocol, {1, 0}))) {
    warnings.push_back(warning.pointer + ": " + warning.message.english());
    EXPECT_EQ(test::untranslated(warning.message), "");
  }
  return warnings;
}

TEST(PlanWarnings, AreAboutBreaksThatNeverCome) {
  json file = staircases();
  EXPECT_TRUE(plan_warnings_of(file).empty());
  file["flow"][1]["break_every_trials"] = 24;
  EXPECT_THAT(plan_warnings_of(file),
              ElementsAre(HasSubstr("/flow/1/break_every_trials: a run of the block \"tracks\" has "
                                    "24 trials, so that there is no break after 24")));
  file["flow"][1]["break_every_trials"] = 23;
  EXPECT_TRUE(plan_warnings_of(file).empty());
  file["flow"][1]["break_every_contact_minutes"] = 60;
  EXPECT_THAT(plan_warnings_of(file),
              ElementsAre(HasSubstr("/flow/1/break_every_contact_minutes: a run of the block "
                                    "\"tracks\" takes about ")));
}

TEST(PlanWarnings, AreAboutMorePracticeAtAResumeThanThereIs) {
  json file = staircases();
  file["resume"] = {{"practice_trials", 2}};
  EXPECT_TRUE(plan_warnings_of(file).empty());
  file["resume"] = {{"practice_trials", 3}};
  EXPECT_THAT(
      plan_warnings_of(file),
      ElementsAre(HasSubstr("/resume/practice_trials: a practice block has at most 2 trials")));
}

TEST(Resume, CanOnlyRepeatPracticeThatThereIs) {
  json file = staircases();
  file["resume"] = {{"practice_trials", 2}};
  EXPECT_TRUE(test::problems_in(file).empty());
  file["blocks"]["after"]["phase"] = "familiarisation";
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/resume/practice_trials: no block has the phase")));
}

TEST(BreaksAfterContact, NeedAPause) {
  json file = staircases();
  file["flow"][2]["break_every_contact_minutes"] = 5;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("/flow/2: \"break_every_contact_minutes\" needs a \"pause\"")));
  file["flow"][2]["pause"] = {{"minimum_s", 30}};
  EXPECT_TRUE(test::problems_in(file).empty());
  file["flow"][2].erase("break_every_contact_minutes");
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(HasSubstr("the time of this pause is not stated")));
}

TEST(Course, NamesTheStepOfTheFlowThatRunsABlock) {
  const Protocol protocol = test::valid(staircases());
  const Course course(protocol, {.seed = 3});
  EXPECT_EQ(course.run_of(1).block, "tracks");
  EXPECT_EQ(course.run_of(2).block, "after");
  EXPECT_THROW(course.run_of(3), std::out_of_range);
}

TEST(CostOfAPlan, HasTheBreaksThatContactRequires) {
  json file = staircases();
  json& run = file["flow"][1];
  run.erase("break_every_trials");
  run["pause"]["minimum_s"] = 1000;
  file["explorations"]["slow"]["minimum_contact_s"] = 3;
  file["explorations"]["fast"]["minimum_contact_s"] = 3;
  const auto cost_with = [&](double minutes) {
    run["break_every_contact_minutes"] = minutes;
    const Protocol protocol = test::valid(file);
    return cost_of(protocol, answered_course(protocol, 1).plan());
  };
  // 24 trials of two surfaces, each felt for 3 s: 144 s, and 12 s of the block after them.
  const PlanCost none = cost_with(10);
  EXPECT_NEAR(none.contact_s, 156.0, 1e-9);
  const PlanCost one = cost_with(1.3);  // 78 s: before the 14th trial
  EXPECT_NEAR(one.total_s - none.total_s, 1000.0, 1e-9);
  EXPECT_LT(one.longest_without_break_s, none.longest_without_break_s);
  EXPECT_NEAR(cost_with(0.5).total_s - none.total_s, 4000.0, 1e-9);
}

TEST(Course, HasItsBreaksBetweenTrialsAndNoneAtTheEnd) {
  const Protocol protocol = test::valid(staircases());
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
  const Protocol protocol = test::valid(staircases());
  const Plan plan = answered_course(protocol, 1).plan();
  EXPECT_THAT(json_of(plan.trials.front()), HasSubstr(R"("repetition":1,"track":)"));
  EXPECT_THAT(json_of(plan.trials.back()), testing::Not(HasSubstr("track\":")));
}

TEST(Course, HasAnExampleOfItself) {
  const Protocol protocol = test::valid(staircases());
  const Plan plan = example_plan(protocol, {.seed = 1});
  EXPECT_EQ(plan.trials.size(), 26U);
  EXPECT_GT(cost_of(protocol, plan).total_s,
            cost_of(protocol, make_plan(protocol, {1, 0})).total_s);
}

TEST(Course, CanPresentEveryLevelOfItsGrid) {
  const Protocol protocol = test::valid(staircases());
  std::set<std::pair<std::string, double>> levels{};
  for (const Trial& trial : possible_trials(protocol)) {
    if (trial.block == "tracks")
      levels.insert({text_of(trial.factors.at("stroking")), gain_of(trial)});
  }
  EXPECT_EQ(levels.size(), 20U);
}

TEST(DesignOfABlock, IsStatedInASentence) {
  const Protocol protocol = test::valid(staircases());
  const Plan plan = example_plan(protocol, {.seed = 1});
  const Phrase stated = design_of(protocol, protocol.blocks.at("tracks"), plan);
  EXPECT_EQ(test::untranslated(stated), "");
  const std::string design = stated.english();
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
    return least_threshold_error(test::valid(file).blocks.at("tracks")).value();
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
  Protocol protocol = test::valid(staircases());
  Protocol::Block& block = protocol.blocks.at("tracks");
  block.questions.front().own = DiscriminationQuestion{DiscriminationJudgement::comparison};
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
  const std::vector<std::string> found = test::problems_in(file);
  EXPECT_THAT(found, testing::Contains(
                         HasSubstr(std::string("/blocks/tracks") + GetParam().pointer + ": ")))
      << GetParam().message;
  EXPECT_THAT(found, testing::Contains(HasSubstr(GetParam().message)));
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
        PlantedFault{R"({"procedure": {"target": 0.75}})", "/procedure/target",
                     "applies only where \"method\""},
        PlantedFault{R"({"vary": {"levels_percent": [10, 20]}})", "/vary/levels_percent",
                     "state the lowest level, the highest and the step"},
        PlantedFault{R"({"vary": {"levels_percent": {"lowest": 50, "highest": 40}}})",
                     "/vary/levels_percent/highest", "the grid is empty"},
        PlantedFault{R"({"vary": {"levels_percent": {"highest": 2000}}})",
                     "/vary/levels_percent/highest", "it must be a number from 0 to 10"},
        PlantedFault{R"({"vary": {"levels_percent": {"lowest": -90, "highest": -10}},
                         "procedure": {"tracks": [{"start": -50}]}})",
                     "/procedure/method", "below the standard lower levels are easier"},
        PlantedFault{R"({"all_pairs": {"factor": "nope"}})", "/all_pairs",
                     "or a similarity has this key"},
        PlantedFault{R"({"repetitions": 3})", "/repetitions",
                     "the procedure of a block determines its trials"},
        PlantedFault{R"({"procedure": {"stop": {"trials": 600}}})", "/procedure",
                     "too many for a participant"},
        PlantedFault{R"({"procedure": {"stop": {"interval": {"ratio": 2, "minimum_trials": 2,
                         "minimum_of_each": 1}}}})",
                     "/procedure/stop/interval", "applies only where \"method\" is \"psi\""},
        PlantedFault{R"({"procedure": {"prior": {}}})", "/procedure/prior",
                     "is \"psi\" or \"quest_plus\""}));

/// The staircases with psi instead; null members are left out.
json psi_blocks() {
  json file = staircases();
  file["blocks"]["tracks"]["procedure"] = {{"method", "psi"}, {"stop", {{"trials", 6}}}};
  return file;
}

class FaultOfPsi : public testing::TestWithParam<PlantedFault> {};

TEST_P(FaultOfPsi, IsReportedAtItsPlace) {
  json file = psi_blocks();
  file["blocks"]["tracks"].merge_patch(json::parse(GetParam().patch));
  EXPECT_THAT(test::problems_in(file),
              testing::Contains(testing::AllOf(
                  testing::StartsWith(std::string("/blocks/tracks") + GetParam().pointer + ": "),
                  HasSubstr(GetParam().message))));
}

INSTANTIATE_TEST_SUITE_P(
    Planted, FaultOfPsi,
    testing::Values(
        PlantedFault{R"({"procedure": {"stop": null}})", "/procedure", "has no limit"},
        PlantedFault{R"({"procedure": {"target": 0.4}})", "/procedure/target", "above 0.5"},
        PlantedFault{R"({"procedure": {"target": 0.95}})", "/procedure/target", "below 0.94"},
        PlantedFault{R"({"procedure": {"stop": {"reversals": 3}}})", "/procedure/stop/reversals",
                     "applies only where \"method\""},
        PlantedFault{R"({"procedure": {"tracks": [{"start": 50}]}})", "/procedure/tracks/0/start",
                     "applies only where \"method\""},
        PlantedFault{R"({"procedure": {"steps": [10]}})", "/procedure/steps",
                     "applies only where \"method\""},
        PlantedFault{R"({"procedure": {"method": "quest_plus", "marginalise": ["slope"]}})",
                     "/procedure/marginalise", "applies only where \"method\""},
        PlantedFault{R"({"procedure": {"stop": {"interval": {"ratio": 1.5, "minimum_trials": 9,
                         "minimum_of_each": 1}}}})",
                     "/procedure/stop/interval/minimum_trials", "allow more trials"},
        PlantedFault{R"({"procedure": {"stop": {"interval": {"ratio": 1.5, "minimum_trials": 2,
                         "minimum_of_each": 4}}}})",
                     "/procedure/stop/interval/minimum_of_each", "lower the number"},
        PlantedFault{R"({"procedure": {"prior": {"threshold": {"lowest": 20, "highest": 10,
                         "count": 5}}}})",
                     "/procedure/prior/threshold", "are not a range"},
        PlantedFault{R"({"procedure": {"prior": {"threshold": {"lowest": 10, "highest": 10,
                         "count": 1}}}})",
                     "/procedure/prior/threshold", "nothing to estimate"},
        PlantedFault{R"({"procedure": {"prior": {"lapse": {"lowest": 0, "highest": 0,
                         "count": 1}}}})",
                     "/procedure/prior/lapse", "above 0"},
        PlantedFault{R"({"procedure": {"prior": {"threshold": {"lowest": 1, "highest": 100,
                         "count": 900}, "slope": {"lowest": 1, "highest": 8, "count": 40}}}})",
                     "/procedure/prior/threshold", "combinations"},
        PlantedFault{R"({"vary": {"levels_percent": [10, 20]}})", "/vary/levels_percent",
                     "state the lowest level, the highest and the step"},
        PlantedFault{R"({"vary": {"levels_percent": null, "levels_decibels": {"lowest": 1,
                         "highest": 10, "step": 1}}})",
                     "/vary/levels_decibels", "proportional to the difference"},
        PlantedFault{R"({"question": {"judgement": "comparison"}})", "/procedure/method",
                     "no response is correct"}));

// The level of the standard is a ratio of 1: a difference of 10 % is a ratio of 1.1, and both have the same threshold.
TEST(Course, OfPsiIsTheSameForLevelsInPercentAndAsRatios) {
  const Protocol in_percent = test::valid(psi_blocks());
  json file = psi_blocks();
  file["blocks"]["tracks"]["vary"].erase("levels_percent");
  file["blocks"]["tracks"]["vary"]["levels_ratio"] = {
      {"lowest", 1.1}, {"highest", 2}, {"step", 0.1}};
  const Protocol as_ratios = test::valid(file);
  const auto gains = [](const Protocol& protocol) {
    std::vector<double> all{};
    const Course course = answered_course(protocol, 5);
    for (const Trial& trial : course.plan().trials) all.push_back(gain_of(trial));
    return all;
  };
  const std::vector<double> expected = gains(in_percent);
  ASSERT_EQ(expected.size(), 14U);  // 2 × 6, and 2 of the block after them
  EXPECT_THAT(gains(as_ratios), testing::Pointwise(testing::DoubleNear(1e-9), expected));
  EXPECT_NE(expected[0], expected[11]);
}

TEST(FaultOfAProcedure, WithoutAParameterToVary) {
  json file = staircases();
  file["blocks"]["tracks"].erase("vary");
  EXPECT_THAT(test::problems_in(file), testing::Contains(HasSubstr("requires the key \"vary\"")));
}

TEST(FaultOfAProcedure, HasNoRemedyForTrialsThatTheProcedureDetermines) {
  json file = staircases();
  file["blocks"]["tracks"]["until"] = {{"correct", 2}, {"of_last", 2}, {"maximum_trials", 50}};
  EXPECT_THAT(test::problems_in(file), ElementsAre(testing::StartsWith("/blocks/tracks/until: ")));
  json without = staircases();
  without["blocks"]["tracks"].erase("vary");
  EXPECT_EQ(test::problems_at(without, "/blocks/tracks/positions"), "");
}

TEST(FaultOfAProcedure, IsOneNameForTwoParameters) {
  json file = staircases();
  file["stimuli"]["scaled"]["parameters"]["tool_gain"] = 1;
  file["blocks"]["after"]["vary"]["factor"] = "level";
  file["blocks"]["tracks"]["vary"]["factor"] = "level";
  file["blocks"]["after"]["vary"]["parameter"] = "step";
  const std::vector<std::string> found = test::problems_in(file);
  EXPECT_THAT(found, testing::Contains(testing::AllOf(HasSubstr("/blocks/after/vary/factor: "),
                                                      HasSubstr("under the name \"level\""))));
}

TEST(FaultOfAProcedure, IsAnExplorationThatPutsTrialsOff) {
  json file = staircases();
  file["explorations"]["fast"]["on_failure"] = "requeue_at_end_of_block";
  file["explorations"]["fast"]["maximum_repeats"] = 1;
  EXPECT_THAT(test::problems_in(file),
              ElementsAre(testing::StartsWith("/explorations/fast/on_failure: ")));
}

}  // namespace
}  // namespace asperity
