// Several questions in a trial: what a file can ask, what is refused, and how it is planned.

#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json attributes() { return test::library_file("attributes_of_textures"); }

TEST(Questions, OfOneNameHaveOneFormInAllMainBlocks) {
  json protocol = attributes();
  const std::string scale = protocol["blocks"]["ratings"]["questions"][0]["name"];
  protocol["blocks"]["recognition"]["question"]["name"] = scale;
  EXPECT_THAT(test::problems_at(protocol, "/blocks/recognition/question/name"),
              HasSubstr("give one of the questions another name"));
}

TEST(Questions, ArePlannedInEveryTrialOfTheirBlock) {
  const Plan plan = make_plan(test::valid(attributes()), {1, 0});
  std::set<std::string> first{};
  for (const Trial& trial : plan.trials) {
    if (trial.block == "recognition") {
      EXPECT_EQ(trial.kind, "recognition");
      ASSERT_EQ(trial.questions.size(), 1U);
      EXPECT_EQ(pages_of(trial).size(), 1U);
      EXPECT_EQ(json::parse(json_of(trial)).at("questions").size(), 1U);
      continue;
    }
    EXPECT_EQ(trial.kind, "rating");
    ASSERT_EQ(trial.questions.size(), 5U);
    EXPECT_EQ(pages_of(trial).size(), 1U);
    EXPECT_NE(find_question(trial, "slippery"), nullptr);
    EXPECT_EQ(find_question(trial, "wet"), nullptr);
    first.insert(trial.questions.front().name);
    const json stored = json::parse(json_of(trial)).at("questions");
    ASSERT_EQ(stored.size(), 5U);
    EXPECT_EQ(stored[0].at("name"), trial.questions.front().name);
    EXPECT_EQ(stored[0].at("points"), 7);
  }
  EXPECT_GT(first.size(), 2U) << "their order is drawn for every trial";
}

TEST(Questions, ComeInTheOrderOfTheFileUnlessTheyAreShuffled) {
  json protocol = attributes();
  json& block = protocol["blocks"]["ratings"];
  block.erase("question_order");
  block["question_layout"] = "one_after_another";
  block.erase("page_prompt");
  for (const Trial& trial : make_plan(test::valid(protocol), {1, 0}).trials) {
    if (trial.block != "ratings") continue;
    EXPECT_EQ(trial.questions[0].name, "rough");
    EXPECT_EQ(trial.questions[4].name, "pleasant");
    EXPECT_EQ(pages_of(trial).size(), 5U);
  }
}

// A question that is added leaves the trials as they were.
TEST(Questions, DoNotChangeTheTrialsThatAskThem) {
  json protocol = attributes();
  const Plan before = make_plan(test::valid(protocol), {5, 0});
  protocol["blocks"]["recognition"].erase("question");
  json own = attributes()["blocks"]["recognition"]["question"];
  protocol["blocks"]["recognition"]["questions"] = {
      own, {{"name", "sure"}, {"prompt", "How sure are you?"}, {"scale", json::object()}}};
  const Plan after = make_plan(test::valid(protocol), {5, 0});
  ASSERT_EQ(before.trials.size(), after.trials.size());
  for (std::size_t i = 0; i < before.trials.size(); ++i) {
    EXPECT_EQ(before.trials[i].factors, after.trials[i].factors);
    if (before.trials[i].block != "recognition") continue;
    ASSERT_EQ(after.trials[i].questions.size(), 2U);
    for (std::size_t option = 0; option < 7; ++option) {
      EXPECT_EQ(before.trials[i].questions[0].options[option].value,
                after.trials[i].questions[0].options[option].value);
    }
    EXPECT_EQ(name_of(after.trials[i].questions[1].form), "scale");
  }
}

TEST(Questions, AreRefusedAtTheirPlace) {
  const auto refused = [](const char* pointer, const json& value, const std::string& at) {
    json protocol = attributes();
    protocol[json::json_pointer(pointer)] = value;
    return test::problems_at(protocol, at);
  };
  const std::string block = "/blocks/ratings";
  EXPECT_THAT(refused("/blocks/ratings/questions/1/name", "rough", block + "/questions/1/name"),
              HasSubstr("two questions of a trial"));
  EXPECT_THAT(
      refused("/blocks/ratings/questions/0/scale/maximum", -3, block + "/questions/0/scale"),
      HasSubstr("raise \"maximum\""));
  EXPECT_THAT(refused("/blocks/ratings/questions/0/scale/labels", {"a", "b", "c"},
                      block + "/questions/0/scale/labels"),
              HasSubstr("labels given: 3, points: 7"));
  EXPECT_THAT(
      refused("/blocks/ratings/question", {{"name", "x"}, {"prompt", "X?"}}, block + "/question"),
      HasSubstr("exclude each other"));
  EXPECT_THAT(refused("/blocks/ratings/questions/0/scale/labels",
                      {"1", "2", "3", "4", "5", "6", "7"}, block + "/questions/0"),
              HasSubstr("one_after_another"));
  EXPECT_THAT(refused("/blocks/ratings/questions/0/pictures", {"metal", "wood"},
                      block + "/questions/0/pictures"),
              HasSubstr("exclude each other"));
  EXPECT_THAT(refused("/blocks/recognition/question/scale", json::object(),
                      "/blocks/recognition/question/pictures"),
              HasSubstr("exclude each other"));
  const json words = {{{"value", "yes"}, {"text", "Yes"}}, {{"value", "no"}, {"text", "No"}}};
  EXPECT_THAT(refused("/blocks/recognition/question/options", words,
                      "/blocks/recognition/question/options"),
              HasSubstr("only a discrimination"));
  EXPECT_THAT(refused("/blocks/ratings/questions/0/options", words, block + "/questions/0/options"),
              HasSubstr("exclude each other"));
  json protocol = attributes();
  for (const char* const key : {"questions", "question_order", "question_layout", "page_prompt"}) {
    protocol["blocks"]["ratings"].erase(key);
  }
  EXPECT_THAT(test::problems_at(protocol, block), HasSubstr("needs the key \"question\""));
}

// A recognition whose trials also have a scale has ratings to test.
TEST(Questions, OfAScaleMakeTheTestsOfRatingsAvailable) {
  json protocol = attributes();
  protocol["kind"] = "recognition";
  protocol["blocks"].erase("ratings");
  protocol["blocks"].erase("familiarisation");
  json flow = json::array();
  for (const json& step : protocol["flow"]) {
    const std::string run = step.value("run", "recognition");
    if (run == "recognition") flow.push_back(step);
  }
  protocol["flow"] = flow;
  json& block = protocol["blocks"]["recognition"];
  const json question = block["question"];
  block.erase("question");
  block["questions"] = {
      question, {{"name", "sure"}, {"prompt", "How sure are you?"}, {"scale", {{"points", 5}}}}};
  protocol["analysis"] = {{"family", {"right", "ratings"}}};
  test::valid(protocol);
  block["questions"].erase(1);
  EXPECT_THAT(test::problems_at(protocol, "/analysis/family/1"),
              HasSubstr("has no test \"ratings\""));
}

}  // namespace
}  // namespace asperity
