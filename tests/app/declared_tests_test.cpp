// The tests that a protocol declares: their family, its correction, what is claimed of tests outside it.

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/chapter_studies.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using testing::HasSubstr;

TEST(StudyTests, AdjustTheFamilyThatTheProtocolDeclares) {
  const AnalysisOutcome outcome =
      analyze_pairs(R"({"analysis": {"target": "new", "family": ["target_pairs", "position"]}})");
  const StoredTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note,
              says("over the 2 confirmatory tests, the family that the protocol declares"));
  const double pair = number(tests.table, {"target_pairs", "", "new", "old"}, "p");
  EXPECT_DOUBLE_EQ(pair, 2.0 / 32.0);
  EXPECT_DOUBLE_EQ(number(tests.table, {"target_pairs", "", "new", "old"}, "p_holm"), 2.0 * pair);
  EXPECT_EQ(cell_named(tests.table, {"preference"}, "p_holm"), Cell{});
  EXPECT_EQ(cell_named(tests.table, {"position"}, "family"), Cell{"target_pairs, position"});
  EXPECT_EQ(finding_of(outcome, "tests", "p.holm", "test=target_pairs about=new|old").value,
            2.0 * pair);
  EXPECT_THAT(question_of(outcome, "pairs").answer.english(), HasSubstr(", Holm-corrected"));
  EXPECT_THAT(question_of(outcome, "textures").question.english(), HasSubstr("of new"));
}

TEST(StudyTests, SayThatAFamilyOfOneTestLeavesItsPAsItIs) {
  const AnalysisOutcome outcome =
      analyze_pairs(R"({"analysis": {"target": "new", "family": ["preference"]}})");
  const StoredTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note,
              says("The family that the protocol declares has one test (choices of the items)"));
  EXPECT_DOUBLE_EQ(number(tests.table, {"preference"}, "p_holm"),
                   number(tests.table, {"preference"}, "p"));
  EXPECT_THAT(finding_of(outcome, "tests", "p.holm", "test=preference").method,
              HasSubstr("the only test of the family preference"));
}

TEST(StudyTests, SayThatNothingWasDeclared) {
  EXPECT_THAT(table_of(analyze_pairs("{}"), "tests").note, says("declares no family of tests"));
}

/// Thirteen women match all, thirteen men exchange two.
AnalysisOutcome analyze_twenty_six_matchings() {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("matching", "matching", R"({"analysis": {"family": ["items", "sexes"]}})");
  for (int i = 0; i < 26; ++i) {
    made.add_person(person(i), i < 13 ? "F" : "M");
    made.add_session(person(i), protocol,
                     {i < 13 ? made_up_matching(kTextures)
                             : made_up_matching({"metal", "stone", "brick", "wood"})});
  }
  return analyze_study(made.study()).front();
}

TEST(StudyTests, SplitTheSexesAtRandomWhereThereAreTooManyWays) {
  const AnalysisOutcome outcome = analyze_twenty_six_matchings();
  const StoredTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note, says("over the 2 confirmatory tests"));
  const double items = number(tests.table, {"items"}, "p");
  EXPECT_DOUBLE_EQ(number(tests.table, {"items"}, "p_holm"), 2.0 * items);
  // No split of all is as far: of the random ones and the observed one only the latter.
  EXPECT_DOUBLE_EQ(number(tests.table, {"sexes", "", "F", "M"}, "p"), 1.0 / 10001.0);
  EXPECT_THAT(
      finding_of(outcome, "tests", "p", "test=sexes about=F|M").method,
      HasSubstr("permutation test of the group labels, two-sided, random (10000 draws, seed 1)"));
  const AnsweredQuestion& sexes = question_of(outcome, "sexes");
  EXPECT_THAT(
      sexes.answer.english(),
      testing::MatchesRegex("Yes: the mean proportion of correctly matched items is 100 % .95 % CI "
                            ".[0-9]+ %, 100 %., n = 13. for women and 50 % .95 % CI .*"));
  EXPECT_THAT(sexes.answer.english(),
              HasSubstr("difference (women − men) 50.0 percentage points (without a CI)"));
  EXPECT_THAT(sexes.method.english(),
              HasSubstr("10000 permutations of the group labels drawn at random"));
}

// Four and two of four items: the statistic counts items, the answer percentage points.
TEST(StudyTests, StateTheUnitOfADifferenceOfMatchedItems) {
  const AnalysisOutcome outcome = analyze_twenty_six_matchings();
  const StoredTable& tests = table_of(outcome, "tests");
  EXPECT_EQ(number(tests.table, {"sexes", "", "F", "M"}, "value"), 2.0);
  EXPECT_THAT(tests.note,
              says("ΔM: difference of the mean numbers of correctly matched items per trial"));
}

// Nobody is a man, so that nothing compares the sexes; the family has two tests all the same.
TEST(StudyTests, KeepADeclaredTestOfWhichThereIsNoAnswer) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session(
      "a",
      made.add_protocol("matching", "matching", R"({"analysis": {"family": ["whole", "sexes"]}})"),
      {made_up_matching(kTextures)});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& tests = table_of(outcome, "tests").table;
  EXPECT_DOUBLE_EQ(number(tests, {"whole"}, "p_holm"), 2.0 / 24.0);
  EXPECT_EQ(cell_named(tests, {"sexes"}, "p"), Cell{});
  EXPECT_THAT(question_of(outcome, "items").answer.english(),
              testing::EndsWith("This test is exploratory."));
}

TEST(StudyTests, ClaimNothingOfATestOutsideTheFamily) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol(
      "pair", "selection", R"({"analysis": {"target": "new", "family": ["preference"]}})");
  for (int i = 0; i < 8; ++i) {
    made.add_person(person(i), "F");
    std::vector<MadeUpTrial> trials{};
    for (const char* texture : {"wood", "metal"}) {
      MadeUpTrial& one = trials.emplace_back();
      one.options = {"new", "old"};
      for (const std::string& model : one.options) {
        one.surfaces.push_back(surface_of(model, model, texture));
      }
      one.answers = {"new"};
    }
    made.add_session(person(i), protocol, trials);
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  for (const char* name : {"pairs", "position"}) {
    const std::string answer = question_of(outcome, name).answer.english();
    EXPECT_THAT(answer, HasSubstr("p = .008, uncorrected")) << name;
    EXPECT_THAT(answer, testing::EndsWith("This test is exploratory."));
    EXPECT_THAT(answer, testing::Not(HasSubstr("matters")));
    EXPECT_THAT(answer, testing::Not(HasSubstr("Chosen more often")));
  }
  EXPECT_THAT(question_of(outcome, "textures").answer.english(),
              testing::StartsWith("Test of equal proportions of new with every texture:"));
  EXPECT_THAT(question_of(outcome, "preference").answer.english(),
              HasSubstr(", the only test of its family"));
}

TEST(StudyTests, SayWhatTheirNumbersCount) {
  const Table& matched = table_of(matchings_of_the_chapter(), "tests").table;
  for (const char* name : {"items", "whole", "textures", "sexes"}) {
    EXPECT_EQ(number(matched, {name}, "n"), 20) << name;
    EXPECT_EQ(cell_named(matched, {name}, "unit"), Cell{"participants"}) << name;
  }
  const AnalysisOutcome recognised = analyze_recognitions();
  const Table& tests = table_of(recognised, "tests").table;
  EXPECT_EQ(number(tests, {"information"}, "n"), 12);
  EXPECT_EQ(cell_named(tests, {"information"}, "unit"), Cell{"answers"});
  EXPECT_EQ(number(tests, {"textures", "wood"}, "n"), 2);
  EXPECT_EQ(cell_named(tests, {"right"}, "unit"), Cell{"participants"});
  EXPECT_EQ(question_of(recognised, "information").finding.n, 12U);
}

// 11 of 12 choices of one participant, and all of two: no p below 1 and .5 can be attained.
TEST(StudyTests, StateTheSmallestPThatCouldBeAttained) {
  const auto outcome_of = [](int people) {
    MadeUpStudy made;
    const std::int64_t protocol = made.add_protocol("pair", "selection");
    for (int i = 0; i < people; ++i) {
      made.add_person(person(i), "F");
      std::vector<MadeUpTrial> trials(12, choice_among_models("sinusoid", "wood"));
      trials.back() = choice_among_models("stochastic", "wood");
      made.add_session(person(i), protocol, trials);
    }
    return analyze_study(made.study()).front();
  };
  const AnalysisOutcome one = outcome_of(1);
  const Table& tests = table_of(one, "tests").table;
  EXPECT_EQ(cell_named(tests, {"preference"}, "p"), Cell{});
  EXPECT_EQ(cell_named(tests, {"preference"}, "status"),
            Cell{"cannot be tested with one participant"});
  for (const char* name : {"preference", "pairs", "position"}) {
    EXPECT_THAT(question_of(one, name).answer.english(),
                HasSubstr("cannot be tested with one participant"))
        << name;
  }
  const AnalysisOutcome two = outcome_of(2);
  EXPECT_DOUBLE_EQ(
      number(table_of(two, "tests").table, {"pairs", "", "sinusoid", "stochastic"}, "p"), 0.5);
  // .5 of each, times three of the family.
  EXPECT_DOUBLE_EQ(
      number(table_of(two, "tests").table, {"pairs", "", "sinusoid", "stochastic"}, "p_smallest"),
      1.0);
  EXPECT_THAT(question_of(two, "pairs").answer.english(),
              HasSubstr("; the smallest attainable p is > .999"));
}

}  // namespace
}  // namespace asperity
