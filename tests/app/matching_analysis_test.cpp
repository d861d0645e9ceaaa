// The chapter's matching, rebuilt answer by answer from its printed counts, and other matchings.

#include <array>
#include <cmath>
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

TEST(Matching, ReproducesTheChaptersSecondTable) {
  const AnalysisOutcome& outcome = matchings_of_the_chapter();
  using Row = std::vector<Cell>;
  const auto n = [](std::int64_t count) { return Cell{count}; };
  EXPECT_THAT(
      table_of(outcome, "table_2").table.rows,
      ElementsAre(Row{"Female", n(9), n(9), n(8), n(26)}, Row{"Male", n(9), n(10), n(9), n(28)},
                  Row{"Total", n(18), n(19), n(17), n(54)}));
}

TEST(Matching, TestsWholePermutationsAgainstOneInTwentyFour) {
  const AnalysisOutcome& outcome = matchings_of_the_chapter();
  const Table& whole = table_of(outcome, "whole_permutations").table;
  const std::vector<std::string> keys{"1", "Total"};
  EXPECT_DOUBLE_EQ(number(whole, keys, "chance"), 1.0 / 24.0);
  EXPECT_DOUBLE_EQ(number(whole, keys, "share"), 0.90);
  EXPECT_NEAR(number(whole, keys, "clopper_pearson_low"), 0.68, 0.005);
  EXPECT_NEAR(number(whole, keys, "clopper_pearson_high"), 0.99, 0.005);
  EXPECT_NEAR(number(whole, keys, "p") / 2.5e-23, 1.0, 0.02);
}

// In the first column 18 people have 4 right and two have 2: 76 of 80.
TEST(Matching, CountsSingleItemsAgainstOneInFour) {
  const AnalysisOutcome& outcome = matchings_of_the_chapter();
  const Table& items = table_of(outcome, "items").table;
  const std::vector<std::string> keys{"1", "Total"};
  EXPECT_EQ(number(items, keys, "correct"), 76);
  EXPECT_EQ(number(items, keys, "of"), 80);
  EXPECT_DOUBLE_EQ(number(items, keys, "share"), 0.95);
  EXPECT_DOUBLE_EQ(number(items, keys, "chance"), 0.25);
}

// One person, two of four right. Random permutations give 9, 8, 6, 0 and 1 of 24, so two or more
// right have the probability 7/24; a binomial with 1/4 would say 0.26.
TEST(Matching, JudgesItemsByThePermutationNull) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session("a", made.add_protocol("matching", "matching"),
                   {made_up_matching({"metal", "stone", "brick", "wood"})});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& items = table_of(outcome, "items").table;
  EXPECT_DOUBLE_EQ(number(items, {"all", "Total"}, "p"), 7.0 / 24.0);
  EXPECT_EQ(cell_named(items, {"all", "Male"}, "share"), Cell{});
}

TEST(Matching, ShowsWhichTexturesAreConfused) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session(
      "a", made.add_protocol("matching", "matching"),
      {made_up_matching({"metal", "stone", "brick", "wood"}), made_up_matching(kTextures)});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& confusion = table_of(outcome, "confusion").table;
  EXPECT_EQ(number(confusion, {"wood"}, "brick"), 1);
  EXPECT_EQ(number(confusion, {"wood"}, "wood"), 1);
  EXPECT_EQ(number(confusion, {"metal"}, "metal"), 2);
  EXPECT_EQ(number(confusion, {"metal"}, "brick"), 0);
}

TEST(Matching, LeavesOutWhatIsNoPermutationAndSaysSo) {
  MadeUpStudy made;
  made.add_person("a", "F");
  MadeUpTrial more_pictures = made_up_matching(kTextures);
  more_pictures.options = kPictures;
  made.add_session("a", made.add_protocol("matching", "matching"),
                   {made_up_matching(kTextures), more_pictures});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(number(table_of(outcome, "whole_permutations").table, {"all", "Total"}, "of"), 1);
  EXPECT_THAT(outcome.remarks,
              testing::Contains(says("left out because they do not assign each picture")));
}

TEST(Matching, HasItsNumbersFromTheFamily) {
  const AnalysisOutcome& outcome = matchings_of_the_chapter();
  const Table& items = table_of(outcome, "items").table;
  EXPECT_EQ(finding_of(outcome, "matching", "relabel.p.greater").value,
            number(items, {"all", "Total"}, "p"));
  // 54 goes with 4 right, 6 with 2.
  const Table& right = table_of(outcome, "right_items").table;
  EXPECT_EQ(std::get<std::int64_t>(right.rows[4][1]), 54);
  EXPECT_EQ(std::get<std::int64_t>(right.rows[2][1]), 6);
  EXPECT_DOUBLE_EQ(std::get<double>(right.rows[4][2]), 60.0 / 24.0);
  const Table& pairs = table_of(outcome, "confused_pairs").table;
  EXPECT_EQ(std::get<std::string>(pairs.rows[0][0]) + std::get<std::string>(pairs.rows[0][1]),
            "brickwood");
  EXPECT_EQ(std::get<std::int64_t>(pairs.rows[0][2]), 6);
  EXPECT_THAT(question_of(outcome, "items").answer.english(),
              testing::StartsWith("On average 95 % of a participant's items were matched"));
  EXPECT_THAT(question_of(outcome, "items").answer.english(),
              HasSubstr("This test is exploratory."));
  EXPECT_THAT(question_of(outcome, "sexes").answer.english(),
              testing::MatchesRegex(
                  "For these participants, the mean proportion of correctly matched items is .* % "
                  ".95 % CI .*, n = 10. for women and .*, n = 10. for men; difference .women − "
                  "men. .* percentage points .Welch 95 % CI .*\\. Permutation test of group "
                  "labels: p = .*, uncorrected\\. This test is exploratory\\."));
}

TEST(Matching, NamesThePairsThatAreConfusedEquallyOften) {
  const auto answer_after = [](const std::vector<std::vector<std::string>>& goes) {
    MadeUpStudy made;
    made.add_person("a", "F");
    std::vector<MadeUpTrial> trials{};
    for (const auto& pictures : goes) trials.push_back(made_up_matching(pictures));
    made.add_session("a", made.add_protocol("matching", "matching"), trials);
    return question_of(analyze_study(made.study()).front(), "confusions").answer.english();
  };
  EXPECT_EQ(answer_after({{"metal", "stone", "brick", "wood"}}),
            "brick and wood are confused most often; number of confusions, counted in both "
            "directions: 2.");
  EXPECT_EQ(
      answer_after({{"metal", "stone", "brick", "wood"}, {"stone", "metal", "wood", "brick"}}),
      "The following pairs are confused equally often, and none more often: brick and wood; metal "
      "and "
      "stone; number of confusions of each, counted in both directions: 2.");
}

TEST(Matching, StatesTheMeanChanceOfTrialsOfDifferentSizes) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_person("b", "M");
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  MadeUpTrial three = made_up_matching({"metal", "stone", "wood"});
  three.surfaces.pop_back();
  three.right = three.options = three.answers;
  for (const char* label : {"a", "b"})
    made.add_session(label, protocol, {made_up_matching(kTextures), three});
  EXPECT_THAT(
      question_of(analyze_study(made.study()).front(), "items").answer.english(),
      HasSubstr("compared with a chance level of 29 % on average (1 divided by the number of "
                "items, which differs between trials)"));
}

// As below, with a fourth trial of three items: of 15 items of a participant 4 are correct under guessing.
TEST(Matching, ClaimsNothingWhereTheIntervalContainsTheMeanChanceOfTrialsOfDifferentSizes) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("matching", "matching", R"({"analysis": {"family": ["items"]}})");
  MadeUpTrial three = made_up_matching({"metal", "stone", "wood"});
  three.surfaces.pop_back();
  three.right = three.options = three.answers;
  std::vector<MadeUpTrial> trials(3, made_up_matching(kTextures));
  trials.push_back(three);
  for (const char* const label : {"a", "b"}) {
    made.add_person(label, "F");
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_THAT(question_of(outcome, "items").answer.english(),
              testing::StartsWith("Not established: on average 100 %"));
  EXPECT_THAT(sentence_about(outcome, "items"),
              testing::StartsWith("It was not established that the proportion of correctly matched "
                                  "items was above the chance level of 27 % on average: "));
}

// Two participants, of whom one matches everything and the other three of four on average: beyond chance by the test,
// but their 95 % CI leaves everything open.
TEST(Matching, ClaimsNothingWhereTheIntervalContainsChance) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  const std::vector<std::string> swapped{"stone", "metal", "wood", "brick"};
  made.add_person("a", "F");
  made.add_person("b", "F");
  made.add_session("a", protocol, std::vector<MadeUpTrial>(6, made_up_matching(kTextures)));
  std::vector<MadeUpTrial> half(3, made_up_matching(kTextures));
  half.insert(half.end(), 3, made_up_matching(swapped));
  made.add_session("b", protocol, half);
  const std::string answer =
      question_of(analyze_study(made.study()).front(), "items").answer.english();
  EXPECT_THAT(answer, HasSubstr(", uncorrected"));
  EXPECT_THAT(answer, testing::StartsWith("On average 88 %"));
  EXPECT_THAT(answer, HasSubstr("Nothing is established: p is below .05, but the 95 % CI of the "
                                "mean contains the chance level"));
}

// Two participants, every item of whom is correct: p is small, and the intervals leave everything open. The answers and the text
// for a paper state the same.
TEST(Matching, ClaimsTheSameInAnswersAndInTheTextForAPaper) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("matching", "matching", R"({"analysis": {"family": ["items", "whole"]}})");
  for (const char* const label : {"a", "b"}) {
    made.add_person(label, "F");
    made.add_session(label, protocol, std::vector<MadeUpTrial>(3, made_up_matching(kTextures)));
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_THAT(question_of(outcome, "items").answer.english(),
              testing::StartsWith("Not established: on average 100 %"));
  EXPECT_THAT(question_of(outcome, "whole").answer.english(), HasSubstr("Nothing is established"));
  for (const TestSentence& sentence : outcome.test_sentences) {
    if (sentence.test != "items" && sentence.test != "whole") continue;
    EXPECT_THAT(sentence.text, testing::StartsWith("It was not established that the "))
        << sentence.test;
    EXPECT_THAT(sentence.text, HasSubstr("the 95 % CI of the mean contains the chance level."));
    EXPECT_FALSE(sentence.is_significant);
  }
}

// Three participants keep one assignment each through six trials: everything right, one right, nothing right. Of one
// relabelling each, 30 right items or more come from 4 and 1 or more right of any two (or 4 and 4), 2 and 4, ...:
// counted out below. As 18 independent permutations they would be far beyond chance.
TEST(Matching, TestsParticipantsWhoKeepTheirAssignmentAsOneRelabellingEach) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  const std::vector<std::pair<const char*, std::vector<std::string>>> kept{
      {"a", kTextures},
      {"b", {"metal", "wood", "brick", "stone"}},
      {"c", {"stone", "metal", "brick", "wood"}}};
  for (const auto& [label, pictures] : kept) {
    made.add_person(label, "F");
    made.add_session(label, protocol, std::vector<MadeUpTrial>(6, made_up_matching(pictures)));
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  // Five or more right items of three random permutations of four (9, 8, 6, 0 and 1 of 24).
  constexpr std::array<double, 5> kWays{9, 8, 6, 0, 1};
  double as_many = 0.0;
  for (std::size_t i = 0; i < 125; ++i) {
    if (i % 5 + i / 5 % 5 + i / 25 < 5) continue;
    as_many += kWays[i % 5] * kWays[i / 5 % 5] * kWays[i / 25];
  }
  const Table& tests = table_of(outcome, "tests").table;
  EXPECT_NEAR(number(tests, {"items"}, "p"), as_many / (24.0 * 24.0 * 24.0), 1e-12);
  EXPECT_NEAR(number(tests, {"whole"}, "p"), 1.0 - std::pow(23.0 / 24.0, 3), 1e-12);
  EXPECT_NEAR(number(tests, {"textures", "metal"}, "p"), 1.0 - std::pow(3.0 / 4.0, 3) - 27.0 / 64.0,
              1e-12);
  EXPECT_EQ(number(table_of(outcome, "items").table, {"all", "Total"}, "chance_high"), 42.0 / 72.0);
}

}  // namespace
}  // namespace asperity
