// The questionnaire: forms of its questions, conditions of questions and screens, and what is refused.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/answers/question.h"
#include "protocols/file/stored_protocol.h"
#include "tests/protocols/protocol_files.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A library protocol that asks, at the end, for pain, its strength and its kind, and shows a text.
json questioned() {
  json protocol = test::library_file("spacing_jnd");
  protocol["questions"].update(json::parse(R"({
    "pain": {"prompt": "Does your hand hurt?", "form": "choice", "options": ["yes", "no"]},
    "strength": {"prompt": "How strong is the pain?", "form": "scale",
                 "scale": {"minimum": 0, "maximum": 10, "points": 11},
                 "if": {"question": "pain", "is": "yes"}},
    "kinds": {"prompt": "What kind of pain?", "form": "multiple_choice",
              "options": ["sharp", "dull", "burning"], "if": {"question": "strength", "at_least": 5}},
    "since": {"prompt": "Since when?", "form": "number", "unit": "min", "minimum": 0, "maximum": 120,
              "if": {"question": "kinds", "includes": "burning"}}
  })"));
  protocol["flow"].push_back({{"ask", {"pain", "strength", "kinds", "since"}}});
  protocol["flow"].push_back(json::parse(
      R"({"screen": "Please tell us.", "if": {"question": "strength", "in": [8, 9, 10]}})"));
  return protocol;
}

TEST(Questionnaire, IsReadWithItsFormsAndConditions) {
  const Protocol protocol = test::valid(questioned());
  EXPECT_EQ(std::get<ScaleForm>(protocol.questions.at("strength").form).points, 11);
  EXPECT_EQ(protocol.questions.at("strength").condition,
            (AnswerCondition{.question = "pain", .test = AnswerIsOneOf{{"yes"}}}));
  EXPECT_TRUE(protocol.questions.at("kinds").is_answered_by<MultipleChoiceForm>());
  EXPECT_EQ(protocol.questions.at("kinds").condition,
            (AnswerCondition{.question = "strength", .test = AnswerWithin{.minimum = 5.0}}));
  EXPECT_EQ(std::get<NumberForm>(protocol.questions.at("since").form).unit, "min");
  EXPECT_EQ(protocol.questions.at("since").condition,
            (AnswerCondition{.question = "kinds", .test = AnswerIncludes{"burning"}}));
  EXPECT_EQ(std::get<Protocol::Screen>(protocol.flow.back()).condition,
            (AnswerCondition{.question = "strength", .test = AnswerIsOneOf{{8.0, 9.0, 10.0}}}));
}

TEST(Questionnaire, RefusesAConditionOnAQuestionThatIsUnknownOrAskedLater) {
  json protocol = questioned();
  protocol["questions"]["strength"]["if"]["question"] = "pian";
  EXPECT_THAT(test::problems_at(protocol, "/questions/strength/if/question"),
              HasSubstr("did you mean \"pain\""));

  protocol = questioned();
  protocol["flow"][protocol["flow"].size() - 2]["ask"] = {"strength", "pain", "kinds", "since"};
  EXPECT_EQ(test::problems_at(protocol, "/questions/strength/if/question"),
            "the flow does not ask the question \"pain\" before; ask it in an earlier step of the "
            "flow, or earlier in the same one");
  EXPECT_EQ(test::problems_at(protocol, "/questions/kinds/if/question"), "");

  protocol = questioned();
  const std::size_t last = protocol["flow"].size() - 1;
  std::swap(protocol["flow"][last], protocol["flow"][last - 1]);
  EXPECT_THAT(test::problems_at(protocol, "/flow/" + std::to_string(last - 1) + "/if/question"),
              HasSubstr("does not ask the question \"strength\" before"));

  protocol = questioned();
  protocol["questions"]["pain"]["if"] = {{"question", "pain"}, {"is", "yes"}};
  EXPECT_THAT(test::problems_at(protocol, "/questions/pain/if/question"), HasSubstr("before"));
}

TEST(Questionnaire, RefusesAValueThatTheQuestionCannotHave) {
  const auto with_condition = [](const char* condition) {
    json protocol = questioned();
    protocol["questions"]["since"]["if"] = json::parse(condition);
    return protocol;
  };
  const std::string at = "/questions/since/if";
  const auto problem = [&](const char* condition, const char* key) {
    return test::problems_at(with_condition(condition), at + key);
  };
  EXPECT_EQ(problem(R"({"question": "pain", "is": "maybe"})", "/is"),
            "\"maybe\" is not an option of the question \"pain\"; use \"yes\" or \"no\"");
  EXPECT_THAT(problem(R"({"question": "pain", "in": ["no", 1]})", "/in/1"),
              HasSubstr("1 is not an option of the question \"pain\""));
  EXPECT_THAT(problem(R"({"question": "pain", "at_least": 1})", "/at_least"),
              HasSubstr("state \"is\" or \"in\""));
  EXPECT_THAT(problem(R"({"question": "pain", "includes": "yes"})", "/includes"),
              HasSubstr("only a multiple choice includes options"));
  EXPECT_THAT(problem(R"({"question": "kinds", "is": "sharp"})", "/is"),
              HasSubstr("state \"includes\""));
  EXPECT_THAT(problem(R"({"question": "kinds", "includes": "blunt"})", "/includes"),
              HasSubstr("use \"sharp\", \"dull\" or \"burning\""));
  EXPECT_EQ(problem(R"({"question": "strength", "is": 2.5})", "/is"),
            "2.5 is not a point of the scale of the question \"strength\"; the points are 1 apart, "
            "from 0 to 10");
  EXPECT_THAT(problem(R"({"question": "strength", "is": 11})", "/is"),
              HasSubstr("use a number of 0 to 10"));
  EXPECT_THAT(problem(R"({"question": "strength", "is": "strong"})", "/is"),
              HasSubstr("state a number"));
  EXPECT_EQ(
      problem(R"({"question": "strength", "at_least": 11})", "/at_least"),
      "the answer to the question \"strength\" is 0 to 10 and never 11 or more; change the range");
  EXPECT_THAT(problem(R"({"question": "strength", "at_most": -1})", "/at_most"),
              HasSubstr("never -1 or less"));
  EXPECT_THAT(problem(R"({"question": "strength", "at_least": 6, "at_most": 5})", "/at_least"),
              HasSubstr("exchange the two"));
  EXPECT_THAT(problem(R"({"question": "strategy", "is": "none"})", "/is"), HasSubstr("free text"));
  EXPECT_THAT(problem(R"({"question": "pain"})", ""), HasSubstr("a condition states one of"));
  EXPECT_THAT(problem(R"({"question": "pain", "is": "yes", "in": ["no"]})", ""),
              HasSubstr("keep one of them"));
}

TEST(Questionnaire, RefusesKeysOfOtherForms) {
  json protocol = questioned();
  protocol["questions"]["pain"]["unit"] = "N";
  protocol["questions"]["pain"]["scale"] = {{"points", 5}};
  EXPECT_THAT(test::problems_at(protocol, "/questions/pain/unit"), HasSubstr("is \"number\""));
  EXPECT_THAT(test::problems_at(protocol, "/questions/pain/scale"), HasSubstr("is \"scale\""));
  json lacking = questioned();
  lacking["questions"]["strength"].erase("scale");
  lacking["questions"]["kinds"].erase("options");
  EXPECT_THAT(test::problems_at(lacking, "/questions/strength"),
              HasSubstr("a scale needs the key"));
  EXPECT_THAT(test::problems_at(lacking, "/questions/kinds"), HasSubstr("a multiple choice needs"));
}

TEST(Questionnaire, RefusesAScaleAndAConditionAmongTheQuestionsAboutTheParticipant) {
  json protocol = questioned();
  protocol["participants"]["questions"] = {"strength", "kinds", "pain"};
  protocol["questions"]["kinds"].erase("if");
  EXPECT_THAT(test::problems_at(protocol, "/participants/questions/0"),
              HasSubstr("ask it in the flow"));
  EXPECT_THAT(test::problems_at(protocol, "/participants/questions/1"),
              HasSubstr("multiple choice"));
  EXPECT_EQ(test::problems_at(protocol, "/participants/questions/2"), "");
}

TEST(AnswerCondition, IsMetByAnAnswerThatFits) {
  const AnswerCondition is{.question = "q", .test = AnswerIsOneOf{{"yes", "perhaps"}}};
  EXPECT_TRUE(is_met(is, {"perhaps"}));
  EXPECT_FALSE(is_met(is, {"no"}));
  const AnswerCondition number{.question = "q", .test = AnswerIsOneOf{{2.0}}};
  EXPECT_TRUE(is_met(number, {"2.0"})) << "the digits do not matter";
  EXPECT_FALSE(is_met(number, {"20"}));
  const AnswerCondition includes{.question = "q", .test = AnswerIncludes{"dull"}};
  EXPECT_TRUE(is_met(includes, {"sharp", "dull"}));
  EXPECT_FALSE(is_met(includes, {"sharp"}));
  const AnswerCondition within{.question = "q",
                               .test = AnswerWithin{.minimum = 2.0, .maximum = 3.0}};
  EXPECT_TRUE(is_met(within, {"2"}));
  EXPECT_TRUE(is_met(within, {"3"}));
  EXPECT_FALSE(is_met(within, {"1.9"}));
  EXPECT_FALSE(is_met(within, {"3.1"}));
}

TEST(AnswerCondition, IsNotMetWithoutAnAnswer) {
  for (const AnswerCondition& condition :
       {AnswerCondition{.question = "q", .test = AnswerIsOneOf{{""}}},
        AnswerCondition{.question = "q", .test = AnswerIncludes{""}},
        AnswerCondition{.question = "q", .test = AnswerWithin{.maximum = 3.0}}}) {
    EXPECT_FALSE(is_met(condition, {}));
  }
}

TEST(AnswerCondition, IsStatedInSignsAndInWords) {
  const auto both = [](const AnswerCondition& condition) {
    return signs_of(condition) + " | " + clause_of(condition);
  };
  EXPECT_EQ(both({.question = "pain", .test = AnswerIsOneOf{{"yes"}}}),
            "pain = yes | the answer to \"pain\" was \"yes\"");
  EXPECT_EQ(both({.question = "pain", .test = AnswerIsOneOf{{8.0, 9.0, 10.0}}}),
            "pain ∈ {8, 9, 10} | the answer to \"pain\" was 8, 9 or 10");
  EXPECT_EQ(both({.question = "kinds", .test = AnswerIncludes{"dull"}}),
            "kinds ∋ dull | the answer to \"kinds\" included \"dull\"");
  EXPECT_EQ(both({.question = "age", .test = AnswerWithin{.minimum = 18.0, .maximum = 30.0}}),
            "18 ≤ age ≤ 30 | the answer to \"age\" was 18 to 30");
}

TEST(StoredAnswer, IsComparedWithItsQuestion) {
  Question question{
      .name = "kinds", .form = MultipleChoiceForm{}, .options = in_words({"sharp", "dull"})};
  const auto problems = [&question](const std::vector<AnsweredItem>& stored) {
    return problems_with(question, stored);
  };
  const std::vector<AnsweredItem> both{{.item = 1, .answer = "sharp"},
                                       {.item = 2, .answer = "dull"}};
  EXPECT_THAT(problems(both), IsEmpty());
  EXPECT_THAT(problems({both[0], {.item = 2, .answer = "blunt"}}),
              ElementsAre(HasSubstr("item 2: the response is not among the options")));
  EXPECT_THAT(problems({}), ElementsAre(HasSubstr("left empty")));
  EXPECT_THAT(problems({{.answer = ""}}), ElementsAre(HasSubstr("left empty")));
  question.optional = true;
  EXPECT_THAT(problems({}), IsEmpty());
  question.form = ChoiceForm{};
  EXPECT_THAT(problems(both), ElementsAre(HasSubstr("its answer has 2 items, but a choice of one "
                                                    "option has 1")));
  question.correct = {"dull"};
  EXPECT_THAT(problems({{.answer = "dull", .correct = true}}), IsEmpty());
  EXPECT_THAT(problems({{.answer = "dull", .correct = false}}),
              ElementsAre(HasSubstr("not marked correct or incorrect")));
  question.form = ScaleForm{.minimum = 1.0, .maximum = 7.0, .points = 7};
  EXPECT_THAT(problems({{.answer = "3", .number = 3.0}}), IsEmpty());
  EXPECT_THAT(problems({{.answer = "3.5", .number = 3.5}}),
              ElementsAre(HasSubstr("3.5 is not a point on a scale that the question permits")));
  EXPECT_THAT(problems({{.answer = "3", .number = 4.0}}),
              ElementsAre(HasSubstr("differs from the number stored with it")));
  question.form = NumberForm{.minimum = 18.0, .maximum = 99.0};
  EXPECT_THAT(problems({{.answer = "18", .number = 18.0}}), IsEmpty());
  EXPECT_THAT(problems({{.answer = "17", .number = 17.0}}), ElementsAre(HasSubstr("17 is not")));
  EXPECT_THAT(problems({{.answer = "100", .number = 100.0}}), ElementsAre(HasSubstr("100 is not")));
  question.form = NumberForm{.is_estimate = true};
  EXPECT_THAT(problems({{.answer = "0", .number = 0.0}}), ElementsAre(HasSubstr("0 is not")));
  question.form = TextForm{};
  EXPECT_THAT(problems({{.answer = "numbness"}}), IsEmpty());
}

TEST(StoredAnswer, HasAnItemForEverySurfaceOfAnAssignment) {
  const Question question{
      .name = "which", .form = AssignmentForm{}, .options = in_words({"stone", "wood"})};
  const std::vector<AnsweredItem> both{{.item = 1, .answer = "wood"},
                                       {.item = 2, .answer = "stone"}};
  EXPECT_THAT(problems_with(question, both, 2), IsEmpty());
  EXPECT_THAT(problems_with(question, both, 3),
              ElementsAre(HasSubstr("2 items, but an assignment has 3")));
}

TEST(StoredProtocol, KnowsTheFormsAndConditionsOfAQuestionnaire) {
  const Protocol read = stored_protocol(questioned().dump()).protocol;
  EXPECT_EQ(std::get<NumberForm>(read.questions.at("since").form).unit, "min");
  EXPECT_EQ(std::get<ScaleForm>(read.questions.at("strength").form).maximum, 10.0);
  ASSERT_TRUE(read.questions.at("kinds").condition);
  EXPECT_EQ(signs_of(*read.questions.at("kinds").condition), "strength ≥ 5");
}

}  // namespace
}  // namespace asperity
