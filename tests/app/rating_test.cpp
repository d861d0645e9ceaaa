// Ratings on scales, from the rows of a study to means, agreement and tests.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTwoScales = R"({"kind": "rating", "blocks": {"only": {"questions": [
    {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 7, "points": 7}},
    {"name": "hard", "prompt": "How hard?", "scale": {"minimum": 1, "maximum": 7, "points": 7}}]},
  "last": {"kind": "recognition", "question": {"name": "which", "prompt": "Which?", "pictures": ["a", "b"]}}}})";

MadeUpTrial rated(const std::string& item, double rough, double hard) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(item, "height_map", item)};
  trial.questions = {"rough", "hard"};
  trial.answers = {std::to_string(static_cast<int>(rough)), std::to_string(static_cast<int>(hard))};
  return trial;
}

/// Three participants rate three items twice, and recognise one.
class Ratings : public testing::Test {
 protected:
  Ratings() {
    const std::int64_t protocol = made_.add_protocol("two_scales", "rating", kTwoScales);
    for (int person = 0; person < 3; ++person) {
      const std::string label = "p" + std::to_string(person + 1);
      made_.add_person(label, "");
      MadeUpTrial recognised{};
      recognised.block = "last";
      recognised.surfaces = {surface_of("a", "height_map", "a")};
      recognised.answers = {"a"};
      recognised.right = {person == 0 ? "b" : "a"};
      recognised.options = {"a", "b"};
      made_.add_session(
          label, protocol,
          {rated("wood", 1 + person, 4), rated("wood", 3 + person, 4), rated("metal", 4, 5),
           rated("metal", 4, 6), rated("stone", 6, 2), rated("stone", 7, 2), recognised});
    }
    outcomes_ = analyze_study(made_.study(), std::nullopt, {});
  }
  const AnalysisOutcome& outcome(const std::string& kind) const {
    return *std::find_if(outcomes_.begin(), outcomes_.end(),
                         [&kind](const AnalysisOutcome& each) { return each.kind == kind; });
  }

  MadeUpStudy made_{};
  std::vector<AnalysisOutcome> outcomes_{};
};

TEST_F(Ratings, AreAnalysedApartFromTheOtherTaskOfTheSession) {
  ASSERT_EQ(outcomes_.size(), 2U);
  EXPECT_EQ(outcome("rating").count.planned_trials, 18U);
  EXPECT_EQ(outcome("recognition").count.planned_trials, 3U);
  EXPECT_EQ(outcome("recognition").answers, 3U);
}

TEST_F(Ratings, AreAveragedWithinAndThenOverParticipants) {
  const FoundNumbers found(outcome("rating").findings);
  // Rough: the participants' own means of wood are 2, 3 and 4; of stone 6.5 each.
  EXPECT_DOUBLE_EQ(found.value("mean.score", "rough|wood").value(), 3.0);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "rough|stone").value(), 6.5);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "hard|metal").value(), 5.5);
  // t(2) = 4.302653, SD 1: 3 ± 4.302653 / √3.
  EXPECT_NEAR(found.find("mean.score", "rough|wood")->low.value(), 3.0 - 4.302653 / std::sqrt(3.0),
              1e-6);
}

TEST_F(Ratings, AreTestedOnEveryScale) {
  const FoundNumbers found(outcome("rating").findings);
  // Hard: every participant ranks stone < wood < metal, so that χ² = n(k − 1) and W = 1.
  EXPECT_DOUBLE_EQ(found.value("friedman.chisq", "hard").value(), 6.0);
  EXPECT_DOUBLE_EQ(found.value("kendall.W", "hard").value(), 1.0);
  EXPECT_NEAR(found.value("friedman.p", "hard").value(), std::exp(-3.0), 1e-12);
  // Rough: ranks of wood 1, 1, 1.5, of metal 2, 2, 1.5, of stone 3, with one tie.
  EXPECT_DOUBLE_EQ(found.value("mean.rank", "rough|stone").value(), 3.0);
  EXPECT_NEAR(found.value("mean.rank", "rough|wood").value(), 3.5 / 3.0, 1e-12);
}

TEST_F(Ratings, HaveTablesAndAQuestionForEachScale) {
  const AnalysisOutcome& ratings = outcome("rating");
  const auto table = [&ratings](const std::string& name) {
    return std::find_if(ratings.tables.begin(), ratings.tables.end(),
                        [&name](const NamedTable& each) { return each.name == name; });
  };
  ASSERT_NE(table("ratings"), ratings.tables.end());
  EXPECT_EQ(table("ratings")->table.rows.size(), 6U);
  // Both from 1 to 7 in 7 points, without labels.
  ASSERT_NE(table("scales"), ratings.tables.end());
  const std::vector<std::vector<Cell>>& scales = table("scales")->table.rows;
  ASSERT_EQ(scales.size(), 2U);
  EXPECT_EQ(scales[1], (std::vector<Cell>{std::string("hard"), std::int64_t{1}, Cell{},
                                          std::int64_t{7}, Cell{}, std::int64_t{7}}));
  ASSERT_NE(table("agreement"), ratings.tables.end());
  EXPECT_EQ(table("agreement")->table.rows.size(), 10U);
  ASSERT_EQ(ratings.questions.size(), 2U);
  EXPECT_THAT(ratings.questions[0].question.english(), HasSubstr("rough"));
  EXPECT_THAT(ratings.questions[1].answer.english(), HasSubstr("highest for metal, 5.50"));
  EXPECT_THAT(ratings.questions[1].answer.english(), HasSubstr("lowest for stone, 2.00"));
}

/// Six participants rate stone above wood on one scale, in a session that also has a recognition.
std::vector<AnalysisOutcome> six_who_agree(const std::string& analysis) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("agreed", "rating",
                                                  R"({"kind": "rating", "blocks": {
    "only": {"question": {"name": "rough", "prompt": "How rough?", "scale": {"points": 7}}},
    "last": {"kind": "recognition", "question": {"name": "which", "prompt": "Which?", "pictures": ["a", "b"]}}},
    "analysis": )" + analysis + "}");
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    const auto rated_rough = [](const std::string& item, const std::string& point) {
      MadeUpTrial trial{};
      trial.surfaces = {surface_of(item, "height_map", item)};
      trial.questions = {"rough"};
      trial.answers = {point};
      return trial;
    };
    MadeUpTrial recognised{};
    recognised.block = "last";
    recognised.surfaces = {surface_of("a", "height_map", "a")};
    recognised.answers = {"a"};
    recognised.right = {"a"};
    recognised.options = {"a", "b"};
    made.add_session(label, protocol,
                     {rated_rough("wood", std::to_string(1 + person % 2)),
                      rated_rough("stone", std::to_string(5 + person % 2)), recognised});
  }
  return analyze_study(made.study(), std::nullopt, {});
}

const AnalysisOutcome& outcome_of_kind(const std::vector<AnalysisOutcome>& outcomes,
                                       const std::string& kind) {
  return *std::find_if(outcomes.begin(), outcomes.end(),
                       [&kind](const AnalysisOutcome& each) { return each.kind == kind; });
}

TEST(RatedPairs, AreReportedInTheirDirection) {
  const auto outcomes = six_who_agree(R"({"family": ["rated_pairs"]})");
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const auto sentence =
      std::find_if(ratings.test_sentences.begin(), ratings.test_sentences.end(),
                   [](const TestSentence& each) { return each.test == "rated_pairs"; });
  ASSERT_NE(sentence, ratings.test_sentences.end());
  // The pair is stone|wood, in the order of the names.
  EXPECT_THAT(sentence->text, HasSubstr("stone was rated significantly higher than wood"));
}

TEST(DeclaredFamily, IsThatOfTheKindWhoseTestsItNames) {
  const auto outcomes = six_who_agree(R"({"family": ["right"]})");
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const AnalysisOutcome& recognition = outcome_of_kind(outcomes, "recognition");
  EXPECT_EQ(recognition.family, FamilyDeclaration::declared);
  EXPECT_EQ(ratings.family, FamilyDeclaration::of_other_kinds);
  const auto tests = std::find_if(ratings.tables.begin(), ratings.tables.end(),
                                  [](const NamedTable& each) { return each.name == "tests"; });
  ASSERT_NE(tests, ratings.tables.end());
  EXPECT_THAT(tests->note.english(), HasSubstr("only tests of its other tasks"));
  EXPECT_THAT(tests->note.english(), testing::Not(HasSubstr("declares no family")));
}

}  // namespace
}  // namespace asperity
