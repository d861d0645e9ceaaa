// Additional questions of a trial: the forms in which they are answered, and what is refused.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Recognition of a texture, then an additional question.
json with_question(const char* question) {
  json protocol = test::library_file("chapter_recognition");
  json& block = protocol["blocks"]["main"];
  block["questions"] = {block["question"], json::parse(question)};
  block.erase("question");
  return protocol;
}

std::string problem_with_question(const char* question, const std::string& key) {
  return test::problems_at(with_question(question), "/blocks/main/questions/1" + key);
}

Question planned_question(const char* question) {
  const Protocol protocol = test::valid(with_question(question));
  for (const Trial& trial : example_plan(protocol, {.seed = 1, .counterbalance_row = 1}).trials) {
    if (trial.block == "main") return trial.questions.at(1);
  }
  return {};
}

std::vector<std::string> option_values(const Question& question) {
  std::vector<std::string> values{};
  for (const Option& option : question.options) values.push_back(option.value);
  return values;
}

TEST(AdditionalQuestion, HasEveryFormOfTheQuestionnaire) {
  const Question several = planned_question(
      R"({"name": "felt", "prompt": "What did you feel?", "form": "multiple_choice",
      "options": [{"value": "ridges", "text": "ridges"}, {"value": "grains", "text": "grains"}]})");
  EXPECT_TRUE(several.is_answered_by<MultipleChoiceForm>());
  EXPECT_THAT(option_values(several), ElementsAre("ridges", "grains"));
  EXPECT_TRUE(several.correct.empty()) << "only the response of the kind is correct or incorrect";
  const Question number = planned_question(
      R"({"name": "count", "prompt": "How many ridges?", "form": "number", "minimum": 0, "maximum": 9})");
  EXPECT_EQ(std::get<NumberForm>(number.form), (NumberForm{.minimum = 0.0, .maximum = 9.0}));
  EXPECT_TRUE(planned_question(R"({"name": "words", "prompt": "Describe it.", "form": "text"})")
                  .is_answered_by<TextForm>());
  EXPECT_TRUE(planned_question(R"({"name": "length", "prompt": "How long?", "form": "line"})")
                  .is_answered_by<LineForm>());
  const Question choice =
      planned_question(R"({"name": "warm", "prompt": "Was it warm?", "form": "choice",
      "options": [{"value": "yes", "text": "Yes"}, {"value": "no", "text": "No"}]})");
  EXPECT_THAT(option_values(choice), ElementsAre("yes", "no"));
}

TEST(AdditionalQuestion, HasTheSurfacesAsOptionsOfAChoice) {
  json protocol = test::library_file("roughness_in_pairs");
  json& block = protocol["blocks"]["comparisons"];
  block["questions"] = {
      block["question"],
      json::parse(R"({"name": "warmer", "prompt": "Which was warmer?", "form": "choice"})")};
  block.erase("question");
  const Protocol read = test::valid(protocol);
  const std::vector<Trial> trials = test::main_trials(read);
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials.front().questions.at(1).options.size(), 2U);
}

TEST(AdditionalQuestion, IsAnalysedByNoKindExceptAScale) {
  const ExperimentKind& recognition = kind_named("recognition");
  EXPECT_EQ(
      kind_of_question(recognition,
                       planned_question(R"({"name": "words", "prompt": "?", "form": "text"})")),
      nullptr);
  EXPECT_EQ(kind_of_question(recognition,
                             planned_question(R"({"name": "rough", "prompt": "?", "form": "scale",
                                         "scale": {"minimum": 1, "maximum": 7, "points": 7}})")),
            find_kind("rating"));
}

TEST(AdditionalQuestion, IsRefusedWithWhatItsFormLacks) {
  EXPECT_THAT(
      problem_with_question(R"({"name": "q", "prompt": "?", "form": "multiple_choice"})", ""),
      HasSubstr("a multiple choice needs \"options\""));
  EXPECT_THAT(problem_with_question(R"({"name": "q", "prompt": "?", "form": "text", "minimum": 1})",
                                    "/minimum"),
              HasSubstr("where \"form\" is \"number\""));
  EXPECT_THAT(problem_with_question(
                  R"({"name": "q", "prompt": "?", "form": "number", "minimum": 9, "maximum": 1})",
                  "/minimum"),
              HasSubstr("no number is at least 9"));
  EXPECT_THAT(problem_with_question(R"({"name": "q", "prompt": "?", "form": "scale"})", ""),
              HasSubstr("a scale needs the key \"scale\""));
  EXPECT_THAT(
      problem_with_question(
          R"({"name": "q", "prompt": "?", "form": "choice", "tie": {"text": "equal"}})", "/tie"),
      HasSubstr("keep one of the two"));
  EXPECT_THAT(problem_with_question(
                  R"({"name": "q", "prompt": "?", "form": "text", "allow_cannot_tell": true})",
                  "/allow_cannot_tell"),
              HasSubstr("is \"choice\" or absent"));
}

TEST(AdditionalQuestion, DoesNotTakeThePlaceOfTheQuestionOfTheKind) {
  json protocol = test::library_file("chapter_recognition");
  protocol["blocks"]["main"]["question"] =
      json::parse(R"({"name": "q", "prompt": "?", "form": "text"})");
  EXPECT_THAT(test::problems_at(protocol, "/blocks/main/question"),
              HasSubstr("a recognition needs one question answered by a choice in every trial"));
  json limits = test::library_file("roughness_force");
  const std::string block = limits["blocks"].items().begin().key();
  limits["blocks"][block]["question"]["minimum"] = 1;
  EXPECT_THAT(test::problems_at(limits, "/blocks/" + block + "/question/minimum"),
              HasSubstr("where \"form\" is \"number\""));
}

}  // namespace
}  // namespace asperity
