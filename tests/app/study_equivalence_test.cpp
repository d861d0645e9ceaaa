// Equivalence of groups and reliability over repetitions, from the rows of a study.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/shared/group_equivalence.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kTwoTextures{"metal", "stone"};

/// One answer of a recognition in a repetition.
MadeUpTrial repeated_trial(int repetition, bool is_right) {
  MadeUpTrial trial{};
  trial.factors_json = R"({"column": )" + std::to_string(repetition) + "}";
  trial.surfaces = {surface_of("metal", "height_map", "metal")};
  trial.answers = {kTwoTextures[is_right ? 0 : 1]};
  trial.right = {"metal"};
  trial.options = kTwoTextures;
  return trial;
}

/// Correct answers of each participant in both repetitions, of four each; women first, then men.
AnalysisOutcome analyze_repetitions(const std::vector<std::array<int, 2>>& correct,
                                    const std::string& protocol_json) {
  const auto trials_of = [&](int person) {
    std::vector<MadeUpTrial> trials{};
    for (int repetition = 1; repetition <= 2; ++repetition) {
      const int right =
          correct[static_cast<std::size_t>(person)][static_cast<std::size_t>(repetition - 1)];
      for (int k = 0; k < 4; ++k) trials.push_back(repeated_trial(repetition, k < right));
    }
    return trials;
  };
  const int people = static_cast<int>(correct.size());
  return analysed("recognition", protocol_json, {.number = people, .first = 0, .of_both = true},
                  trials_of);
}

double value_in(const AnalysisOutcome& outcome, const std::string& analysis,
                const std::string& quantity, const std::string& key = "") {
  return finding_of(outcome, analysis, quantity, key).value.value_or(std::nan(""));
}

const std::vector<std::array<int, 2>> kSimilarGroups{{4, 3}, {2, 2}, {3, 3}, {1, 2},
                                                     {3, 4}, {2, 2}, {3, 3}, {2, 1}};

TEST(Equivalence, IsTestedWithTheMarginThatTheProtocolDeclares) {
  // Women 7/8, 4/8, 6/8, 3/8 and men 7/8, 4/8, 6/8, 3/8: means 0.625 each, no difference at all.
  const AnalysisOutcome wide =
      analyze_repetitions(kSimilarGroups, R"({"analysis": {"equivalence_margin": 0.5}})");
  EXPECT_THAT(
      answer_to(wide, kSexesEquivalence),
      StartsWith("The 90 % CI lies within ±50.0 percentage points: difference (women − men) = 0.0 "
                 "percentage points, 90 % CI [−"));
  const AnalysisOutcome narrow =
      analyze_repetitions(kSimilarGroups, R"({"analysis": {"equivalence_margin": 0.05}})");
  EXPECT_THAT(answer_to(narrow, kSexesEquivalence),
              StartsWith("The 90 % CI does not lie within ±5.0 percentage points: "));
  // SE² = 2·s²/4 with s² = (0.25² + 0.125² + 0.125² + 0.25²)/3: t₆(.95)·SE.
  const double se = std::sqrt(2.0 * (2.0 * 0.0625 + 2.0 * 0.015625) / 3.0 / 4.0);
  EXPECT_NEAR(value_in(narrow, kSexesEquivalence, "equivalence.margin"), 1.943180280515304 * se,
              1e-9);
}

TEST(Equivalence, HasNoVerdictWithoutADeclaredMargin) {
  const AnalysisOutcome outcome = analyze_repetitions(kSimilarGroups, "{}");
  const std::string answer = answer_to(outcome, kSexesEquivalence);
  EXPECT_THAT(
      answer,
      StartsWith("The protocol declares no equivalence margin, so equivalence is not assessed: "));
  EXPECT_THAT(answer, HasSubstr("The data would support equivalence within ±"));
  EXPECT_TRUE(std::none_of(outcome.findings.begin(), outcome.findings.end(),
                           [](const Finding& one) { return one.quantity == "tost.p"; }));
}

// Women and men with all and none correct: SE² = ½/2 + ½/2, and t₂(.95)·SE is more than 2.
TEST(Equivalence, HasNoMarginBeyondTheLargestDifference) {
  const AnalysisOutcome outcome = analyze_repetitions({{4, 4}, {0, 0}, {4, 4}, {0, 0}}, "{}");
  const std::string answer = answer_to(outcome, kSexesEquivalence);
  EXPECT_GT(value_in(outcome, kSexesEquivalence, "equivalence.margin"), 2.0);
  EXPECT_THAT(answer, HasSubstr("The data would not support equivalence within any margin: the CI "
                                "reaches ±100 percentage points"));
}

TEST(Equivalence, CannotBeAssessedWhereNobodyDiffers) {
  const AnalysisOutcome outcome = analyze_repetitions({{2, 2}, {2, 2}, {2, 2}, {2, 2}}, "{}");
  EXPECT_THAT(answer_to(outcome, kSexesEquivalence), StartsWith("This cannot be assessed: "));
  EXPECT_THAT(answer_to(outcome, "reliability"), StartsWith("Not defined: "));
}

// Of proportions ¼ apart in the second repetition: consistency is whole, agreement is not.
TEST(ReliabilityOverRepetitions, TellsConsistencyFromAgreement) {
  const AnalysisOutcome outcome = analyze_repetitions({{0, 1}, {1, 2}, {2, 3}, {3, 4}}, "{}");
  EXPECT_NEAR(value_in(outcome, "reliability", "icc", "ICC3"), 1.0, 1e-12);
  // MSB = 10/3/16·2, MSJ = 2·4/4/16: in sixteenths 10/3 and 2, MSE 0.
  EXPECT_NEAR(value_in(outcome, "reliability", "icc", "ICC2"), (10.0 / 3.0) / (10.0 / 3.0 + 1.0),
              1e-12);
  EXPECT_THAT(
      answer_to(outcome, "reliability"),
      StartsWith(
          "Reliability of a single repetition: ICC(3,1) = 1.00 (consistency) and ICC(2,1) = .77 "
          "(agreement); of the mean of the 2 repetitions: ICC(3,k) = 1.00; N = 4 participants."));
}

TEST(ReliabilityOverRepetitions, IsNotAskedWithoutRepetitions) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  for (const char* label : {"a", "b"}) {
    made.add_person(label, "F");
    MadeUpTrial trial = repeated_trial(1, label[0] == 'a');
    trial.factors_json = "{}";
    made.add_session(label, protocol, {trial, trial});
  }
  EXPECT_EQ(find_question(analyze_study(made.study()).front(), "reliability"), nullptr);
}

}  // namespace
}  // namespace asperity
