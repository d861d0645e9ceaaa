// Response times by condition, from the rows of a study.

#include "app/findings/shared/response_times.h"

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
using testing::EndsWith;
using testing::HasSubstr;

/// A recognition of a texture in a repetition that took so long.
MadeUpTrial timed_trial(int repetition, const std::string& texture,
                        const std::optional<double>& from_cue_s) {
  MadeUpTrial trial{};
  trial.factors_json = R"({"column": )" + std::to_string(repetition) + "}";
  trial.surfaces = {surface_of(texture, "height_map", texture)};
  trial.answers = {texture};
  trial.right = {texture};
  trial.options = {"metal", "stone"};
  trial.from_cue_s = from_cue_s;
  return trial;
}

AnalysisOutcome analyze_recognition_of(
    const std::vector<std::vector<MadeUpTrial>>& by_participant) {
  return analysed("recognition", "{}", {.first = 0, .sex = "F"}, by_participant);
}

const StoredTable& times_in(const AnalysisOutcome& outcome) {
  return table_of(outcome, kResponseTimes);
}

const std::vector<Cell>& times_row(const AnalysisOutcome& outcome, const std::string& factor,
                                   const std::string& level) {
  const Cell second = level.empty() ? Cell{} : Cell{level};
  for (const std::vector<Cell>& row : times_in(outcome).table.rows) {
    if (row[0] == Cell{factor} && row[1] == second) return row;
  }
  throw std::runtime_error("no row of " + factor + ' ' + level);
}

double number(const Cell& cell) { return std::get<double>(cell); }

TEST(ResponseTimes, AreGeometricMeansOverParticipantsByCondition) {
  // Geometric means in repetition 1: 2 and 8, in 2: 1 and 16; of metal 1 and 8, of stone 2 and 16.
  const AnalysisOutcome outcome =
      analyze_recognition_of({{timed_trial(1, "metal", 1.0), timed_trial(1, "stone", 4.0),
                               timed_trial(2, "metal", 1.0), timed_trial(2, "stone", 1.0)},
                              {timed_trial(1, "metal", 4.0), timed_trial(1, "stone", 16.0),
                               timed_trial(2, "metal", 16.0), timed_trial(2, "stone", 16.0)}});
  EXPECT_THAT(times_in(outcome).table.columns, ElementsAre("factor", "level", "persons", "trials",
                                                           "time_s", "time_s_low", "time_s_high"));
  const std::vector<Cell>& first = times_row(outcome, "column", "1");
  EXPECT_EQ(first[2], Cell{std::int64_t{2}});
  EXPECT_EQ(first[3], Cell{std::int64_t{4}});
  EXPECT_NEAR(number(first[4]), 4.0, 1e-12);
  // Logarithms ln 2 and ln 8: SD √2·ln 2, standard error ln 2, t₁(.975) = 12.706….
  const double factor = std::exp(12.706204736174705 * std::log(2.0));
  EXPECT_NEAR(number(first[5]) * factor, 4.0, 1e-8);
  EXPECT_NEAR(number(first[6]) / factor, 4.0, 1e-8);
  EXPECT_NEAR(number(times_row(outcome, "column", "2")[4]), 4.0, 1e-12);
  EXPECT_NEAR(number(times_row(outcome, "texture", "metal")[4]), std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(number(times_row(outcome, "texture", "stone")[4]), std::sqrt(32.0), 1e-12);
  EXPECT_EQ(times_row(outcome, "all", "")[3], Cell{std::int64_t{8}});
  EXPECT_EQ(times_in(outcome).table.rows.size(), 5U);
  const auto is_time = [](const Finding& one) {
    return one.analysis == kResponseTimes && one.quantity.ends_with("geomean");
  };
  EXPECT_EQ(std::count_if(outcome.findings.begin(), outcome.findings.end(), is_time), 15);
  EXPECT_TRUE(std::all_of(outcome.findings.begin(), outcome.findings.end(),
                          [&](const Finding& one) { return !is_time(one) || one.unit == "s"; }));
}

TEST(ResponseTimes, StateHowManyTrialsHaveNone) {
  const AnalysisOutcome outcome =
      analyze_recognition_of({{timed_trial(1, "metal", 2.0), timed_trial(1, "stone", {})},
                              {timed_trial(1, "metal", 4.0), timed_trial(1, "stone", 0.0)}});
  EXPECT_THAT(times_in(outcome).note.english(),
              EndsWith("Trials without a response time, which are left out: 2 of 4."));
  EXPECT_EQ(times_row(outcome, "texture", "stone")[3], Cell{std::int64_t{0}});
  EXPECT_EQ(times_row(outcome, "texture", "stone")[4], Cell{});
}

TEST(ResponseTimes, HaveAStatusInPlaceOfTheIntervalOfOneParticipant) {
  const AnalysisOutcome outcome =
      analyze_recognition_of({{timed_trial(1, "metal", 2.0), timed_trial(1, "metal", 8.0)}});
  const std::vector<Cell>& all = times_row(outcome, "all", "");
  EXPECT_NEAR(number(all[4]), 4.0, 1e-12);
  EXPECT_EQ(all[5], Cell{});
  const auto status =
      std::find_if(outcome.findings.begin(), outcome.findings.end(), [](const Finding& one) {
        return one.analysis == kResponseTimes && one.quantity == "geomean.status";
      });
  ASSERT_NE(status, outcome.findings.end());
  EXPECT_EQ(status->word, "too_few_participants");
}

TEST(ResponseTimes, AreARemarkWhereNoneIsStored) {
  const AnalysisOutcome outcome = analyze_recognition_of({{timed_trial(1, "metal", {})}});
  EXPECT_THROW(times_in(outcome), std::runtime_error);
  EXPECT_TRUE(std::any_of(outcome.remarks.begin(), outcome.remarks.end(), [](const Phrase& one) {
    return one.english() == "No trial has a stored response time; collect responses first.";
  }));
}

// An assignment is confirmed as a whole: one time for its items.
TEST(ResponseTimes, CountAnAssignmentOnce) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  made.add_person("p0", "F");
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("A", "height_map", "metal"), surface_of("B", "height_map", "stone")};
  trial.answers = {"metal", "stone"};
  trial.right = trial.answers;
  trial.options = trial.answers;
  trial.from_cue_s = 3.0;
  made.add_session("p0", protocol, {trial, trial});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(times_row(outcome, "all", "")[3], Cell{std::int64_t{2}});
  EXPECT_NEAR(number(times_row(outcome, "all", "")[4]), 3.0, 1e-12);
  EXPECT_EQ(times_in(outcome).table.rows.size(), 1U);  // trials differ in nothing
}

TEST(ResponseTimes, OfMagnitudesAreByConditionAndSpacing) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("roughness", "magnitude",
                        R"({"estimation": {"spacing": "period", "condition": "probe"},
          "factors": {"period": {"levels": [0.001, 0.002]}, "probe": {"levels": ["small", "big"]}}})");
  made.add_person("p0", "F");
  std::vector<MadeUpTrial> trials{};
  for (const char* const probe : {"big", "small"}) {
    for (const double spacing_m : {0.002, 0.001}) {
      MadeUpTrial& trial = trials.emplace_back();
      trial.factors_json = std::string(R"({"probe": ")") + probe + R"(", "period": )" +
                           std::to_string(spacing_m) + "}";
      trial.surfaces = {surface_of("surface", "grating", "grating")};
      trial.answers = {"5"};
      trial.number = 5.0;
      trial.from_cue_s = probe[0] == 'b' ? 8.0 : 2.0;
    }
  }
  made.add_session("p0", protocol, trials);
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_NEAR(number(times_row(outcome, "condition", "big")[4]), 8.0, 1e-12);
  EXPECT_NEAR(number(times_row(outcome, "condition", "small")[4]), 2.0, 1e-12);
  EXPECT_NEAR(number(times_row(outcome, "spacing_m", "0.001")[4]), 4.0, 1e-12);
  std::vector<std::string> levels{};
  for (const std::vector<Cell>& row : times_in(outcome).table.rows) {
    if (row[1] != Cell{}) levels.push_back(std::get<std::string>(row[1]));
  }
  EXPECT_THAT(levels, ElementsAre("small", "big", "0.001", "0.002"));  // as declared; ascending
}

}  // namespace
}  // namespace asperity
