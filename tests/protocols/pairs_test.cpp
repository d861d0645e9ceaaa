// All pairs of the levels of a factor: how they are planned, and what a file cannot ask.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/stored_protocol.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json pairs_of_textures() { return test::library_file("roughness_in_pairs"); }

Plan plan_of_valid(const json& protocol) { return make_plan(test::valid(protocol), {1, 0}); }

/// The problems at a pointer below the main block, or at another one that begins with "//".
std::string problem_in_block(const json& protocol, const std::string& place) {
  return test::problems_at(
      protocol, place.starts_with("//") ? place.substr(1) : "/blocks/comparisons" + place);
}

json& comparisons_block(json& protocol) { return protocol["blocks"]["comparisons"]; }

using TexturePair = std::pair<std::string, std::string>;

TexturePair pair_in(const Trial& trial) {
  return {trial.presentations[0].stimulus.texture, trial.presentations[1].stimulus.texture};
}

TEST(AllPairs, ComeInBothOrdersOnceInEveryRepetition) {
  std::map<int, std::map<TexturePair, int>> of_repetition{};
  for (const Trial& trial : test::main_trials(test::valid(pairs_of_textures()))) {
    ASSERT_EQ(trial.presentations.size(), 2U);
    EXPECT_EQ(trial.presentations[0].position, 1);
    EXPECT_EQ(trial.presentations[1].position, 2);
    ++of_repetition[trial.repetition][pair_in(trial)];
    EXPECT_FALSE(trial.factors.contains("texture"));
  }
  ASSERT_EQ(of_repetition.size(), 3U);
  for (const auto& [repetition, pairs] : of_repetition) {
    EXPECT_EQ(pairs.size(), 12U) << repetition;
    for (const auto& [pair, times] : pairs) {
      EXPECT_EQ(times, 1);
      EXPECT_NE(pair.first, pair.second);
    }
  }
}

TEST(AllPairs, ComeOnceInAnOrderThatIsDrawnOrBalanced) {
  json protocol = pairs_of_textures();
  comparisons_block(protocol)["all_pairs"].erase("in_both_orders");
  comparisons_block(protocol)["positions"] = "balanced";
  std::map<std::set<std::string>, int> pairs{};
  int in_order_of_levels = 0;
  for (const Trial& trial : test::main_trials(test::valid(protocol))) {
    const TexturePair pair = pair_in(trial);
    ++pairs[{pair.first, pair.second}];
    const std::vector<std::string> levels{"metal", "stone", "wood", "brick"};
    in_order_of_levels += std::find(levels.begin(), levels.end(), pair.first) <
                          std::find(levels.begin(), levels.end(), pair.second);
  }
  EXPECT_EQ(pairs.size(), 6U);
  for (const auto& [pair, times] : pairs) EXPECT_EQ(times, 3);
  EXPECT_EQ(in_order_of_levels, 9);
}

TEST(AllPairs, AreCombinedWithEveryLevelOfACrossedFactor) {
  json protocol = pairs_of_textures();
  protocol["factors"]["model"] = {{"levels", {"height_map", "sinusoid"}}};
  protocol["stimuli"]["rendered"]["model"] = {{"factor", "model"}};
  comparisons_block(protocol)["crossed"] = {"texture"};
  comparisons_block(protocol)["all_pairs"] = {{"factor", "model"}, {"in_both_orders", true}};
  protocol["blocks"]["familiarisation"]["crossed"] = {"model"};
  std::set<std::string> textures{};
  int trials = 0;
  for (const Trial& trial : test::main_trials(test::valid(protocol))) {
    ++trials;
    textures.insert(text_of(trial.factors.at("texture")));
    EXPECT_EQ(trial.presentations[0].item, trial.presentations[0].stimulus.model)
        << "the level names the surface";
    EXPECT_NE(trial.presentations[0].item, trial.presentations[1].item);
    EXPECT_EQ(trial.presentations[0].stimulus.texture, trial.presentations[1].stimulus.texture);
  }
  EXPECT_EQ(trials, 4 * 2 * 3);
  EXPECT_EQ(textures.size(), 4U);
}

TEST(AllPairs, NameSurfacesByLevelsThatAreNumbers) {
  json protocol = pairs_of_textures();
  protocol["factors"]["scale"] = {{"levels", {0.5, 1, 2}}};
  protocol["stimuli"]["rendered"] = {{"model", "height_map"},
                                     {"texture", "wood"},
                                     {"parameters", {{"height_scale", {{"factor", "scale"}}}}}};
  comparisons_block(protocol)["all_pairs"] = {{"factor", "scale"}, {"in_both_orders", true}};
  protocol["blocks"]["familiarisation"]["all_pairs"] = {{"factor", "scale"}};
  std::set<std::string> items{};
  for (const Trial& trial : plan_of_valid(protocol).trials) {
    for (const PlannedPresentation& planned : trial.presentations) {
      items.insert(planned.item);
      EXPECT_EQ(planned.item, text_of(planned.stimulus.parameters.at("height_scale")));
    }
  }
  EXPECT_THAT(items, testing::ElementsAre("0.5", "1", "2"));
}

TEST(AllPairs, OfferTheSurfacesAndATie) {
  const Plan plan = plan_of_valid(pairs_of_textures());
  const std::vector<Option>& options = plan.trials.back().questions.front().options;
  ASSERT_EQ(options.size(), 3U);
  EXPECT_EQ(options[0].label, "A");
  EXPECT_EQ(options[0].value, plan.trials.back().presentations[0].item);
  EXPECT_EQ(options[2].value, kTieOption);
  EXPECT_EQ(options[2].label, "3");
  EXPECT_EQ(options[2].text, "Equally rough");
  json without = pairs_of_textures();
  comparisons_block(without)["question"].erase("tie");
  EXPECT_EQ(plan_of_valid(without).trials.back().questions.front().options.size(), 2U);
  EXPECT_NE(without_texts(pairs_of_textures().dump()), without_texts(without.dump()));
}

TEST(AllPairs, RefuseWhatWouldNotBeAllPairs) {
  const auto with = [](const char* key, const json& value) {
    json protocol = pairs_of_textures();
    comparisons_block(protocol)[key] = value;
    return protocol;
  };
  EXPECT_THAT(problem_in_block(with("positions", "shuffle"), "/positions"),
              HasSubstr("both orders"));
  EXPECT_THAT(problem_in_block(with("crossed", {"texture"}), "/all_pairs/factor"),
              HasSubstr("already set by \"crossed\""));
  EXPECT_THAT(problem_in_block(with("all_pairs", {{"factor", "grain"}}), "/all_pairs/factor"),
              HasSubstr("grain"));
  EXPECT_THAT(
      problem_in_block(with("presented", {{{"stimulus", "rendered"}}, {{"stimulus", "rendered"}}}),
                       "/presented"),
      HasSubstr("list it once"));
  EXPECT_THAT(problem_in_block(with("presented", {{{"stimulus", "rendered"}, {"item", "wood"}}}),
                               "/presented/0/item"),
              HasSubstr("the name of its level"));
  EXPECT_THAT(problem_in_block(
                  with("presented", {{{"stimulus", "rendered"}, {"with", {{"texture", "wood"}}}}}),
                  "/presented/0/with/texture"),
              HasSubstr("the pairs set the factor"));
  json same = with("all_pairs", {{"factor", "hand"}});
  same["factors"]["hand"] = {{"levels", {"left", "right"}}};
  EXPECT_THAT(problem_in_block(same, "/all_pairs/factor"), HasSubstr("would be the same"));
  json alone = pairs_of_textures();
  alone["factors"]["texture"]["levels"] = {"wood"};
  EXPECT_THAT(problem_in_block(alone, "/all_pairs/factor"), HasSubstr("no pairs"));
  json grouped = pairs_of_textures();
  grouped["groups"] = {{"factor", "texture"}};
  EXPECT_THAT(problem_in_block(grouped, ""), HasSubstr("the factor of the groups"));
  json explored = pairs_of_textures();
  comparisons_block(explored)["exploration"] = {{"factor", "texture"}};
  EXPECT_THAT(problem_in_block(explored, "/exploration"), HasSubstr("texture"));
}

TEST(PairedComparison, RefusesWhatIsNoChoiceBetweenTwoSurfaces) {
  const auto asked = [](const char* key, const json& value) {
    json protocol = pairs_of_textures();
    comparisons_block(protocol)["question"][key] = value;
    return protocol;
  };
  EXPECT_THAT(problem_in_block(asked("allow_cannot_tell", true), "/question/allow_cannot_tell"),
              HasSubstr("or a discrimination has this key"));
  EXPECT_THAT(problem_in_block(asked("correct_factor", "texture"), "/question/correct_factor"),
              HasSubstr("only a recognition"));
  json one = pairs_of_textures();
  comparisons_block(one).erase("all_pairs");
  comparisons_block(one)["crossed"] = {"texture"};
  EXPECT_THAT(problem_in_block(one, "/presented"), HasSubstr("exactly two surfaces"));
  json tied = pairs_of_textures();
  tied["textures"]["tie"] = tied["textures"]["wood"];
  tied["factors"]["texture"]["levels"] = {"tie", "wood", "metal"};
  tied["textures"]["tie"]["code"] = "T9";
  EXPECT_THAT(problem_in_block(tied, "/presented"), HasSubstr("the name of a tie"));
  json selection = pairs_of_textures();
  selection["kind"] = "selection";
  selection["realism_standard"] = "memory";
  EXPECT_THAT(problem_in_block(selection, "/question/tie"),
              HasSubstr("only a paired comparison has this key"));
}

TEST(PairedComparison, AsksOneQuestionAboutOneSetOfItemsInAllItsMainBlocks) {
  json protocol = pairs_of_textures();
  protocol["blocks"]["second"] = protocol["blocks"]["comparisons"];
  protocol["flow"].push_back({{"run", "second"}});
  const std::string at_question = "//blocks/second/question";
  EXPECT_EQ(problem_in_block(protocol, at_question), "");
  for (const char* const key : {"name", "prompt"}) {
    json other = protocol;
    other["blocks"]["second"]["question"][key] = "harder";
    EXPECT_THAT(problem_in_block(other, at_question), HasSubstr("has another question")) << key;
  }
  json without_tie = protocol;
  without_tie["blocks"]["second"]["question"].erase("tie");
  EXPECT_THAT(problem_in_block(without_tie, at_question), HasSubstr("has another question"));
  without_tie["blocks"]["second"]["phase"] = "practice";
  EXPECT_EQ(problem_in_block(without_tie, at_question), "");
  json other_items = protocol;
  other_items["stimuli"]["other"] = other_items["stimuli"]["rendered"];
  other_items["blocks"]["second"]["presented"][0]["stimulus"] = "other";
  EXPECT_THAT(problem_in_block(other_items, "//blocks/second/presented"),
              HasSubstr("compares other surfaces"));
}

TEST(PairedComparison, RefusesOneOrderOfEveryPair) {
  json protocol = pairs_of_textures();
  comparisons_block(protocol)["all_pairs"].erase("in_both_orders");
  EXPECT_THAT(problem_in_block(protocol, "/all_pairs"), HasSubstr("always be presented first"));
  comparisons_block(protocol)["positions"] = "shuffle";
  EXPECT_EQ(problem_in_block(protocol, "/all_pairs"), "");
  json listed = pairs_of_textures();
  comparisons_block(listed).erase("all_pairs");
  comparisons_block(listed)["presented"] = {
      {{"stimulus", "rendered"}, {"with", {{"texture", "wood"}}}},
      {{"stimulus", "rendered"}, {"with", {{"texture", "metal"}}}}};
  EXPECT_THAT(problem_in_block(listed, "/presented"), HasSubstr("always be presented first"));
  comparisons_block(listed)["positions"] = "shuffle";
  EXPECT_EQ(problem_in_block(listed, "/presented"), "");
}

TEST(AllPairs, BelongToKindsThatCompareSurfaces) {
  json protocol = pairs_of_textures();
  protocol["kind"] = "rating";
  for (const char* const name : {"familiarisation", "comparisons"}) {
    protocol["blocks"][name]["question"].erase("tie");
    protocol["blocks"][name]["question"]["scale"] = json::object();
  }
  EXPECT_THAT(problem_in_block(protocol, "/all_pairs"), HasSubstr("or a similarity has this key"));
  EXPECT_EQ(problem_in_block(protocol, "/presented"), "");
}

TEST(PairedComparison, CanBeMadeAgainstAPhysicalSampleOfEachTexture) {
  json protocol = pairs_of_textures();
  protocol["factors"]["model"] = {{"levels", {"height_map", "sinusoid"}}};
  protocol["stimuli"]["rendered"]["model"] = {{"factor", "model"}};
  for (const char* const name : {"familiarisation", "comparisons"}) {
    protocol["blocks"][name]["crossed"] = {"texture"};
    protocol["blocks"][name]["all_pairs"] = {{"factor", "model"}, {"in_both_orders", true}};
    protocol["blocks"][name].erase("positions");
    protocol["blocks"][name]["question"]["experimenter_prompt"] = "Place sample {code}.";
  }
  protocol["realism_standard"] = "physical_sample";
  const Plan plan = plan_of_valid(protocol);
  EXPECT_THAT(plan.trials.back().experimenter_prompt, testing::MatchesRegex("Place sample T.\\."));
  comparisons_block(protocol)["question"].erase("experimenter_prompt");
  EXPECT_THAT(problem_in_block(protocol, "/question"), HasSubstr("which sample to place"));
  json different = pairs_of_textures();
  different["realism_standard"] = "memory";
  EXPECT_THAT(problem_in_block(different, "/presented"), HasSubstr("show different textures"));
  json rating = pairs_of_textures();
  rating["kind"] = "rating";
  rating["realism_standard"] = "memory";
  EXPECT_THAT(problem_in_block(rating, "//realism_standard"), HasSubstr("remove it"));
}

}  // namespace
}  // namespace asperity
