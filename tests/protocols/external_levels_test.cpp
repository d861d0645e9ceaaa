// Levels that are supplied from outside: what a course requests, in which order, and what a protocol may state.

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/block_design.h"
#include "protocols/plan/course.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two tracks of four trials at most, and two trials of a fixed block after them.
nlohmann::json external_file() {
  return nlohmann::json::parse(R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "stated",
    "version": "1.0.0", "title": "Stated levels",
    "consent": {"version": "1.0", "statement": "I take part of my own free will."},
    "stimuli": {"scaled": {"model": "pd_gradient", "surface": "ball", "tool": "ball",
                           "parameters": {"texture_gain": 1}}},
    "bodies": {"ball": {"shape": "sphere", "diameter_m": 0.02, "axis": "z"}},
    "explorations": {"slow": {}},
    "blocks": {
      "tracks": {
        "exploration": "slow",
        "vary": {"parameter": "texture_gain", "of": "comparison", "relative_to": "standard",
                 "levels_percent": {"lowest": 10, "highest": 100, "step": 10}},
        "procedure": {"method": "external", "stop": {"trials": 4}, "tracks": [{}, {}],
                      "settings": {"start": 60}},
        "presented": [{"role": "standard", "stimulus": "scaled"}, {"role": "comparison", "stimulus": "scaled"}],
        "positions": "balanced",
        "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}},
      "after": {
        "phase": "practice", "exploration": "slow",
        "vary": {"parameter": "texture_gain", "of": "comparison", "relative_to": "standard", "levels_ratio": [2, 3]},
        "presented": [{"role": "standard", "stimulus": "scaled"}, {"role": "comparison", "stimulus": "scaled"}],
        "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
    "flow": [{"screen": "Welcome"}, {"run": "tracks"}, {"run": "after"}, {"screen": "Goodbye"}]})");
}

/// "POINTER: MESSAGE" of every problem of the file after a change of its procedure.
std::vector<std::string> problems_of_changed(const std::function<void(nlohmann::json&)>& change) {
  nlohmann::json file = external_file();
  change(file["blocks"]["tracks"]);
  return test::problems_in(file);
}

TrialOutcome answered_as(const Trial& trial, bool counts_down) {
  return {.answer =
              TrialOutcome::Answer{.value = std::get<double>(trial.factors.at("texture_gain")),
                                   .outcome = forced_outcome(counts_down)}};
}

TEST(ExternalLevels, AreRequestedBeforeEachTrialAndForNoOtherTrack) {
  const Protocol protocol = test::valid(external_file());
  Course course(protocol, {.seed = 5});
  EXPECT_TRUE(course.plan().trials.empty());
  EXPECT_EQ(course.awaited(), nullptr);
  EXPECT_FALSE(course.is_complete());
  EXPECT_THROW(course.advance({}), std::logic_error);
  std::vector<double> levels{};
  for (int trial = 0; trial < 8; ++trial) {
    ASSERT_TRUE(course.requested()) << trial;
    const LevelRequest request = *course.requested();
    EXPECT_EQ(request.block, "tracks");
    EXPECT_EQ(request.tracks, 2U);
    EXPECT_EQ(request.settings.settings_json, R"({"start":60})");
    EXPECT_EQ(request.answers.size(), static_cast<std::size_t>(trial));
    EXPECT_EQ(request.of.step, trial / 2 + 1) << "each round has a trial of each track";
    course.supply(NextLevel{10.0 * (trial + 1)});
    ASSERT_FALSE(course.requested());
    ASSERT_NE(course.awaited(), nullptr);
    EXPECT_EQ(course.awaited()->track, request.of);
    levels.push_back(std::get<double>(course.awaited()->factors.at("texture_gain")));
    // After an answer the level is unknown; without one the trial comes again with the same level.
    for (const Trial& next : course.possible_next()) {
      EXPECT_TRUE(next.block == "after" || next.factors == course.awaited()->factors);
    }
    course.advance(answered_as(*course.awaited(), trial % 3 == 0));
  }
  EXPECT_THAT(levels, ElementsAre(1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8));
  EXPECT_TRUE(course.is_complete());
  EXPECT_EQ(course.plan().trials.size(), 10U);
  EXPECT_THROW(course.supply(NextLevel{10.0}), std::logic_error);
}

TEST(ExternalLevels, AreThoseOfTheBlockOnly) {
  const Protocol protocol = test::valid(external_file());
  Course course(protocol, {.seed = 5});
  EXPECT_THROW(course.supply(NextLevel{15.0}), std::invalid_argument);
  EXPECT_TRUE(course.requested()) << "nothing was supplied";
  course.supply(NextLevel{20.0});
  EXPECT_NE(course.awaited(), nullptr);
}

TEST(ExternalLevels, StayUntilTheTrialHasAnAnswerThatCounts) {
  const Protocol protocol = test::valid(external_file());
  Course course(protocol, {.seed = 5});
  const int first = course.requested()->of.track;
  course.supply(NextLevel{70.0});
  course.advance({});
  // The other track has its turn first.
  course.supply(NextLevel{20.0});
  course.advance(answered_as(*course.awaited(), true));
  while (course.requested() && course.requested()->of.track != first) {
    course.supply(NextLevel{30.0});
    course.advance(answered_as(*course.awaited(), true));
  }
  ASSERT_NE(course.awaited(), nullptr) << "without a request";
  EXPECT_EQ(course.awaited()->track->track, first);
  EXPECT_EQ(course.awaited()->track->step, 2);
  EXPECT_EQ(std::get<double>(course.awaited()->factors.at("texture_gain")), 1.7);
}

TEST(ExternalLevels, EndTracksOneByOne) {
  const Protocol protocol = test::valid(external_file());
  Course course(protocol, {.seed = 5});
  course.supply(TrackEnd::program);
  ASSERT_TRUE(course.requested());
  const int left = course.requested()->of.track;
  course.supply(NextLevel{50.0});
  course.advance(answered_as(*course.awaited(), true));
  ASSERT_TRUE(course.requested());
  EXPECT_EQ(course.requested()->of.track, left);
  course.supply(TrackEnd::program);
  EXPECT_TRUE(course.is_complete());
  EXPECT_EQ(course.plan().trials.size(), 3U);
}

TEST(ExternalLevels, OfAnExampleAreExamples) {
  const Protocol protocol = test::valid(external_file());
  EXPECT_EQ(example_plan(protocol, {.seed = 5}).trials.size(), 10U);
  EXPECT_EQ(make_plan(protocol, {.seed = 5}).trials.size(), 0U);
  EXPECT_EQ(expected_trials(protocol), 10);
  EXPECT_TRUE(has_estimated_trials(protocol)) << "the program may end a track";
  EXPECT_THAT(
      design_of(protocol, protocol.blocks.at("tracks"), example_plan(protocol, {})).english(),
      HasSubstr("levels of an external program (unknown before the session), at most 4 "
                "trials × 2 interleaved tracks"));
  EXPECT_FALSE(least_threshold_error(protocol.blocks.at("tracks")));
}

TEST(ExternalLevels, ArePresentedAtTheNearestLevel) {
  const External method{.levels = {1.0, 2.0, 4.0}, .trials = 1};
  EXPECT_EQ(presented_level(method, 1.4), 1.0);
  EXPECT_EQ(presented_level(method, 3.0), 2.0) << "the lower of two";
  EXPECT_EQ(presented_level(method, 3.1), 4.0);
  EXPECT_EQ(presented_level(method, 4.0 + 1e-10), 4.0);
  EXPECT_FALSE(presented_level(method, 4.01));
  EXPECT_FALSE(presented_level(method, 0.99));
  EXPECT_FALSE(presented_level(method, std::numeric_limits<double>::quiet_NaN()));
}

TEST(ExternalLevels, NeedAMaximumNumberOfTrialsAndNothingThatTheProgramDecides) {
  EXPECT_THAT(problems_of_changed([](nlohmann::json&) {}), testing::IsEmpty());
  EXPECT_THAT(problems_of_changed([](nlohmann::json& block) { block["procedure"].erase("stop"); }),
              ElementsAre(HasSubstr("/blocks/tracks/procedure: a program must not be able to "
                                    "continue a track without end")));
  EXPECT_THAT(problems_of_changed([](nlohmann::json& block) { block["procedure"]["start"] = 50; }),
              ElementsAre(HasSubstr("/blocks/tracks/procedure/start: this key applies only where "
                                    "\"method\"")));
  EXPECT_THAT(
      problems_of_changed(
          [](nlohmann::json& block) { block["procedure"]["stop"]["reversals"] = 8; }),
      ElementsAre(HasSubstr("/blocks/tracks/procedure/stop/reversals: this key applies only "
                            "where \"method\"")));
  EXPECT_THAT(
      problems_of_changed([](nlohmann::json& block) { block["procedure"]["answer_within_s"] = 0; }),
      ElementsAre(HasSubstr("/blocks/tracks/procedure/answer_within_s")));
  EXPECT_THAT(problems_of_changed(
                  [](nlohmann::json& block) { block["procedure"]["program"] = "./levels.py"; }),
              ElementsAre(HasSubstr("/blocks/tracks/procedure/program")))
      << "no file can name the program";
  EXPECT_THAT(
      problems_of_changed([](nlohmann::json& block) { block["procedure"]["method"] = "psi"; }),
      testing::Contains(HasSubstr("applies only where \"method\" is \"external\"")));
}

TEST(ExternalLevels, CanBeAList) {
  EXPECT_THAT(problems_of_changed([](nlohmann::json& block) {
                block["vary"]["levels_percent"] = {10, 20, 50};
              }),
              testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
