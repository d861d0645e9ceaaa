// Labels and answers of people.

#include "app/records/participant_answers.h"

#include <gtest/gtest.h>

#include "app/session/respondents/typed_answer.h"
#include "tests/support/questions.h"
namespace asperity {
namespace {

std::vector<ParticipantRow> people(const std::vector<std::string>& labels) {
  std::vector<ParticipantRow> rows{};
  for (const std::string& label : labels) {
    rows.push_back({.label = label, .is_virtual = label.starts_with("virtual")});
  }
  return rows;
}

/// How the typed text is stored.
FormAnswer typed(const Question& question, const std::string& text) {
  return stored(question, std::get<std::optional<Answer>>(typed_answer(question, text)));
}
bool is_refused(const Question& question, const std::string& text) {
  return std::holds_alternative<ParticipantMessage>(typed_answer(question, text));
}

TEST(TypedAnswer, IsTheValueOfAnOptionWhoseTextWasTyped) {
  const Question question{
      .options = {{.value = "right", .text = "rechts"}, {.value = "left", .text = "links"}}};
  EXPECT_EQ(typed(question, "links"), FormAnswer{"left"});
  EXPECT_EQ(typed(question, "left"), FormAnswer{"left"});
  EXPECT_EQ(typed(question, "1"), FormAnswer{"right"});
  EXPECT_TRUE(is_refused(question, "beide"));
}

TEST(TypedAnswer, IsHeldToTheFormOfTheQuestion) {
  Question question{.name = "asked", .options = in_words({"a", "b", "c"})};
  EXPECT_TRUE(is_refused(question, "4"));
  question.form = MultipleChoiceForm{};
  EXPECT_EQ(typed(question, "3, 1"), (FormAnswer{"a", "c"}));
  EXPECT_TRUE(is_refused(question, "1 4"));
  question.form = ScaleForm{.minimum = 1, .maximum = 7, .points = 7};
  EXPECT_EQ(typed(question, " 5 "), FormAnswer{"5"});
  EXPECT_TRUE(is_refused(question, "5.5"));
  question.form = NumberForm{.is_estimate = true};
  EXPECT_EQ(typed(question, "0,5"), FormAnswer{"0.5"});
  EXPECT_TRUE(is_refused(question, "0"));
  EXPECT_TRUE(is_refused(question, "1,000"));
  question.form = NumberForm{};
  EXPECT_EQ(typed(question, "-3"), FormAnswer{"-3"});
  question.form = LineForm{};
  EXPECT_EQ(typed(question, std::string(25, '-')), FormAnswer{"0.4"});
  EXPECT_TRUE(is_refused(question, std::string(51, '-')));
  question.form = TextForm{};
  EXPECT_EQ(typed(question, " it hurts "), FormAnswer{"it hurts"});
  for (const AnswerForm& form :
       {AnswerForm{ChoiceForm{}}, AnswerForm{MultipleChoiceForm{}}, AnswerForm{ScaleForm{}},
        AnswerForm{NumberForm{}}, AnswerForm{LineForm{}}, AnswerForm{TextForm{}}}) {
    question.form = form;
    question.optional = false;
    EXPECT_TRUE(is_refused(question, "")) << name_of(form);
    question.optional = true;
    EXPECT_EQ(typed(question, ""), FormAnswer{}) << name_of(form);
  }
}

TEST(SuggestedLabel, ContinuesThePatternOfTheStudy) {
  EXPECT_EQ(suggested_label(people({})), "sub001");
  EXPECT_EQ(suggested_label(people({"P008", "P009"})), "P010");
  EXPECT_EQ(suggested_label(people({"sub999"})), "sub1000");
  EXPECT_EQ(suggested_label(people({"7"})), "8");
  EXPECT_EQ(suggested_label(people({"anna"})), "sub001");
  EXPECT_EQ(suggested_label(people({"pilot01", "P001", "P002"})), "P003");
}

TEST(SuggestedLabel, PassesOverVirtualParticipants) {
  EXPECT_EQ(suggested_label(people({"virtual0001", "virtual0002"})), "sub001");
  EXPECT_EQ(next_virtual_label(people({"virtual0001", "virtual0002", "P009"})), "virtual0003");
  EXPECT_EQ(next_virtual_label(people({})), "virtual0001");
}

TEST(AnswerOfAParticipant, IsHeldToItsQuestion) {
  const Question age{.prompt = "How old are you?",
                     .form = NumberForm{.minimum = 18, .maximum = 120}};
  EXPECT_FALSE(complaint_about_answer(age, "18"));
  EXPECT_EQ(complaint_about_answer(age, ""),
            "\"How old are you?\" has not been answered; enter an answer.");
  EXPECT_EQ(complaint_about_answer(age, "17.5"),
            "The answer to \"How old are you?\" must be 18 or more.");
  EXPECT_TRUE(complaint_about_answer(age, "121"));
  EXPECT_TRUE(complaint_about_answer(age, "old"));
  const Question hand{.prompt = "Which hand?", .options = in_words({"left", "right"})};
  EXPECT_FALSE(complaint_about_answer(hand, "left"));
  EXPECT_TRUE(complaint_about_answer(hand, "both"));
  const Question free_text{.prompt = "Else?", .form = TextForm{}, .optional = true};
  EXPECT_FALSE(complaint_about_answer(free_text, ""));
}

TEST(AnswerOfAParticipant, MayHaveADecimalComma) {
  EXPECT_EQ(with_decimal_point("1,75"), "1.75");
  EXPECT_EQ(with_decimal_point("1.75"), "1.75");
  EXPECT_EQ(with_decimal_point("1,750"), "1,750") << "thousands, perhaps";
  EXPECT_EQ(with_decimal_point("1,7,5"), "1,7,5");
  EXPECT_EQ(with_decimal_point("tall, I think"), "tall, I think");
  const Question height{.prompt = "How tall are you, m?",
                        .form = NumberForm{.minimum = 1, .maximum = 3}};
  EXPECT_EQ(typed(height, "1,75"), FormAnswer{"1.75"}) << "as it is stored";
  EXPECT_TRUE(is_refused(height, "1,750"));
}

TEST(PersonWithAnswers, HasThemWhereTheStoreKeepsThem) {
  Protocol protocol{};
  for (const char* name : {"age", "sex", "handedness", "hand_used", "remarks"}) {
    protocol.participant_questions.emplace_back(name);
    protocol.questions[name].name = name;
  }
  const ParticipantRow person =
      person_of("P001", protocol,
                {{"age", "31"}, {"sex", "female"}, {"handedness", "either"}, {"hand_used", "left"}},
                "2026-03-01T09:00:00Z");
  EXPECT_EQ(person.label, "P001");
  EXPECT_EQ(person.age_years, 31.0);
  EXPECT_EQ(person.sex, "F");
  EXPECT_EQ(person.handedness, "ambidextrous");
  EXPECT_EQ(person.answers_json, R"({"hand_used":"left"})");
  EXPECT_EQ(person.created_utc, "2026-03-01T09:00:00Z");
  EXPECT_TRUE(uses_left_hand(person));
}

TEST(PersonWithAnswers, HoldsTheHandleAsTheyWriteUnlessTheySayOtherwise) {
  EXPECT_TRUE(uses_left_hand({.handedness = "left"}));
  EXPECT_FALSE(uses_left_hand({.handedness = "right"}));
  EXPECT_FALSE(uses_left_hand({.handedness = "left", .answers_json = R"({"hand_used":"right"})"}));
  EXPECT_FALSE(uses_left_hand({}));
}

}  // namespace
}  // namespace asperity
