// Ratings on scales, from the rows of a study to means, agreement and tests.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"
#include "tests/app/coverage_counts.h"

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
  EXPECT_EQ(table_of(ratings, "ratings").table.rows.size(), 6U);
  // Both from 1 to 7 in 7 points, without labels.
  const std::vector<std::vector<Cell>>& scales = table_of(ratings, "scales").table.rows;
  ASSERT_EQ(scales.size(), 2U);
  EXPECT_EQ(scales[1], (std::vector<Cell>{std::string("hard"), std::int64_t{1}, Cell{},
                                          std::int64_t{7}, Cell{}, std::int64_t{7}}));
  EXPECT_EQ(table_of(ratings, "agreement").table.rows.size(), 8U);  // two scales, four correlations
  ASSERT_EQ(ratings.questions.size(), 2U);
  EXPECT_THAT(ratings.questions[0].question.english(), HasSubstr("rough"));
  EXPECT_THAT(ratings.questions[1].answer.english(), HasSubstr("highest for metal, 5.50"));
  EXPECT_THAT(ratings.questions[1].answer.english(), HasSubstr("lowest for stone, 2.00"));
}

// Eleven participants rate a one point above b, and one 50 points below it: by ranks p = .033 for a, and the mean of b is higher.
TEST(RatedPairs, EstablishNothingWhereRanksAndMeansDisagree) {
  const AnalysisOutcome outcome =
      analysed("rating", R"({"kind": "rating", "blocks": {"only": {"question": {"name": "rough",
      "prompt": "How rough?", "scale": {"minimum": 0, "maximum": 100}}}},
      "analysis": {"family": ["rated_pairs"]}})",
               {.number = 12}, [](int person) {
                 std::vector<MadeUpTrial> trials{};
                 for (const auto& [item, rating] :
                      {std::pair("a", person == 11 ? "0" : "51"), std::pair("b", "50")}) {
                   MadeUpTrial trial{};
                   trial.surfaces = {surface_of(item, "height_map", item)};
                   trial.questions = {"rough"};
                   trial.answers = {rating};
                   trials.push_back(trial);
                 }
                 return trials;
               });
  EXPECT_THAT(sentence_about(outcome, "rated_pairs"),
              testing::AllOf(testing::StartsWith("It was not established that the item a was rated "
                                                 "higher than b"),
                             HasSubstr("the means do not differ in the direction of the test")));
}

/// Four participants rate one grating at two amplitudes and two wavelengths, whose levels the protocol crosses.
AnalysisOutcome rated_levels(const std::string& stimulus) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("levels", "rating", R"({"kind": "rating",
    "factors": {"amplitude_m": {"levels": [0.0001, 0.00005]}, "wavelength_m": {"levels": [0.01, 0.0025]},
                "go": {"levels": [1, 2]}},
    "stimuli": {"grating": )" + stimulus + R"(},
    "blocks": {"only": {"crossed": ["amplitude_m", "wavelength_m", "go"],
                        "presented": [{"stimulus": "grating"}],
                        "question": {"name": "rough", "prompt": "How rough?", "scale": {"points": 7}}}}})");
  for (int person = 0; person < 4; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials{};
    for (const char* const levels : {R"("amplitude_m": 5e-05, "wavelength_m": 0.0025)",
                                     R"("amplitude_m": 5e-05, "wavelength_m": 0.01)",
                                     R"("amplitude_m": 0.0001, "wavelength_m": 0.0025)",
                                     R"("amplitude_m": 0.0001, "wavelength_m": 0.01)"}) {
      for (int go = 1; go <= 2; ++go) {
        MadeUpTrial trial{};
        trial.factors_json = std::string("{") + levels + ", \"go\": " + std::to_string(go) + "}";
        trial.surfaces = {surface_of("sinusoid", "sinusoid", "")};
        trial.questions = {"rough"};
        trial.answers = {
            std::to_string(1 + trials.size() / 2 + static_cast<std::size_t>(person % 2))};
        trials.push_back(trial);
      }
    }
    made.add_session(label, protocol, trials);
  }
  return analyze_study(made.study(), std::nullopt, {}).front();
}

TEST(RatedLevels, AreTheItemsWhereAllSurfacesCountAsOne) {
  const AnalysisOutcome outcome = rated_levels(
      R"({"model": "sinusoid", "parameters": {"amplitude_m": {"factor": "amplitude_m"}, "wavelength_m": {"factor": "wavelength_m"}}})");
  const FoundNumbers found(outcome.findings);
  EXPECT_DOUBLE_EQ(
      found.value("mean.score", "rough|amplitude_m 5e-05, wavelength_m 0.0025").value(), 1.5);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "rough|amplitude_m 1e-04, wavelength_m 0.01").value(),
                   4.5);
  ASSERT_EQ(outcome.tables.front().name, "ratings");
  std::vector<std::string> items{};
  for (const auto& row : table_of(outcome, "ratings").table.rows) {
    items.push_back(std::get<std::string>(row[1]));
  }
  EXPECT_THAT(items, testing::ElementsAre("amplitude_m 5e-05, wavelength_m 0.0025",
                                          "amplitude_m 5e-05, wavelength_m 0.01",
                                          "amplitude_m 1e-04, wavelength_m 0.0025",
                                          "amplitude_m 1e-04, wavelength_m 0.01"))
      << "by value, and without the factor that is no property of the surface";
  EXPECT_THAT(outcome.questions.front().answer.english(),
              HasSubstr("highest for amplitude 100 µm, wavelength 10 mm, 4.50"));
}

TEST(RatedLevels, AreNotItemsWhereTheyDoNotDetermineTheSurface) {
  const AnalysisOutcome outcome = rated_levels(R"({"model": "sinusoid"})");
  EXPECT_TRUE(FoundNumbers(outcome.findings).find("friedman.p", "rough") == nullptr);
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
  EXPECT_THAT(sentence->text,
              testing::StartsWith("The item stone was rated significantly higher than wood: "));
  // Of three participants each, stone 5 and 6, wood 1 and 2.
  EXPECT_THAT(sentence->text, HasSubstr("; means: 5.50 (95 % CI ["));
  EXPECT_THAT(sentence->text, HasSubstr(") for stone and 1.50 (95 % CI ["));
}

TEST(RatedPairs, StateHowManyEqualRatingsWereLeftOut) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("two_scales", "rating", kTwoScales);
  for (int person = 0; person < 7; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    // Two participants rate both items as equally hard.
    made.add_session(label, protocol,
                     {rated("wood", 1 + person % 2, 2), rated("stone", 6, person < 2 ? 2 : 5)});
  }
  const auto outcomes = analyze_study(made.study(), std::nullopt, {});
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const auto sentence = std::find_if(ratings.test_sentences.begin(), ratings.test_sentences.end(),
                                     [](const TestSentence& each) {
                                       return each.about == TestSubject{"stone", "wood", "hard"};
                                     });
  ASSERT_NE(sentence, ratings.test_sentences.end());
  // Exploratory, and therefore without a claim: p = 2/2⁵ of the five others, who agree.
  EXPECT_THAT(sentence->text,
              testing::StartsWith("In an exploratory test, the ratings of stone and wood "
                                  "on the scale “hard” were not significantly different: "));
  EXPECT_THAT(sentence->text,
              HasSubstr("N = 5 (two with a difference of zero left out), p = .062"));
}

// The p of one difference can only be 1.
TEST(RatedPairs, AreNotTestedWhereOnlyOneParticipantHasADifference) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("two_scales", "rating", kTwoScales);
  for (int person = 0; person < 5; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    made.add_session(label, protocol,
                     {rated("wood", 1 + person % 2, 2), rated("stone", 6, person == 0 ? 5 : 2)});
  }
  const auto outcomes = analyze_study(made.study(), std::nullopt, {});
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const auto sentence = std::find_if(ratings.test_sentences.begin(), ratings.test_sentences.end(),
                                     [](const TestSentence& each) {
                                       return each.about == TestSubject{"stone", "wood", "hard"};
                                     });
  ASSERT_NE(sentence, ratings.test_sentences.end());
  EXPECT_TRUE(sentence->is_untested);
  EXPECT_THAT(sentence->text, HasSubstr("only one participant has a difference that is not zero"));
  EXPECT_FALSE(sentence->p);
}

TEST(DeclaredFamily, IsThatOfTheKindWhoseTestsItNames) {
  const auto outcomes = six_who_agree(R"({"family": ["right"]})");
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const AnalysisOutcome& recognition = outcome_of_kind(outcomes, "recognition");
  EXPECT_EQ(recognition.family, FamilyDeclaration::declared);
  EXPECT_EQ(ratings.family, FamilyDeclaration::of_other_kinds);
  const StoredTable& tests = table_of(ratings, "tests");
  EXPECT_THAT(tests.note.english(), HasSubstr("only tests of its other tasks"));
  EXPECT_THAT(tests.note.english(), testing::Not(HasSubstr("declares no family")));
}

/// A recognition with a rating of confidence, and ratings of roughness in a separate block.
constexpr const char* kWithConfidence = R"({"kind": "recognition", "blocks": {
  "only": {"questions": [
    {"name": "which", "prompt": "Which?", "pictures": ["a", "b"]},
    {"name": "sure", "prompt": "How sure?", "scale": {"minimum": 0, "maximum": 100}}]},
  "attributes": {"kind": "rating", "questions": [
    {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 7, "points": 7}},
    {"name": "hard", "prompt": "How hard?", "scale": {"minimum": 1, "maximum": 7, "points": 7}}]}},
  "analysis": FAMILY})";
/// The same without the attributes.
constexpr const char* kOnlyConfidence = R"({"kind": "recognition", "blocks": {
  "only": {"questions": [
    {"name": "which", "prompt": "Which?", "pictures": ["a", "b"]},
    {"name": "sure", "prompt": "How sure?", "scale": {"minimum": 0, "maximum": 100}}]}},
  "analysis": FAMILY})";

MadeUpTrial recognised_with(const std::string& felt, const std::string& chosen, double sure) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(felt, "height_map", felt)};
  trial.questions = {"which", "sure"};
  trial.answers = {chosen, std::to_string(static_cast<int>(sure))};
  trial.right = {felt};
  trial.options = {"a", "b"};
  return trial;
}

/// Four participants: the first three are surer of their correct responses by 20, 30 and 40, and the
/// last has no incorrect response.
AnalysisOutcome ratings_with_confidence(std::string source, const std::string& family) {
  source.replace(source.find("FAMILY"), std::string("FAMILY").size(), family);
  const bool has_attributes = source.find("attributes") != std::string::npos;
  const auto trials_of = [&](int person) {
    std::vector<MadeUpTrial> trials{recognised_with("a", "a", 70), recognised_with("b", "b", 90)};
    trials.push_back(person == 3 ? recognised_with("b", "b", 80)
                                 : recognised_with("b", "a", 60 - 10 * person));
    for (const char* const item : {"a", "b", "c"}) {
      MadeUpTrial attributes = rated(item, 1 + (person + *item) % 3, 2 + (*item - 'a'));
      attributes.block = "attributes";
      if (has_attributes) trials.push_back(attributes);
    }
    return trials;
  };
  MadeUpStudy made{};
  add_participants(made, made.add_protocol("sure", "recognition", source),
                   {.number = 4, .first = 1}, trials_of);
  return outcome_of_kind(analyze_study(made.study()), "rating");
}

TEST(AccompanyingScale, IsReportedByTheCorrectnessOfTheResponse) {
  const AnalysisOutcome ratings =
      ratings_with_confidence(kOnlyConfidence, R"({"family": ["right"]})");
  const FoundNumbers found(ratings.findings);
  // Means of correct responses: 80 for everyone; of incorrect ones 60, 50 and 40.
  EXPECT_DOUBLE_EQ(found.value("mean.score", "sure|which|correctness|correct").value(), 80.0);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "sure|which|correctness|incorrect").value(), 50.0);
  EXPECT_EQ(found.find("mean.score", "sure|which|correctness|incorrect")->n, 3U);
  // The answer compares the three participants who have both, whose difference is tested.
  for (const char* const key : {"sure|which|correct", "sure|which|incorrect"}) {
    ASSERT_NE(found.find("mean.score.compared", key), nullptr) << key;
    EXPECT_EQ(found.find("mean.score.compared", key)->n, 3U) << key;
  }
  // By presented item: b is rated 75, 70, 65 and 85.
  EXPECT_DOUBLE_EQ(found.value("mean.score", "sure|which|presented|b").value(), 73.75);
  // Differences 20, 30 and 40: mean 30, SD 10, t = 30 / (10 / √3), d = 3.
  EXPECT_DOUBLE_EQ(found.value("diff", "sure|which").value(), 30.0);
  EXPECT_NEAR(found.find("diff", "sure|which")->low.value(),
              30.0 - 4.302653 * 10.0 / std::sqrt(3.0), 1e-5);
  const StoredTable* const table = find_table(ratings, "accompanying");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->table.rows.size(), 6U);  // all, correct, incorrect, difference, a, b
  const StoredTable* const tests = find_table(ratings, "tests");
  ASSERT_NE(tests, nullptr);
  ASSERT_EQ(tests->table.rows.size(), 1U);
  ASSERT_EQ(ratings.test_sentences.size(), 1U);
  EXPECT_EQ(ratings.test_sentences[0].role, TestRole::exploratory);
  EXPECT_THAT(ratings.test_sentences[0].text,
              HasSubstr("t(2) = 5.20, N = 3 (one left out), p = .035"));
  EXPECT_THAT(tests->note.english(), HasSubstr("1 of 4"));
  ASSERT_EQ(ratings.questions.size(), 1U);
  EXPECT_THAT(ratings.questions[0].answer.english(), HasSubstr("80.00"));
  EXPECT_THAT(ratings.transformation,
              HasSubstr("the trials with correct and over those with incorrect responses"));
  EXPECT_THAT(ratings.transformation, testing::Not(HasSubstr("of an item")));
  EXPECT_THAT(ratings.questions[0].answer.english(), HasSubstr("exploratory"));
}

TEST(AccompanyingScale, IsNotAnalysedAsAnAttributeOfItems) {
  const AnalysisOutcome ratings =
      ratings_with_confidence(kWithConfidence, R"({"family": ["ratings", "right"]})");
  const StoredTable* const means = find_table(ratings, "ratings");
  ASSERT_NE(means, nullptr);
  for (const char* const name : {"ratings", "agreement", "components"}) {
    const StoredTable* const table = find_table(ratings, name);
    ASSERT_NE(table, nullptr) << name;
    for (const auto& row : table->table.rows) {
      for (const Cell& cell : row) EXPECT_NE(cell, Cell(std::string("sure"))) << name;
    }
  }
  // The family has two tests: one for each attribute.
  EXPECT_EQ(std::count_if(ratings.test_sentences.begin(), ratings.test_sentences.end(),
                          [](const auto& each) { return each.role == TestRole::confirmatory; }),
            2);
  for (const TestSentence& each : ratings.test_sentences) {
    EXPECT_TRUE(each.role != TestRole::confirmatory || each.about.of != "sure") << each.text;
  }
  EXPECT_NE(find_table(ratings, "accompanying"), nullptr);
  // The scales as shown, including that of the confidence.
  EXPECT_EQ(find_table(ratings, "scales")->table.rows.size(), 3U);
}

TEST(AccompanyingScale, IsAnalysedAsRatingsWhereTheFamilyNamesTheirTest) {
  const AnalysisOutcome ratings =
      ratings_with_confidence(kOnlyConfidence, R"({"family": ["ratings"]})");
  EXPECT_NE(find_table(ratings, "ratings"), nullptr);
  EXPECT_NE(find_table(ratings, "agreement"), nullptr);
}

TEST(AccompanyingScale, IsTestedInTheFamilyThatNamesItsTest) {
  const AnalysisOutcome ratings =
      ratings_with_confidence(kOnlyConfidence, R"({"family": ["right", "accompanying_scales"]})");
  EXPECT_EQ(find_table(ratings, "ratings"), nullptr);
  ASSERT_EQ(ratings.test_sentences.size(), 1U);
  EXPECT_EQ(ratings.test_sentences[0].role, TestRole::confirmatory);
  EXPECT_THAT(ratings.test_sentences[0].text,
              HasSubstr("significantly higher with correct than with incorrect responses"));
  EXPECT_THAT(ratings.test_sentences[0].text, HasSubstr("; means: 80.00"));
}

// The family compares the groups in the recognition that the scale accompanies.
TEST(AccompanyingScale, IsNotComparedBetweenGroups) {
  const AnalysisOutcome ratings =
      ratings_with_confidence(kOnlyConfidence, R"({"family": ["right", "groups"]})");
  for (const TestSentence& sentence : ratings.test_sentences) {
    EXPECT_NE(sentence.test, "groups") << sentence.text;
  }
}

TEST(AccompanyingScale, IsReportedByTheChosenItemWhereNoResponseIsCorrect) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("sure", "selection", R"({"kind": "selection",
    "blocks": {"only": {"questions": [
      {"name": "best", "prompt": "Which is best?"},
      {"name": "sure", "prompt": "How sure?", "scale": {"minimum": 0, "maximum": 100}}]}}})");
  for (int person = 0; person < 3; ++person) {
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    const auto chosen = [](const std::string& item, const std::string& sure) {
      MadeUpTrial trial{};
      trial.surfaces = {surface_of("x", "x", "t"), surface_of("y", "y", "t")};
      trial.questions = {"best", "sure"};
      trial.answers = {item, sure};
      trial.options = {"x", "y"};
      return trial;
    };
    made.add_session(label, protocol, {chosen("x", "80"), chosen("y", "40")});
  }
  const auto outcomes = analyze_study(made.study(), std::nullopt, {});
  const AnalysisOutcome& ratings = outcome_of_kind(outcomes, "rating");
  const FoundNumbers found(ratings.findings);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "sure|best|chosen|x").value(), 80.0);
  EXPECT_DOUBLE_EQ(found.value("mean.score", "sure|best|chosen|y").value(), 40.0);
  EXPECT_EQ(find_table(ratings, "tests"), nullptr);
  EXPECT_EQ(find_table(ratings, "ratings"), nullptr);
}

/// A participant's rating of an item on the scale `rough`, and on `smooth` where it is given.
MadeUpTrial rated_on(const std::string& item, const std::string& rough,
                     const std::string& smooth = {}, int repetition = 1) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(item, "height_map", item)};
  trial.questions = {"rough"};
  trial.answers = {rough};
  trial.repetition = repetition;
  if (!smooth.empty()) {
    trial.questions.push_back("smooth");
    trial.answers.push_back(smooth);
  }
  return trial;
}

AnalysisOutcome analysed_ratings(const std::string& source,
                                 const std::vector<std::vector<MadeUpTrial>>& participants) {
  return analysed("rating", source, {.first = 1}, participants);
}

std::string two_scales_with(const std::string& analysis) {
  return R"({"kind": "rating", "blocks": {"only": {"questions": [
    {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 7, "points": 7}},
    {"name": "smooth", "prompt": "How smooth?", "scale": {"minimum": 1, "maximum": 7, "points": 7}}]}},
    "analysis": )" +
         analysis + "}";
}

TEST(Construct, HasTheAlphaOfItsScalesAfterReflection) {
  // Rough 1, 3, 5, 7 and 8 − smooth 2, 2, 6, 6: variances 20/3 and 16/3, of the sums 68/3;
  // α = 2·(1 − 36/68) = 16/17.
  const std::vector<std::vector<MadeUpTrial>> people{
      {rated_on("wood", "1", "6"), rated_on("stone", "5", "2")},
      {rated_on("wood", "3", "6"), rated_on("stone", "7", "2")}};
  const AnalysisOutcome outcome = analysed_ratings(
      two_scales_with(R"({"constructs": {"roughness": {"scales": ["rough", "smooth"],
                                                       "reverse_keyed": ["smooth"]}}})"),
      people);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(found.value("cronbach.alpha", "roughness").value(), 16.0 / 17.0, 1e-12);
  const StoredTable* const table = find_table(outcome, "constructs");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->table.rows.at(0).at(2), Cell(std::string("smooth")));
  EXPECT_EQ(table->table.rows.at(0).at(4), Cell(std::int64_t{4}));
  EXPECT_THAT(answer_to(outcome, "construct_roughness"), HasSubstr("α = .94"));
  EXPECT_THAT(answer_to(outcome, "construct_roughness"),
              HasSubstr("rough, smooth (reverse-keyed: smooth)"));
}

// Rough 1, 5, 3, 7 and smooth 6, 2, 6, 2, not reflected: variances 20/3 and 16/3, of the sums 4/3; α = 2·(1 − 9) = −16.
TEST(Construct, OfOppositeScalesAsksWhichAreReverseKeyed) {
  const AnalysisOutcome outcome = analysed_ratings(
      two_scales_with(R"({"constructs": {"roughness": {"scales": ["rough", "smooth"]}}})"),
      {{rated_on("wood", "1", "6"), rated_on("stone", "5", "2")},
       {rated_on("wood", "3", "6"), rated_on("stone", "7", "2")}});
  EXPECT_NEAR(FoundNumbers(outcome.findings).value("cronbach.alpha", "roughness").value(), -16.0,
              1e-12);
  EXPECT_THAT(answer_to(outcome, "construct_roughness"),
              HasSubstr("check which of them are reverse-keyed"));
}

TEST(Construct, IsNotMadeOfParticipants) {
  const std::vector<std::vector<MadeUpTrial>> people{
      {rated_on("wood", "1", "6"), rated_on("stone", "5", "2"), rated_on("cork", "2", "3")},
      {rated_on("wood", "3", "6"), rated_on("stone", "7", "2"), rated_on("cork", "2", "4")}};
  const AnalysisOutcome outcome = analysed_ratings(two_scales_with("{}"), people);
  EXPECT_EQ(FoundNumbers(outcome.findings).all("cronbach.alpha").size(), 0U);
  EXPECT_EQ(find_table(outcome, "constructs"), nullptr);
  EXPECT_NE(FoundNumbers(outcome.findings).find("icc", "rough|ICC2k"), nullptr);
}

TEST(Agreement, HasAStatusWithTwoItems) {
  const std::vector<std::vector<MadeUpTrial>> people{
      {rated_on("wood", "1", "6"), rated_on("stone", "5", "2")},
      {rated_on("wood", "3", "6"), rated_on("stone", "7", "2")}};
  const AnalysisOutcome outcome = analysed_ratings(two_scales_with("{}"), people);
  const FoundNumbers found(outcome.findings);
  EXPECT_EQ(found.find("icc", "rough|ICC3"), nullptr);
  const Finding* const none = found.find("icc", "rough");
  ASSERT_NE(none, nullptr);
  EXPECT_THAT(none->status, HasSubstr("at least 3 items that all participants rated"));
  const StoredTable* const table = find_table(outcome, "agreement");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->table.columns.back(), "status");
  EXPECT_EQ(table->table.rows.front().back(), Cell(std::string("too_few_items")));
}

// A code, which windows show in their language.
TEST(RatingsOfOneItem, HaveAReasonWhyTheyAreNotTested) {
  const std::vector<std::vector<MadeUpTrial>> people{{rated_on("wood", "1", "6")},
                                                     {rated_on("wood", "3", "6")}};
  const AnalysisOutcome outcome = analysed_ratings(two_scales_with("{}"), people);
  const Table& tests = table_of(outcome, "tests").table;
  const Cell status = tests.rows.front().back();
  EXPECT_EQ(status, Cell{"one_item"});
  EXPECT_EQ(words_of_status("one_item").english(), "only one item was rated on this scale");
}

std::string one_scale(const std::string& scale) {
  return R"({"kind": "rating", "blocks": {"only": {"question":
    {"name": "rough", "prompt": "How rough?", "scale": )" +
         scale + "}}}}";
}

/// Four participants with different means; stone is rated 20, 22, 18 and 24 above wood.
std::vector<std::vector<MadeUpTrial>> four_on_a_line() {
  std::vector<std::vector<MadeUpTrial>> people{};
  for (const auto& [wood, stone] : {std::pair{10, 30}, {30, 52}, {20, 38}, {50, 74}}) {
    people.push_back(
        {rated_on("wood", std::to_string(wood)), rated_on("stone", std::to_string(stone))});
  }
  return people;
}

TEST(RatingModel, IsTheAnalysisOfVarianceOfTheParticipantsMeans) {
  const AnalysisOutcome outcome =
      analysed_ratings(one_scale(R"({"minimum": 0, "maximum": 100})"), four_on_a_line());
  EXPECT_EQ(find_table(outcome, "ordinal"), nullptr);
  const StoredTable* const table = find_table(outcome, "rated_differences");
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->table.rows.size(), 1U);  // the reference is the first item, stone
  const auto cell = [table](const char* column) {
    return number_of(table->table.rows[0][*column_of(table->table, column)]).value();
  };
  // The differences −20, −22, −18, −24: mean −21, s² = 20/3; t of 3 degrees of freedom at 97.5 %: 3.182446.
  const double half = 3.182446305284263 * std::sqrt(20.0 / 3.0 / 4.0);
  EXPECT_NEAR(cell("difference"), -21.0, 1e-9);
  EXPECT_NEAR(cell("difference_low"), -21.0 - half, 1e-9);
  EXPECT_NEAR(cell("difference_high"), -21.0 + half, 1e-9);
  const FoundNumbers found(outcome.findings);
  EXPECT_NEAR(found.value("F", "rough|item").value(), 441.0 / (20.0 / 3.0 / 4.0), 1e-6);
  EXPECT_EQ(found.value("df2", "rough|item"), 3.0);
  const auto sentence =
      std::find_if(outcome.test_sentences.begin(), outcome.test_sentences.end(),
                   [](const TestSentence& each) { return each.test == "rating_model"; });
  ASSERT_NE(sentence, outcome.test_sentences.end());
  EXPECT_THAT(sentence->text, HasSubstr("in the analysis of variance"));
  EXPECT_THAT(sentence->text, HasSubstr("F(1, 3)"));
}

// Two participants rate wood higher and two stone, each in four trials without any variation: no difference of the means, which
// a model without the variation of the effects over participants would take for sixteen independent differences.
TEST(RatingModel, CountsParticipantsAndNotResponses) {
  std::vector<std::vector<MadeUpTrial>> people{};
  for (const auto& [wood, stone] : {std::pair{10, 50}, {12, 40}, {52, 20}, {40, 12}}) {
    std::vector<MadeUpTrial>& trials = people.emplace_back();
    for (int repetition = 1; repetition <= 4; ++repetition) {
      trials.push_back(rated_on("wood", std::to_string(wood), {}, repetition));
      trials.push_back(rated_on("stone", std::to_string(stone), {}, repetition));
    }
  }
  const AnalysisOutcome outcome =
      analysed_ratings(one_scale(R"({"minimum": 0, "maximum": 100})"), people);
  const FoundNumbers found(outcome.findings);
  // Differences 40, 28, −32, −28: mean 2, s² = 4/3·(38² + 26² + 34² + 30²)/4.
  const double variance = (38.0 * 38.0 + 26.0 * 26.0 + 34.0 * 34.0 + 30.0 * 30.0) / 3.0;
  EXPECT_NEAR(found.value("F", "rough|item").value(), 4.0 / (variance / 4.0), 1e-9);
  EXPECT_EQ(found.value("df2", "rough|item"), 3.0);
}

TEST(RatingModel, HasLogOddsWithoutTestsUpToElevenPoints) {
  const auto outcome_of = [](const std::string& points) {
    std::vector<std::vector<MadeUpTrial>> people{};
    for (const auto& [wood, stone] : {std::pair{1, 3}, {3, 2}, {2, 4}, {4, 5}, {1, 2}}) {
      people.push_back(
          {rated_on("wood", std::to_string(wood)), rated_on("stone", std::to_string(stone))});
    }
    return analysed_ratings(one_scale(R"({"minimum": 0, "maximum": 11, "points": )" + points + "}"),
                            people);
  };
  const AnalysisOutcome eleven = outcome_of("11");
  const FoundNumbers found(eleven.findings);
  EXPECT_NE(found.find("n.categories", "rough"), nullptr);
  EXPECT_EQ(found.find("lr.p", "rough"), nullptr);
  for (const Finding* const odds : found.all("logodds")) EXPECT_FALSE(odds->low) << odds->key;
  EXPECT_THAT(find_table(eleven, "ordinal")->note.english(),
              HasSubstr("Type I error rate of 21 %"));
  const AnalysisOutcome twelve = outcome_of("12");
  EXPECT_EQ(FoundNumbers(twelve.findings).find("n.categories", "rough"), nullptr);
  EXPECT_NE(find_table(twelve, "rated_differences"), nullptr);
}

/// Five participants rate so many items on both scales.
AnalysisOutcome profiles_of_items(int items) {
  std::vector<std::vector<MadeUpTrial>> people(5);
  for (int person = 0; person < 5; ++person) {
    for (int item = 0; item < items; ++item) {
      people[static_cast<std::size_t>(person)].push_back(
          rated_on("item" + std::to_string(10 + item), std::to_string(1 + (item + person) % 7),
                   std::to_string(1 + (item * 3 + person) % 7)));
    }
  }
  return analysed_ratings(two_scales_with("{}"), people);
}

TEST(RatingComponents, HaveLoadingsForOneComponentPerFiveItems) {
  const AnalysisOutcome four = profiles_of_items(4);
  EXPECT_EQ(find_table(four, "loadings"), nullptr);
  EXPECT_TRUE(FoundNumbers(four.findings).all("loading").empty());
  ASSERT_NE(find_table(four, "components"), nullptr);
  EXPECT_THAT(find_table(four, "components")->note.english(),
              HasSubstr("at least five items per component, and 4 items"));
  const AnalysisOutcome nine = profiles_of_items(9);
  for (const Finding* const loading : FoundNumbers(nine.findings).all("loading")) {
    EXPECT_TRUE(loading->key.last() == "C1") << loading->key;
    EXPECT_FALSE(loading->low || loading->high) << loading->key;
  }
  for (const Finding* const corrected : FoundNumbers(nine.findings).all("loading.corrected")) {
    EXPECT_TRUE(corrected->key.last() == "C1") << corrected->key;
    EXPECT_TRUE(corrected->value && !corrected->low && !corrected->high) << corrected->key;
    EXPECT_THAT(corrected->method, HasSubstr(span_of_coverage("components", "loading.corrected")));
  }
  for (const Finding* const corrected : FoundNumbers(nine.findings).all("proportion.corrected")) {
    EXPECT_LE(corrected->low.value(), corrected->value.value()) << corrected->key;
    EXPECT_GE(corrected->high.value(), corrected->value.value()) << corrected->key;
    EXPECT_THAT(corrected->method,
                HasSubstr(span_of_coverage("components", "proportion.corrected")));
  }
  EXPECT_EQ(FoundNumbers(nine.findings).all("loading").size(), 2U);
  EXPECT_THAT(find_table(nine, "components")->note.english(),
              HasSubstr(span_of_coverage("components", "proportion.corrected")));
  EXPECT_THAT(find_table(nine, "loadings")->note.english(),
              HasSubstr(span_of_coverage("components", "loading.corrected")));
  EXPECT_EQ(FoundNumbers(profiles_of_items(10).findings).all("loading").size(), 4U);
}

// Levels are in the order of their values: 5e-05, 7e-05, 1e-04, which is not that of their texts.
TEST(RatingComponents, AreThoseOfAllItemsWhereTheItemsAreLevels) {
  const std::string source = R"({"kind": "rating",
    "factors": {"amplitude_m": {"levels": [0.0001, 0.00007, 0.00005]},
                "wavelength_m": {"levels": [0.01, 0.0025]}},
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {
      "amplitude_m": {"factor": "amplitude_m"}, "wavelength_m": {"factor": "wavelength_m"}}}},
    "blocks": {"only": {"crossed": ["amplitude_m", "wavelength_m"],
                        "presented": [{"stimulus": "grating"}], "questions": [
      {"name": "rough", "prompt": "How rough?", "scale": {"minimum": 1, "maximum": 7, "points": 7}},
      {"name": "smooth", "prompt": "How smooth?", "scale": {"minimum": 1, "maximum": 7, "points": 7}}]}}})";
  std::vector<std::vector<MadeUpTrial>> people(3);
  for (int person = 0; person < 3; ++person) {
    int item = 0;
    for (const char* const amplitude : {"0.0001", "7e-05", "5e-05"}) {
      for (const char* const wavelength : {"0.01", "0.0025"}) {
        MadeUpTrial trial = rated_on("sinusoid", std::to_string(1 + (item + person) % 7),
                                     std::to_string(1 + (item * 3 + person) % 7));
        trial.surfaces = {surface_of("sinusoid", "sinusoid", "")};
        trial.factors_json = std::string("{\"amplitude_m\": ") + amplitude +
                             ", \"wavelength_m\": " + wavelength + "}";
        people[static_cast<std::size_t>(person)].push_back(trial);
        ++item;
      }
    }
  }
  const AnalysisOutcome outcome = analysed_ratings(source, people);
  ASSERT_NE(find_table(outcome, "loadings"), nullptr);
  EXPECT_EQ(FoundNumbers(outcome.findings).all("score").size(), 6U);
}

// Item d is presented once, and a is presented once more than b and c: two repetitions of a, b and c.
TEST(RatingReliability, IsThatOfTheRepetitionsThatAllRepeatedItemsHave) {
  const std::vector<std::vector<MadeUpTrial>> people{
      {rated_on("a", "10"), rated_on("b", "30"), rated_on("c", "20"), rated_on("d", "30"),
       rated_on("a", "20", {}, 2), rated_on("b", "60", {}, 2), rated_on("c", "40", {}, 2),
       rated_on("a", "99", {}, 3)}};
  const AnalysisOutcome outcome =
      analysed_ratings(one_scale(R"({"minimum": 0, "maximum": 100})"), people);
  // Items 15, 45, 30 around 30: MSB = 2·(225 + 225 + 0)/2 = 450; residuals ±5, ∓5, ±0: MSE = 2·50/2 = 50.
  EXPECT_NEAR(FoundNumbers(outcome.findings).value("icc.mean", "rough|ICC3").value(), 0.8, 1e-12);
  const auto asked = std::find_if(outcome.questions.begin(), outcome.questions.end(),
                                  [](const auto& one) { return one.name == "reliability_rough"; });
  ASSERT_NE(asked, outcome.questions.end());
  EXPECT_THAT(asked->answer.english(),
              HasSubstr("the first 2 of each of the 3 repeated items are used"));
}

TEST(RatingReliability, IsThatOfEachParticipantsRepetitions) {
  // Both participants repeat their ratings of three items; the second one without any change.
  const std::vector<std::vector<MadeUpTrial>> people{
      {rated_on("a", "10"), rated_on("b", "20"), rated_on("c", "30"), rated_on("a", "20", {}, 2),
       rated_on("b", "20", {}, 2), rated_on("c", "50", {}, 2)},
      {rated_on("a", "40"), rated_on("b", "50"), rated_on("c", "90"), rated_on("a", "40", {}, 2),
       rated_on("b", "50", {}, 2), rated_on("c", "90", {}, 2)}};
  const AnalysisOutcome outcome =
      analysed_ratings(one_scale(R"({"minimum": 0, "maximum": 100})"), people);
  // The first: items 15, 20, 40 and repetitions 20, 30 around the mean 25: MSB = 2·(100 + 25 + 225)/2 =
  // 350; residuals ±0, ±5, ∓5: MSE = 2·(0 + 25 + 25)/2 = 50; ICC3 = 300/400. The second: 1.
  EXPECT_NEAR(FoundNumbers(outcome.findings).value("icc.mean", "rough|ICC3").value(), 0.875, 1e-12);
  EXPECT_TRUE(std::any_of(outcome.questions.begin(), outcome.questions.end(),
                          [](const auto& each) { return each.name == "reliability_rough"; }));
}

}  // namespace
}  // namespace asperity
