// The chapter's recognition, rebuilt answer by answer from its printed counts, and other recognitions.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/chapter_studies.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Table 3 by sex: 7, 8 and 7 women, 9, 8 and 8 men recognise the texture among six pictures.
TEST(Recognition, ReproducesTheChaptersThirdTable) {
  constexpr std::array<int, 3> kWomen{7, 8, 7};
  constexpr std::array<int, 3> kMen{9, 8, 8};
  MadeUpStudy made;
  add_twenty_people(made);
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  for (int i = 0; i < 20; ++i) {
    std::vector<MadeUpTrial> trials{};
    for (std::size_t column = 0; column < 3; ++column) {
      const bool right = i < 10 ? i < kWomen[column] : i - 10 < kMen[column];
      trials.push_back(recognition("stone", right ? "stone" : "gravel"));
      trials.back().factors_json = in_column(static_cast<int>(column) + 1);
    }
    made.add_session(person(i), protocol, trials);
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  using Row = std::vector<Cell>;
  const auto n = [](std::int64_t count) { return Cell{count}; };
  EXPECT_THAT(
      table_of(outcome, "table_3").table.rows,
      ElementsAre(Row{"Female", n(7), n(8), n(7), n(22)}, Row{"Male", n(9), n(8), n(8), n(25)},
                  Row{"Total", n(16), n(16), n(15), n(47)}));
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_DOUBLE_EQ(number(shares, {"1", "Total"}, "chance"), 1.0 / 6.0);
  EXPECT_NEAR(number(shares, {"1", "Total"}, "clopper_pearson_low"), 0.56, 0.005);
  EXPECT_NEAR(number(shares, {"1", "Total"}, "p") / 8.7e-10, 1.0, 0.01);
  // A distractor is a column of the confusions even where nobody chose it.
  EXPECT_EQ(number(table_of(outcome, "confusion").table, {"stone"}, "grass"), 0);
  EXPECT_EQ(number(table_of(outcome, "confusion").table, {"stone"}, "gravel"), 13);
}

// Six pictures and a way out: who takes it has not recognised anything, and chance stays 1/6.
TEST(Recognition, CountsCannotTellAsNotRight) {
  MadeUpStudy made;
  made.add_person("a", "F");
  MadeUpTrial right = recognition("stone", "stone");
  MadeUpTrial undecided = recognition("stone", "cannot_tell");
  for (MadeUpTrial* trial : {&right, &undecided}) trial->options.push_back("cannot_tell");
  made.add_session("a", made.add_protocol("recognition", "recognition"), {right, undecided});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_DOUBLE_EQ(number(shares, {"all", "Total"}, "share"), 0.5);
  EXPECT_DOUBLE_EQ(number(shares, {"all", "Total"}, "chance"), 1.0 / 6.0);
  EXPECT_EQ(number(table_of(outcome, "confusion").table, {"stone"}, "cannot_tell"), 1);
}

// Two participants, of whom one never names a picture: their proportions are not the same.
TEST(Recognition, StatesThatOnlyOneParticipantNamedAPicture) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("recognition", "recognition", R"({"analysis": {"family": ["right"]}})");
  for (const auto& [label, answer] : {std::pair("a", "stone"), std::pair("b", "cannot_tell")}) {
    made.add_person(label, "F");
    MadeUpTrial one = recognition("stone", answer);
    one.options.push_back("cannot_tell");
    made.add_session(label, protocol, std::vector<MadeUpTrial>(4, one));
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_THAT(question_of(outcome, "right").answer.english(),
              testing::AllOf(testing::StartsWith("Only one participant named a picture: 100 % of "
                                                 "these responses were correct"),
                             HasSubstr("this cannot be tested with one participant.")));
  EXPECT_THAT(sentence_about(outcome, "right"), HasSubstr("could not be computed"));
}

TEST(Recognition, MapsOnlyWhatWasFelt) {
  const AnalysisOutcome outcome = analyze_recognitions();
  // 9 of 12 among six pictures.
  EXPECT_EQ(finding_of(outcome, "recognition", "pc").value, 0.75);
  EXPECT_GT(finding_of(outcome, "recognition", "dprime").value, 1.0);
  const Table& map = table_of(outcome, "map").table;
  ASSERT_EQ(map.rows.size(), 4U);
  const Table& tree = table_of(outcome, "tree").table;
  ASSERT_EQ(tree.rows.size(), 3U);
  EXPECT_EQ(std::get<std::string>(tree.rows[0][1]), "metal");
  EXPECT_EQ(std::get<std::string>(tree.rows[0][2]), "stone");
  EXPECT_THAT(outcome.remarks,
              testing::Contains(
                  says("(between textures that were presented: 3; pairs of textures that were "
                       "never confused: 5 of 6)")));
  EXPECT_EQ(finding_of(outcome, "similarity", "scm.p").word, "too_few_confusions");
  EXPECT_FALSE(finding_of(outcome, "similarity", "scm.G2").value.has_value());
  EXPECT_EQ(question_of(outcome, "confusions").answer.english(),
            "The textures confused most often are metal / stone: one with the other "
            "(responses: 3 of 8).");
  EXPECT_THAT(question_of(outcome, "information").answer.english(),
              HasSubstr("with so few responses"));
  EXPECT_NO_THROW(question_of(outcome, "right"));
  EXPECT_EQ(finding_of(outcome, "sexes", "pooled.k", "M").value, 5.0);
  // 4 of 6 and 5 of 6, by participant: what is tested is what is told.
  EXPECT_THAT(question_of(outcome, "sexes").answer.english(),
              HasSubstr("difference (women − men) −16.7 percentage points"));
  EXPECT_THAT(question_of(outcome, "information").answer.english(), HasSubstr("n = 12 responses."));
  EXPECT_EQ(question_of(outcome, "information").counted.english(), "12 responses");
}

/// Answers of one person, each after what was felt.
AnalysisOutcome analyze_answers(const std::vector<std::pair<std::string, std::string>>& answers) {
  MadeUpStudy made;
  made.add_person("a", "F");
  std::vector<MadeUpTrial> trials{};
  for (const auto& [felt, answer] : answers) trials.push_back(recognition(felt, answer));
  made.add_session("a", made.add_protocol("recognition", "recognition"), trials);
  return analyze_study(made.study()).front();
}

TEST(Recognition, SaysThatNothingWasTakenForAnotherWhereAllIsRight) {
  const AnalysisOutcome outcome = analyze_answers(
      {{"stone", "stone"}, {"metal", "metal"}, {"wood", "wood"}, {"brick", "brick"}});
  EXPECT_EQ(question_of(outcome, "confusions").answer.english(),
            "No texture was ever confused with another one that was presented.");
}

TEST(Recognition, NamesAllPairsThatAreConfusedEquallyOften) {
  const AnalysisOutcome outcome = analyze_answers({{"stone", "metal"},
                                                   {"metal", "metal"},
                                                   {"wood", "brick"},
                                                   {"brick", "brick"},
                                                   {"gravel", "gravel"}});
  EXPECT_EQ(question_of(outcome, "confusions").answer.english(),
            "The following pairs are confused equally often: brick / wood and metal / stone; one "
            "texture with the other in 50 % of the responses to the two textures of each pair.");
}

// A pair is told by both its directions; the commonest mistake of all may be another.
TEST(Recognition, TellsAConfusionInOneDirectionThatIsLargerThanThatOfEveryPair) {
  const AnalysisOutcome outcome = analyze_answers({{"stone", "metal"},
                                                   {"stone", "stone"},
                                                   {"metal", "metal"},
                                                   {"metal", "metal"},
                                                   {"brick", "gravel"},
                                                   {"brick", "gravel"},
                                                   {"brick", "brick"}});
  EXPECT_EQ(question_of(outcome, "confusions").answer.english(),
            "The textures confused most often are metal / stone: one with the other "
            "(responses: 1 of 4). Counted in one direction only, the most frequent confusion is "
            "brick identified as gravel (responses: 2 of 3).");
}

// Brick was called wood as often as gravel: the pair that is named already hides neither.
TEST(Recognition, NamesEveryMostFrequentConfusionInOneDirection) {
  const AnalysisOutcome outcome =
      analyze_answers({{"brick", "wood"}, {"brick", "gravel"}, {"wood", "wood"}, {"wood", "wood"}});
  EXPECT_EQ(
      question_of(outcome, "confusions").answer.english(),
      "Only brick / wood were presented: one was confused with the other (responses: 1 of 4). "
      "Counted in one direction only, these confusions are the most frequent: brick identified as "
      "gravel, brick identified as wood, each in 50 % of the responses to the texture presented.");
}

TEST(Recognition, NamesConfusionsInOneDirectionThatAreEquallyFrequent) {
  const AnalysisOutcome outcome = analyze_answers({{"stone", "metal"},
                                                   {"stone", "stone"},
                                                   {"metal", "metal"},
                                                   {"metal", "metal"},
                                                   {"brick", "gravel"},
                                                   {"brick", "brick"},
                                                   {"wood", "grass"},
                                                   {"wood", "grass"},
                                                   {"wood", "wood"},
                                                   {"wood", "wood"}});
  EXPECT_THAT(
      question_of(outcome, "confusions").answer.english(),
      testing::EndsWith(
          "Counted in one direction only, these confusions are the most frequent: "
          "brick identified as gravel, stone identified as metal, wood identified as grass, each "
          "in 50 % of the responses to the texture presented."));
}

// Of every texture everything is taken for something else: no pair is told by its letters.
TEST(Recognition, CountsThePairsWhereTooManyAreConfusedEquallyOften) {
  std::vector<std::pair<std::string, std::string>> answers{};
  for (const std::string& felt : kTextures) {
    for (const std::string& answer : kTextures) {
      if (felt != answer) answers.emplace_back(felt, answer);
    }
  }
  EXPECT_EQ(question_of(analyze_answers(answers), "confusions").answer.english(),
            "6 pairs of textures are confused equally often, and none more often: one texture with "
            "the other in 33 % of the responses to the two textures of each pair.");
}

// 5 and 6 of 6 are significant by t, and on the logit scale anything between 0 and 100 %.
TEST(Recognition, ClaimsNothingWhereTheIntervalContainsChance) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  for (const auto& [label, right] : {std::pair("a", 20), std::pair("b", 19)}) {
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (int i = 0; i < 20; ++i) {
      trials.push_back(recognition("metal", i < right ? "metal" : "stone"));
    }
    made.add_session(label, protocol, trials);
  }
  const std::string answer =
      question_of(analyze_study(made.study()).front(), "right").answer.english();
  EXPECT_THAT(answer, HasSubstr(", uncorrected"));
  EXPECT_THAT(answer, testing::StartsWith("On average "));
  EXPECT_THAT(answer, HasSubstr("Nothing is established: p is below .05, but the 95 % CI of the "
                                "mean contains the chance level"));
}

TEST(Recognition, StatesThatResponsesAreCorrectLessOftenThanByChance) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("recognition", "recognition", R"({"analysis": {"family": ["right"]}})");
  for (int i = 0; i < 8; ++i) {
    made.add_person(person(i), "F");
    std::vector<MadeUpTrial> trials(40, recognition("metal", "stone"));
    trials.front() = recognition("metal", i % 2 == 0 ? "metal" : "brick");
    made.add_session(person(i), protocol, trials);
  }
  EXPECT_THAT(question_of(analyze_study(made.study()).front(), "right").answer.english(),
              testing::StartsWith("No, significantly below chance: on average 1 %"));
}

// The chapter's matrix has its textures in the protocol's order, the same down and across.
TEST(Recognition, HasAConfusionMatrixWithADiagonal) {
  MadeUpStudy made;
  made.add_person("a", "F");
  const std::string source =
      R"({"blocks": {"main": {"question": {"pictures": ["stone", "wood", "brick", "metal", "grass"]}}}})";
  std::vector<MadeUpTrial> trials{recognition("wood", "cannot_tell"), recognition("stone", "grass"),
                                  recognition("metal", "metal"), recognition("brick", "stone")};
  for (MadeUpTrial& trial : trials) {
    trial.options = {"brick", "cannot_tell", "grass", "metal", "stone", "wood"};
  }
  made.add_session("a", made.add_protocol("recognition", "recognition", source), trials);
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& confusion = table_of(outcome, "confusion").table;
  EXPECT_THAT(confusion.columns,
              ElementsAre("felt", "stone", "wood", "brick", "metal", "grass", "cannot_tell"));
  std::vector<Cell> felt{};
  for (const std::vector<Cell>& row : confusion.rows) felt.push_back(row.front());
  EXPECT_THAT(felt, ElementsAre(Cell{"stone"}, Cell{"wood"}, Cell{"brick"}, Cell{"metal"}));
  EXPECT_EQ(number(confusion, {"wood"}, "cannot_tell"), 1);
  EXPECT_EQ(number(confusion, {"brick"}, "stone"), 1);
}

}  // namespace
}  // namespace asperity
