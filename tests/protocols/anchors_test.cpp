// Anchors: where they are in a plan, that they change nothing else in it, and what a file cannot ask.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/course.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using AnchorJson = nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const AnchorJson kAllPlaces = {"start", "middle", "end"};

/// A selection of three models with 2 textures × 3 repetitions, with anchors of one texture.
AnchorJson selection_with_anchors(const AnchorJson& places) {
  AnchorJson file = AnchorJson::parse(test::example_selection());
  file["blocks"]["main"]["anchor"] = {{"texture", "metal"}};
  file["blocks"]["main"]["anchor_at"] = places;
  return file;
}

/// "2 middle": the number and place of every anchor.
std::vector<std::string> anchors_in(const Plan& plan) {
  std::vector<std::string> found{};
  for (const Trial& trial : plan.trials) {
    EXPECT_EQ(trial.repetition == 0, trial.anchor || trial.catch_trial) << trial.ordinal;
    if (trial.anchor) found.push_back(std::to_string(trial.ordinal) + ' ' + text_of(*trial.anchor));
  }
  return found;
}

/// The JSON of a trial without its number and its place.
AnchorJson without_place(const Trial& trial) {
  AnchorJson planned = AnchorJson::parse(json_of(trial));
  planned.erase("ordinal");
  planned.erase("anchor");
  return planned;
}

/// Those that are not anchors.
std::vector<AnchorJson> others_in(const Plan& plan) {
  std::vector<AnchorJson> others{};
  for (const Trial& trial : plan.trials) {
    if (!trial.anchor) others.push_back(without_place(trial));
  }
  return others;
}

TEST(Anchors, AreAtTheStartInTheMiddleAndAtTheEndOfTheirBlock) {
  const auto plan_with = [](const AnchorJson& places) {
    return make_plan(test::valid(selection_with_anchors(places)), {7, 0});
  };
  EXPECT_THAT(anchors_in(plan_with(kAllPlaces)), ElementsAre("1 start", "5 middle", "9 end"));
  EXPECT_THAT(anchors_in(plan_with({"end", "middle"})), ElementsAre("4 middle", "8 end"));
  AnchorJson unplaced = selection_with_anchors(kAllPlaces);
  unplaced["blocks"]["main"].erase("anchor_at");
  EXPECT_THAT(anchors_in(make_plan(test::valid(unplaced), {7, 0})), ElementsAre("1 start"));
  EXPECT_EQ(expected_trials(test::valid(selection_with_anchors(kAllPlaces))), 9);
}

// Of an odd number of trials the smaller half precedes the middle.
TEST(Anchors, AreInTheMiddleAfterHalfOfTheTrials) {
  AnchorJson file = selection_with_anchors(AnchorJson::array({"middle"}));
  file["blocks"]["main"]["listed"] = AnchorJson::parse(R"([{"texture": "stone"}])");
  file["blocks"]["main"].erase("crossed");
  file["blocks"]["main"].erase("maximum_in_a_row");
  EXPECT_THAT(anchors_in(make_plan(test::valid(file), {7, 0})), ElementsAre("2 middle"))
      << "of 3 trials";
}

TEST(Anchors, ChangeNoOtherTrialOfThePlan) {
  AnchorJson without = AnchorJson::parse(test::example_selection());
  const Plan plan = make_plan(test::valid(selection_with_anchors(kAllPlaces)), {7, 0});
  EXPECT_EQ(others_in(plan), others_in(make_plan(test::valid(without), {7, 0})));
}

TEST(Anchors, AreIdenticalWithinARunWithTheSurfacesAsListed) {
  AnchorJson file = selection_with_anchors(kAllPlaces);
  file["blocks"]["main"]["rove"] = {{"friction", {0.1, 0.2, 0.3, 0.4}}};
  const Plan plan = make_plan(test::valid(file), {3, 0});
  std::vector<AnchorJson> anchors{};
  for (const Trial& trial : plan.trials) {
    if (!trial.anchor) continue;
    anchors.push_back(without_place(trial));
    EXPECT_EQ(text_of(trial.factors.at("texture")), "metal");
    std::vector<std::string> items{};
    for (const PlannedPresentation& planned : trial.presentations) {
      items.push_back(planned.item);
      EXPECT_EQ(planned.role, "alternative");
    }
    EXPECT_THAT(items, ElementsAre("height_map", "sinusoid", "stochastic"));
  }
  ASSERT_EQ(anchors.size(), 3U);
  EXPECT_EQ(anchors[0], anchors[1]);
  EXPECT_EQ(anchors[0], anchors[2]);
}

// Plans with an anchor at the start are stored in running studies.
TEST(Anchors, StateTheirPlaceInThePlanUnlessItIsTheStart) {
  for (const Trial& trial :
       make_plan(test::valid(selection_with_anchors(kAllPlaces)), {7, 0}).trials) {
    const AnchorJson planned = AnchorJson::parse(json_of(trial));
    const bool has_place = trial.anchor && *trial.anchor != AnchorPlace::start;
    EXPECT_EQ(planned.contains("anchor"), has_place) << trial.ordinal;
    if (has_place) {
      EXPECT_EQ(planned.at("anchor"), text_of(*trial.anchor));
    }
  }
}

/// Two tracks of 6 trials each for two explorations: 24 trials.
AnchorJson tracks_with_anchors() {
  return AnchorJson::parse(R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "tracks",
    "version": "1.0.0", "title": "Tracks",
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
        "anchor": {"stroking": "slow", "shade": "b", "texture_gain": 55},
        "anchor_at": ["start", "middle", "end"],
        "procedure": {"method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10],
                      "stop": {"trials": 6}, "tracks": [{"start": 60}, {"start": 20}]},
        "presented": [{"role": "standard", "stimulus": "scaled"}, {"role": "comparison", "stimulus": "scaled"}],
        "positions": "balanced",
        "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
    "flow": [{"run": "tracks"}]})");
}

/// Every response leads to a lower level.
Course answered_correctly(const Protocol& protocol) {
  Course course(protocol, {.seed = 4});
  while (const Trial* const trial = course.awaited()) {
    EXPECT_TRUE(trial->track) << "no outcome of an anchor is awaited";
    const double value = std::get<double>(trial->factors.at("texture_gain"));
    course.advance({.answer = TrialOutcome::Answer{value, LevelOutcome::correct}});
  }
  return course;
}

TEST(Anchors, OfAProcedureHaveTheirLevelAndChangeNoTrack) {
  const AnchorJson file = tracks_with_anchors();
  const Protocol protocol = test::valid(file);
  const Course course = answered_correctly(protocol);
  EXPECT_THAT(anchors_in(course.plan()), ElementsAre("1 start", "14 middle", "27 end"));
  for (const Trial& trial : course.plan().trials) {
    if (!trial.anchor) continue;
    // 55 % above the standard of 1, which is not a level of the grid.
    EXPECT_DOUBLE_EQ(std::get<double>(trial.factors.at("texture_gain")), 1.55);
    EXPECT_EQ(text_of(trial.factors.at("shade")), "b");
    EXPECT_FALSE(trial.track);
    EXPECT_EQ(trial.presentations.at(1).role, "comparison");
    EXPECT_DOUBLE_EQ(
        std::get<double>(trial.presentations[1].stimulus.parameters.at("texture_gain")), 1.55);
    EXPECT_THAT(trial.questions.front().correct, ElementsAre("comparison"));
  }
  AnchorJson without = file;
  without["blocks"]["tracks"].erase("anchor");
  without["blocks"]["tracks"].erase("anchor_at");
  const Protocol plain = test::valid(without);
  EXPECT_EQ(others_in(course.plan()), others_in(answered_correctly(plain).plan()));
  EXPECT_EQ(expected_trials(protocol), 27);
  EXPECT_EQ(expected_trials(plain), 24);
}

TEST(Anchors, OfAProcedureAreAmongTheTrialsThatCanFollow) {
  const Protocol protocol = test::valid(tracks_with_anchors());
  Course course(protocol, {.seed = 4});
  for (int trial = 1; trial < 12; ++trial) course.advance({});
  ASSERT_EQ(course.awaited()->ordinal, 13) << "after the anchor at the start";
  for (const Trial& next : course.possible_next()) {
    EXPECT_EQ(next.anchor, std::optional(AnchorPlace::middle));
  }
}

// Its number of trials is not known: the middle is that of the largest number, 24.
TEST(Anchors, AreNotInTheMiddleOfTracksThatEndBefore) {
  AnchorJson file = tracks_with_anchors();
  file["blocks"]["tracks"]["procedure"]["stop"] = {{"reversals", 1}, {"trials", 6}};
  file["blocks"]["tracks"]["procedure"]["tracks"][1]["start"] = 80;
  const Protocol protocol = test::valid(file);
  Course course(protocol, {.seed = 4});
  std::map<int, int> steps{};
  while (const Trial* const trial = course.awaited()) {
    // Down, down, up: one reversal after the fourth trial of a track at the latest.
    const int step = ++steps[trial->track->track];
    const double value = std::get<double>(trial->factors.at("texture_gain"));
    course.advance({.answer = TrialOutcome::Answer{
                        value, step <= 2 ? LevelOutcome::correct : LevelOutcome::incorrect}});
  }
  const std::size_t others = others_in(course.plan()).size();
  ASSERT_LE(others, 12U);
  EXPECT_THAT(anchors_in(course.plan()),
              ElementsAre("1 start", std::to_string(others + 2) + " end"));
}

TEST(Anchors, OfAllPairsPresentTheStatedPair) {
  AnchorJson file = test::library_file("roughness_in_pairs");
  file["blocks"]["comparisons"]["anchor_pair"] = {"brick", "metal"};
  file["blocks"]["comparisons"]["anchor_at"] = kAllPlaces;
  std::size_t anchors = 0;
  for (const Trial& trial : make_plan(test::valid(file), {1, 0}).trials) {
    if (!trial.anchor) continue;
    ++anchors;
    EXPECT_EQ(trial.presentations.at(0).item, "brick");
    EXPECT_EQ(trial.presentations.at(1).stimulus.texture, "metal");
  }
  EXPECT_EQ(anchors, 3U);
}

TEST(Anchors, OfADesignWithSeveralTypesOfTrialsPresentTheComparison) {
  AnchorJson file = tracks_with_anchors();
  AnchorJson& block = file["blocks"]["tracks"];
  block["design"] = "yes_no";
  block.erase("positions");
  block.erase("procedure");
  block["vary"]["levels_percent"] = {10, 100};
  block["question"]["options"] = {{{"value", "yes"}, {"text", "Yes"}},
                                  {{"value", "no"}, {"text", "No"}}};
  file["observer"]["yes_above"] = 0.1;
  std::size_t anchors = 0;
  for (const Trial& trial : make_plan(test::valid(file), {1, 0}).trials) {
    if (!trial.anchor) continue;
    ++anchors;
    ASSERT_EQ(trial.presentations.size(), 1U);
    EXPECT_EQ(trial.presentations.front().role, "comparison");
    EXPECT_THAT(trial.questions.front().correct, ElementsAre("yes"));
  }
  EXPECT_EQ(anchors, 3U);
}

TEST(Anchors, AreCountedInTheCostOfAPlan) {
  const Protocol with = test::valid(selection_with_anchors(kAllPlaces));
  const Protocol without = test::valid(AnchorJson::parse(test::example_selection()));
  const PlanCost cost = cost_of(with, make_plan(with, {7, 0}));
  const PlanCost plain = cost_of(without, make_plan(without, {7, 0}));
  EXPECT_EQ(cost.trials, plain.trials + 3);
  // All trials of this block take equally long.
  const Plan plan = make_plan(with, {7, 0});
  EXPECT_NEAR(cost.total_s - plain.total_s, 3.0 * cost_of(with, plan, TrialStep{0}).total_s, 1e-9);
}

TEST(Anchors, AreRefusedWhereTheyCannotBeMade) {
  AnchorJson file = selection_with_anchors(kAllPlaces);
  AnchorJson& block = file["blocks"]["main"];
  block.erase("anchor");
  EXPECT_THAT(test::problems_at(file, "/blocks/main/anchor_at"),
              HasSubstr("without \"anchor\" there are no anchors to place"));
  block["anchor"] = {{"texture", "metal"}, {"model", "sinusoid"}};
  EXPECT_THAT(test::problems_at(file, "/blocks/main/anchor/model"),
              HasSubstr("do not set the factor \"model\""));
  block["anchor"] = {{"texture", "metal"}};
  block["anchor_pair"] = {"metal", "stone"};
  EXPECT_THAT(test::problems_at(file, "/blocks/main/anchor_pair"),
              HasSubstr("requires the key \"all_pairs\""));
  block.erase("anchor_pair");
  block["repetitions"] = 1;
  block.erase("crossed");
  block.erase("maximum_in_a_row");
  block["listed"] = AnchorJson::parse(R"([{"texture": "stone"}])");
  block["positions"] = "as_listed";
  EXPECT_THAT(test::problems_at(file, "/blocks/main/anchor_at"), HasSubstr("has no middle"));

  AnchorJson pairs = test::library_file("roughness_in_pairs");
  pairs["blocks"]["comparisons"]["anchor_pair"] = {"brick", "brick"};
  EXPECT_THAT(test::problems_at(pairs, "/blocks/comparisons/anchor_pair"),
              HasSubstr("both levels are equal"));

  AnchorJson tracks = tracks_with_anchors();
  tracks["blocks"]["tracks"]["anchor"].erase("shade");
  EXPECT_THAT(test::problems_at(tracks, "/blocks/tracks/anchor"),
              HasSubstr("does not set \"shade\""));
  tracks["blocks"]["tracks"]["anchor"] = {
      {"stroking", "slow"}, {"shade", "a"}, {"texture_gain", 2000}};
  EXPECT_THAT(test::problems_at(tracks, "/blocks/tracks/anchor/texture_gain"),
              HasSubstr("the level 2000 is a value of 21"));
  tracks["blocks"]["tracks"]["anchor"]["texture_gain"] = "much";
  EXPECT_THAT(test::problems_at(tracks, "/blocks/tracks/anchor/texture_gain"),
              HasSubstr("write a number"));
}

// Its responses would count for the criterion.
TEST(Anchors, AreRefusedInABlockThatEndsAtACriterion) {
  AnchorJson file = test::library_file("improved_recognition");
  for (auto& [name, block] : file["blocks"].items()) {
    if (!block.contains("until")) continue;
    block["anchor"] = {{"texture", "metal"}};
    EXPECT_THAT(test::problems_at(file, "/blocks/" + name + "/anchor", test::models_of_library()),
                HasSubstr("a block that ends at a criterion has no anchors"));
    return;
  }
  FAIL() << "the protocol has no criterion";
}

}  // namespace
}  // namespace asperity
