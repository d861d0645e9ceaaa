// Learning over trials, from the rows of a study.

#include "app/findings/shared/learning.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::ElementsAre;

struct MadeUpResponse {
  double time_s = 1.0;
  bool is_correct = true;
};

MadeUpTrial trial_with(const MadeUpResponse& response) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("metal", "height_map", "metal")};
  trial.options = {"metal", "stone"};
  trial.answers = {response.is_correct ? "metal" : "stone"};
  trial.right = {"metal"};
  trial.from_cue_s = response.time_s;
  return trial;
}

AnalysisOutcome analyze_responses(const std::vector<std::vector<MadeUpResponse>>& by_participant) {
  std::vector<std::vector<MadeUpTrial>> trials{};
  for (const std::vector<MadeUpResponse>& responses : by_participant) {
    trials.emplace_back();
    for (const MadeUpResponse& each : responses) trials.back().push_back(trial_with(each));
  }
  return analysed("recognition", "{}", {.first = 0, .sex = "F"}, trials);
}

const std::vector<Cell>& change_of(const AnalysisOutcome& outcome, const std::string& measure) {
  for (const std::vector<Cell>& row : table_of(outcome, kLearning).table.rows) {
    if (row[0] == Cell{measure}) return row;
  }
  throw std::runtime_error("no row of " + measure);
}

double of(const Cell& cell) { return std::get<double>(cell); }

// Times are halved with every trial, or stay: per 10 trials by 2⁻¹⁰ and 1, whose geometric mean is 2⁻⁵.
const std::vector<std::vector<MadeUpResponse>> kHalvedOrConstant{
    {{8.0, false}, {4.0, false}, {2.0, true}, {1.0, true}, {0.5, true}},
    {{2.0, true}, {2.0, false}, {2.0, false}, {2.0, true}, {2.0, true}}};

TEST(Learning, OfResponseTimesIsARatioOverParticipants) {
  const AnalysisOutcome outcome = analyze_responses(kHalvedOrConstant);
  const std::vector<Cell>& halves = change_of(outcome, "time_of_halves");
  EXPECT_EQ(halves[1], Cell{std::int64_t{2}});
  // Trials 1 and 2 against 4 and 5, the third in neither: √32 to √½, ⅛ of it, and 2 to 2.
  EXPECT_NEAR(of(halves[2]), std::sqrt(std::sqrt(32.0) * 2.0), 1e-12);
  EXPECT_NEAR(of(halves[3]), std::sqrt(std::sqrt(0.5) * 2.0), 1e-12);
  EXPECT_NEAR(of(halves[4]), std::sqrt(1.0 / 8.0), 1e-12);
  // ln ⅛ and 0: mean −1.5·ln 2, standard error 1.5·ln 2, t₁(.975) = 12.706….
  const double half_width = 12.706204736174705 * 1.5 * std::log(2.0);
  EXPECT_NEAR(std::log(of(halves[5])), -1.5 * std::log(2.0) - half_width, 1e-9);
  EXPECT_NEAR(std::log(of(halves[6])), -1.5 * std::log(2.0) + half_width, 1e-9);
}

// Ten trials that are halved each time, and ten alike: √(2^−10). Fewer would extrapolate.
TEST(Learning, HasARatioPerTenTrialsOfAsMany) {
  std::vector<MadeUpResponse> halved{};
  double time_s = 512.0;
  for (int trial = 0; trial < 10; ++trial, time_s /= 2.0) halved.push_back({time_s, true});
  const std::vector<MadeUpResponse> alike(10, MadeUpResponse{2.0, true});
  EXPECT_NEAR(of(change_of(analyze_responses({halved, alike}), "time_per_10_trials")[4]),
              1.0 / 32.0, 1e-12);
  halved.pop_back();
  EXPECT_EQ(table_of(analyze_responses({halved}), kLearning).table.rows.size(), 2U);
}

TEST(Learning, OfProportionsCorrectIsADifference) {
  const AnalysisOutcome outcome = analyze_responses(kHalvedOrConstant);
  const std::vector<Cell>& halves = change_of(outcome, "correct_of_halves");
  EXPECT_NEAR(of(halves[2]), 0.25, 1e-12);  // 0 of 2, 1 of 2
  EXPECT_NEAR(of(halves[3]), 1.0, 1e-12);
  EXPECT_NEAR(of(halves[4]), 0.75, 1e-12);
  EXPECT_EQ(of(halves[6]), 1.0);  // no difference is greater
}

TEST(Learning, IsShownInBlocksOfTrials) {
  const AnalysisOutcome outcome = analyze_responses(kHalvedOrConstant);
  const Table& course = table_of(outcome, kTrialCourse).table;
  EXPECT_THAT(course.columns, ElementsAre("trials", "persons", "time_s", "time_s_low",
                                          "time_s_high", "share", "share_low", "share_high"));
  ASSERT_EQ(course.rows.size(), 5U);
  EXPECT_EQ(course.rows[1][0], Cell{std::string("2")});
  EXPECT_NEAR(of(course.rows[1][2]), std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(of(course.rows[2][5]), 0.5, 1e-12);
}

TEST(Learning, PutsManyTrialsIntoTwelveBlocksAtMost) {
  const AnalysisOutcome outcome =
      analyze_responses({std::vector<MadeUpResponse>(25), std::vector<MadeUpResponse>(13)});
  const Table& course = table_of(outcome, kTrialCourse).table;
  ASSERT_EQ(course.rows.size(), 9U);  // of three trials, 25 being too many for two
  EXPECT_EQ(course.rows[0][0], Cell{std::string("1–3")});
  EXPECT_EQ(course.rows[8][0], Cell{std::string("25")});
  EXPECT_EQ(course.rows[4][1], Cell{std::int64_t{2}});  // trials 13 to 15
  EXPECT_EQ(course.rows[5][1], Cell{std::int64_t{1}});
}

TEST(Learning, NeedsTwoTrialsOfAParticipant) {
  EXPECT_EQ(find_table(analyze_responses({{{1.0, true}}, {{2.0, true}}}), kLearning), nullptr);
}

// Choices among models are neither correct nor incorrect.
TEST(Learning, OfChoicesIsThatOfTheirTimesAlone) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("choose", "selection");
  made.add_person("p0", "F");
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("old", "old", "wood"), surface_of("new", "new", "wood")};
  trial.options = {"old", "new"};
  trial.answers = {"new"};
  made.add_session("p0", protocol, {trial, trial});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(table_of(outcome, kLearning).table.rows.size(), 1U);
  EXPECT_THAT(table_of(outcome, kTrialCourse).table.columns,
              ElementsAre("trials", "persons", "time_s"));
}

}  // namespace
}  // namespace asperity
