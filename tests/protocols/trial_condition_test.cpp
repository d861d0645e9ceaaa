// Conditions of the questions of a trial: what is read, planned and refused.

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Recognition of a texture, then how sure the participant is, and what was hard where that is little.
json with_condition(const json& condition) {
  json protocol = test::library_file("chapter_recognition");
  json& block = protocol["blocks"]["main"];
  json sure = json::parse(R"({"name": "sure", "prompt": "How sure are you?",
                              "scale": {"minimum": 1, "maximum": 5, "points": 5}})");
  json hard = json::parse(R"({"name": "hard", "prompt": "How hard was it?",
                              "scale": {"minimum": 1, "maximum": 3, "points": 3}})");
  hard["if"] = condition;
  block["questions"] = {block["question"], sure, hard};
  block.erase("question");
  return protocol;
}
json with_condition(const char* condition) { return with_condition(json::parse(condition)); }

std::string problem(const char* condition, const std::string& key) {
  return test::problems_at(with_condition(condition), "/blocks/main/questions/2/if" + key);
}

Trial first_main_trial(const Protocol& protocol) {
  for (const Trial& trial : example_plan(protocol, {.seed = 1, .counterbalance_row = 1}).trials) {
    if (trial.block == "main") return trial;
  }
  return {};
}

TEST(TrialCondition, IsReadAndPlanned) {
  const Protocol protocol = test::valid(with_condition(R"({"question": "sure", "at_most": 2})"));
  const Trial trial = first_main_trial(protocol);
  ASSERT_EQ(trial.questions.size(), 3U);
  EXPECT_FALSE(trial.questions[0].condition);
  EXPECT_EQ(trial.questions[2].condition,
            (AnswerCondition{.question = "sure", .test = AnswerWithin{.maximum = 2.0}}));
  EXPECT_THAT(json_of(trial), HasSubstr("\"if\":\"sure ≤ 2\""));
  const json without = test::library_file("chapter_recognition");
  EXPECT_THAT(json_of(first_main_trial(test::valid(without))), Not(HasSubstr("\"if\"")));
}

TEST(TrialCondition, MayReferToThePictureThatWasChosen) {
  EXPECT_EQ(problem(R"({"question": "recognised", "in": ["metal", "stone"]})", ""), "");
  EXPECT_THAT(problem(R"({"question": "recognised", "in": ["metal", "glass"]})", "/in/1"),
              HasSubstr("\"glass\" is not an option of the question \"recognised\""));
}

TEST(TrialCondition, RefersToAnEarlierQuestionOfTheTrial) {
  EXPECT_THAT(problem(R"({"question": "hard", "is": 1})", "/question"),
              HasSubstr("no earlier question of the trial has the name \"hard\""));
  EXPECT_THAT(problem(R"({"question": "age", "is": 1})", "/question"),
              HasSubstr("no earlier question of the trial has the name \"age\""));
}

TEST(TrialCondition, CanBeMet) {
  EXPECT_THAT(problem(R"({"question": "sure", "is": 2.5})", "/is"), HasSubstr("not a point"));
  EXPECT_THAT(problem(R"({"question": "sure", "at_least": 6})", "/at_least"),
              HasSubstr("change the range"));
  EXPECT_THAT(problem(R"({"question": "sure", "is": 2, "at_least": 2})", ""),
              HasSubstr("keep one of them"));
}

TEST(TrialCondition, IsRefusedOnTheQuestionOfTheKind) {
  json protocol = with_condition(R"({"question": "sure", "at_most": 2})");
  json& questions = protocol["blocks"]["main"]["questions"];
  questions[0]["if"] = {{"question", "sure"}, {"is", 1}};
  std::swap(questions[0], questions[1]);
  EXPECT_EQ(test::problems_at(protocol, "/blocks/main/questions/1/if"),
            "the analysis of a recognition needs the response to this question in every trial; "
            "remove this key");
}

TEST(TrialCondition, IsRefusedWhereTheAnswerIsNotKnownBefore) {
  json protocol = with_condition(R"({"question": "sure", "at_most": 2})");
  protocol["blocks"]["main"]["question_order"] = "shuffle";
  EXPECT_THAT(test::problems_at(protocol, "/blocks/main/questions/2/if"),
              HasSubstr("set \"question_order\" to \"fixed\""));
}

}  // namespace
}  // namespace asperity
