// The tables of anchors: which responses they contain, the change, and that nothing else contains them.

#include "app/findings/shared/anchors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "app/exports/export_study.h"
#include "app/findings/outcome/cell_words.h"
#include "tests/app/analysed_study.h"
#include "tests/app/exported_study.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kRatedWithAnchors = R"({"kind": "rating", "blocks": {"main": {
  "kind": "rating", "question": {"name": "rough", "scale": {"minimum": 1, "maximum": 7}}}}})";

MadeUpTrial rated_trial(const std::string& item, double rating) {
  MadeUpTrial trial{};
  trial.block = "main";
  trial.surfaces = {surface_of(item, "height_map", item)};
  trial.questions = {"rough"};
  trial.answers = {std::to_string(static_cast<int>(rating))};
  trial.number = rating;
  return trial;
}

MadeUpTrial as_anchor(MadeUpTrial trial, AnchorPlace place) {
  trial.repetition = 0;
  if (place != AnchorPlace::start)
    trial.plan_json = R"({"anchor": ")" + std::string(text_of(place)) + "\"}";
  return trial;
}

/// Two items, rated after the first, between and before the last anchor.
std::vector<MadeUpTrial> ratings_with_anchors(double start, double middle, double end) {
  return {as_anchor(rated_trial("metal", start), AnchorPlace::start), rated_trial("metal", 3.0),
          as_anchor(rated_trial("metal", middle), AnchorPlace::middle), rated_trial("wood", 5.0),
          as_anchor(rated_trial("metal", end), AnchorPlace::end)};
}

double number_in_row(const Table& table, std::size_t row, const std::string& column) {
  const Cell cell = cell_of(table, row, column);
  const auto* const whole = std::get_if<std::int64_t>(&cell);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(cell);
}

// Changes of −1, −3 and −2: mean −2, SD 1, t(2) = 4.302653, half width 4.302653/√3 = 2.484138.
TEST(AnchorTables, DescribeTheChangeOfRatingsWithItsInterval) {
  const AnalysisOutcome outcome =
      analysed("rating", kRatedWithAnchors, {},
               {ratings_with_anchors(4, 4, 3), ratings_with_anchors(6, 5, 3),
                ratings_with_anchors(5, 3, 3)});
  const Table& trend = table_of(outcome, kAnchorTrend).table;
  ASSERT_EQ(trend.rows.size(), 1U);
  EXPECT_EQ(cell_of(trend, 0, "block"), Cell{"main"});
  EXPECT_EQ(cell_of(trend, 0, "question"), Cell{"rough"});
  EXPECT_EQ(cell_of(trend, 0, "measure"), Cell{kAnchorRating});
  EXPECT_EQ(cell_of(trend, 0, "persons"), Cell{std::int64_t{3}});
  EXPECT_NEAR(number_in_row(trend, 0, "start"), 5.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "middle"), 4.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "end"), 3.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "change"), -2.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "change_low"), -2.0 - 2.484138, 1e-5);
  EXPECT_NEAR(number_in_row(trend, 0, "change_high"), -2.0 + 2.484138, 1e-5);
}

TEST(AnchorTables, ListTheResponsesInOrder) {
  const AnalysisOutcome outcome =
      analysed("rating", kRatedWithAnchors, {},
               {ratings_with_anchors(4, 6, 3), ratings_with_anchors(2, 2, 2)});
  const Table& anchors = table_of(outcome, kAnchors).table;
  ASSERT_EQ(anchors.rows.size(), 6U);
  std::vector<Cell> places{};
  std::vector<double> responses{};
  for (std::size_t row = 0; row < 3; ++row) {
    places.push_back(cell_of(anchors, row, "place"));
    responses.push_back(number_in_row(anchors, row, "response"));
    EXPECT_EQ(cell_of(anchors, row, "participant"), Cell{"p10"});
  }
  EXPECT_EQ(places, (std::vector<Cell>{"start", "middle", "end"}));
  EXPECT_THAT(responses, ElementsAre(4.0, 6.0, 3.0));
  EXPECT_TRUE(table_of(outcome, kAnchors).lists_trials);
  EXPECT_FALSE(table_of(outcome, kAnchorTrend).lists_trials);
}

/// The outcome of responses to the question "rough" in one run of the block "main" of each participant.
AnalysisOutcome outcome_of_anchors(const std::string& kind,
                                   const std::vector<AnchorResponse>& responses,
                                   const std::vector<std::string>& groups = {}) {
  GatheredAnswers gathered{};
  gathered.kind = kind;
  gathered.groups = groups;
  gathered.anchors = responses;
  for (AnchorResponse& each : gathered.anchors) {
    each.block = "main";
    each.question = "rough";
  }
  AnalysisOutcome outcome{};
  add_anchors(gathered, outcome);
  return outcome;
}

AnchorResponse number_at(const std::string& participant, AnchorPlace place, double number) {
  return {.participant = participant, .place = place, .number = number};
}

AnchorResponse judged_at(const std::string& participant, AnchorPlace place, bool is_correct) {
  return {.participant = participant,
          .place = place,
          .answer = is_correct ? "metal" : "stone",
          .correct = is_correct ? 1.0 : 0.0};
}

TEST(AnchorTables, HaveAChangeOfOneParticipantWithoutAnInterval) {
  const AnalysisOutcome outcome = outcome_of_anchors(
      "rating",
      {number_at("p", AnchorPlace::start, 4.0), number_at("p", AnchorPlace::middle, 3.0)});
  const Table& trend = table_of(outcome, kAnchorTrend).table;
  EXPECT_NEAR(number_in_row(trend, 0, "change"), -1.0, 1e-12) << "not extrapolated to the end";
  EXPECT_EQ(column_of(trend, "change_low"), std::nullopt);
  EXPECT_EQ(column_of(trend, "end"), std::nullopt);
}

TEST(AnchorTables, StateThatTheGroupsArePooled) {
  const std::vector<AnchorResponse> responses{number_at("p", AnchorPlace::start, 4.0),
                                              number_at("p", AnchorPlace::end, 3.0)};
  const auto note_with = [&responses](const std::vector<std::string>& groups) {
    return table_of(outcome_of_anchors("rating", responses, groups), kAnchorTrend).note.english();
  };
  EXPECT_THAT(note_with({"haptic", "visual"}),
              HasSubstr("The participants of all groups are analysed together."));
  EXPECT_THAT(note_with({}), testing::Not(HasSubstr("groups")));
}

// A participant's runs are averaged first: changes of −1 and −3, and of 0.
TEST(AnchorTables, WeighEveryParticipantEqually) {
  std::vector<AnchorResponse> responses{};
  for (const auto& [run, last] : {std::pair{1, 4.0}, std::pair{2, 2.0}}) {
    responses.push_back(number_at("a", AnchorPlace::start, 5.0));
    responses.push_back(number_at("a", AnchorPlace::end, last));
    for (std::size_t i = responses.size() - 2; i < responses.size(); ++i) {
      responses[i].block_ordinal = run;
    }
  }
  responses.push_back(number_at("b", AnchorPlace::start, 3.0));
  responses.push_back(number_at("b", AnchorPlace::end, 3.0));
  const AnalysisOutcome outcome = outcome_of_anchors("rating", responses);
  const Table& trend = table_of(outcome, kAnchorTrend).table;
  EXPECT_NEAR(number_in_row(trend, 0, "change"), -1.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "start"), 4.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "end"), 3.0, 1e-12);
}

// The run of b ended before its last anchor: neither its start nor its middle is in a mean. The tracks of c had no middle.
TEST(AnchorTables, AverageTheSameRunsAtBothEnds) {
  const AnalysisOutcome outcome = outcome_of_anchors(
      "rating", {number_at("a", AnchorPlace::start, 5.0), number_at("a", AnchorPlace::middle, 1.0),
                 number_at("a", AnchorPlace::end, 4.0), number_at("b", AnchorPlace::start, 1.0),
                 number_at("b", AnchorPlace::middle, 7.0), number_at("c", AnchorPlace::start, 3.0),
                 number_at("c", AnchorPlace::end, 3.0)});
  const Table& trend = table_of(outcome, kAnchorTrend).table;
  EXPECT_EQ(cell_of(trend, 0, "persons"), Cell{std::int64_t{2}});
  EXPECT_NEAR(number_in_row(trend, 0, "start"), 4.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "middle"), 1.0, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "end"), 3.5, 1e-12);
  EXPECT_NEAR(number_in_row(trend, 0, "change"), -0.5, 1e-12);
}

TEST(AnchorTables, AreTheOnlyPlaceOfTheirResponses) {
  const std::vector<std::vector<MadeUpTrial>> with{ratings_with_anchors(1, 1, 1),
                                                   ratings_with_anchors(7, 7, 7)};
  std::vector<std::vector<MadeUpTrial>> without{};
  for (const std::vector<MadeUpTrial>& trials : with) {
    without.emplace_back();
    for (const MadeUpTrial& trial : trials) {
      if (trial.repetition > 0) without.back().push_back(trial);
    }
  }
  const AnalysisOutcome one = analysed("rating", kRatedWithAnchors, {}, with);
  const AnalysisOutcome other = analysed("rating", kRatedWithAnchors, {}, without);
  EXPECT_EQ(one.answers, other.answers);
  EXPECT_EQ(one.count.planned_trials, 4U);
  EXPECT_EQ(find_table(other, kAnchors), nullptr);
  EXPECT_EQ(table_of(one, "ratings").table.rows, table_of(other, "ratings").table.rows);
  ASSERT_EQ(one.findings.size(), other.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].value, other.findings[i].value) << one.findings[i].quantity;
    EXPECT_EQ(one.findings[i].n, other.findings[i].n) << one.findings[i].quantity;
  }
}

// The tracks of this run ended before their first trial, as an external program can state.
TEST(AnchorTables, StateThePlaceOfThePlan) {
  const std::vector<MadeUpTrial> only_end{as_anchor(rated_trial("metal", 2.0), AnchorPlace::end)};
  const AnalysisOutcome outcome =
      analysed("rating", kRatedWithAnchors, {},
               {ratings_with_anchors(4, 6, 3), ratings_with_anchors(5, 6, 3), only_end});
  const Table& anchors = table_of(outcome, kAnchors).table;
  ASSERT_EQ(anchors.rows.size(), 7U);
  EXPECT_EQ(cell_of(anchors, 6, "place"), Cell{"end"});
}

TEST(AnchorTables, LeaveOutInvalidAttempts) {
  std::vector<MadeUpTrial> trials = ratings_with_anchors(4, 6, 3);
  trials[2].valid = false;
  const AnalysisOutcome outcome =
      analysed("rating", kRatedWithAnchors, {}, {trials, ratings_with_anchors(4, 6, 3)});
  EXPECT_EQ(table_of(outcome, kAnchors).table.rows.size(), 5U);
}

// They are the reference of a scale.
TEST(AnchorTables, AreAbsentIfAllAnchorsAreAtTheStart) {
  const std::vector<MadeUpTrial> trials{as_anchor(rated_trial("metal", 4.0), AnchorPlace::start),
                                        rated_trial("metal", 3.0), rated_trial("wood", 5.0)};
  const AnalysisOutcome outcome = analysed("rating", kRatedWithAnchors, {}, {trials, trials});
  EXPECT_EQ(find_table(outcome, kAnchors), nullptr);
  EXPECT_NE(find_table(outcome, "ratings"), nullptr);
}

// Both participants halve their estimates, on scales of their own.
TEST(AnchorTables, DescribeTheChangeOfEstimatesAsARatio) {
  const AnalysisOutcome outcome = outcome_of_anchors(
      "magnitude",
      {number_at("a", AnchorPlace::start, 80.0), number_at("a", AnchorPlace::end, 40.0),
       number_at("b", AnchorPlace::start, 20.0), number_at("b", AnchorPlace::end, 10.0)});
  const Table& trend = table_of(outcome, kAnchorTrend).table;
  EXPECT_EQ(cell_of(trend, 0, "measure"), Cell{kAnchorEstimate});
  EXPECT_NEAR(number_in_row(trend, 0, "start"), 40.0, 1e-9) << "the geometric mean";
  EXPECT_NEAR(number_in_row(trend, 0, "end"), 20.0, 1e-9);
  EXPECT_NEAR(number_in_row(trend, 0, "change"), 0.5, 1e-12);
  EXPECT_EQ(column_of(trend, "middle"), std::nullopt);
}

TEST(AnchorTables, HaveNoIntervalOfProportionsCorrect) {
  const AnalysisOutcome outcome = outcome_of_anchors(
      "recognition",
      {judged_at("a", AnchorPlace::start, true), judged_at("a", AnchorPlace::end, true),
       judged_at("b", AnchorPlace::start, true), judged_at("b", AnchorPlace::end, false),
       judged_at("c", AnchorPlace::start, false), judged_at("c", AnchorPlace::end, false),
       judged_at("d", AnchorPlace::start, true), judged_at("d", AnchorPlace::end, true)});
  const StoredTable& trend = table_of(outcome, kAnchorTrend);
  EXPECT_EQ(cell_of(trend.table, 0, "measure"), Cell{kAnchorCorrect});
  EXPECT_NEAR(number_in_row(trend.table, 0, "start"), 0.75, 1e-12);
  EXPECT_NEAR(number_in_row(trend.table, 0, "end"), 0.5, 1e-12);
  EXPECT_NEAR(number_in_row(trend.table, 0, "change"), -0.25, 1e-12);
  EXPECT_EQ(column_of(trend.table, "change_low"), std::nullopt);
  EXPECT_THAT(trend.note.english(), HasSubstr("have no CI"));
}

TEST(AnchorTables, HaveNoChangeOfChoicesThatAreNeitherCorrectNorIncorrect) {
  const AnalysisOutcome outcome = outcome_of_anchors(
      "selection", {{.participant = "a", .answer = "sinusoid"},
                    {.participant = "a", .place = AnchorPlace::end, .answer = "plain"}});
  EXPECT_EQ(table_of(outcome, kAnchors).table.rows.size(), 2U);
  EXPECT_EQ(find_table(outcome, kAnchorTrend), nullptr);
}

// Of an assignment, the proportion of its items.
TEST(GatheredAnchors, HaveTheItemsOfAnAssignment) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial trial{};
  trial.block = "main";
  trial.surfaces = {surface_of("metal", "height_map", "metal"),
                    surface_of("stone", "height_map", "stone")};
  trial.answers = {"metal", "wood"};
  trial.right = {"metal", "stone"};
  trial.options = {"metal", "stone", "wood"};
  made.add_session(
      "anna",
      made.add_protocol("matched", "matching",
                        R"({"blocks": {"main": {"question": {"name": "which"}}}})"),
      {as_anchor(trial, AnchorPlace::start), trial, trial, as_anchor(trial, AnchorPlace::end)});
  const std::vector<GatheredAnswers> all = gather_answers(made.study(), std::nullopt, {});
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all.front().anchors.size(), 2U);
  const AnchorResponse& last = all.front().anchors.back();
  EXPECT_EQ(last.answer, "metal, wood");
  EXPECT_EQ(last.correct, 0.5);
  EXPECT_EQ(last.number, std::nullopt);
  EXPECT_EQ(last.place, AnchorPlace::end);
  EXPECT_EQ(last.question, "which");
}

// Ratings on seven points about a level from which the participants drift by one point: rounding makes
// the changes discrete, and the interval of t must still contain the true mean change.
TEST(AnchorTables, CoverTheChangeOfRatingsOnSevenPoints) {
  constexpr int kStudies = 300;
  constexpr int kParticipants = 6;
  Random random = Random(9).split("anchors");
  const auto rating = [&random](double mean) {
    return std::clamp(std::round(mean + 1.1 * random.normal()), 1.0, 7.0);
  };
  int covered = 0;
  int intervals = 0;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<AnchorResponse> responses{};
    for (int person = 0; person < kParticipants; ++person) {
      const std::string label = std::to_string(person);
      responses.push_back(number_at(label, AnchorPlace::start, rating(4.5)));
      responses.push_back(number_at(label, AnchorPlace::end, rating(3.5)));
    }
    const AnalysisOutcome outcome = outcome_of_anchors("rating", responses);
    const Table& trend = table_of(outcome, kAnchorTrend).table;
    if (!column_of(trend, "change_low")) continue;
    ++intervals;
    // Σ k·P(k) of the rounded normal distributions with the means 3.5 and 4.5.
    constexpr double kTrue = -0.99361;
    covered += number_in_row(trend, 0, "change_low") <= kTrue &&
               kTrue <= number_in_row(trend, 0, "change_high");
  }
  EXPECT_GT(intervals, 290);
  EXPECT_GE(covered, static_cast<int>(0.92 * intervals));
}

TEST(AnchorExport, NamesThePlaceOfAnAnchorAndCountsNone) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  std::vector<MadeUpTrial> trials = ratings_with_anchors(4, 6, 3);
  MadeUpTrial caught = rated_trial("wood", 1.0);
  caught.repetition = 0;
  caught.is_catch = true;
  trials.push_back(caught);
  made.add_session("anna", made.add_protocol("rated", "rating", kRatedWithAnchors), trials);
  const Exported tables(made);
  const Table planned = tables.table("trials");
  std::vector<Cell> places{};
  for (std::size_t row = 0; row < planned.rows.size(); ++row) {
    places.push_back(cell_of(planned, row, "anchor"));
  }
  EXPECT_EQ(places, (std::vector<Cell>{Cell{"start"}, Cell{}, Cell{"middle"}, Cell{}, Cell{"end"},
                                       Cell{}}));
  const Table attempts = tables.table("attempts");
  std::vector<Cell> counted{};
  for (std::size_t row = 0; row < attempts.rows.size(); ++row) {
    counted.push_back(cell_of(attempts, row, "counts_in_analyses"));
  }
  EXPECT_EQ(counted, (std::vector<Cell>{"0", "1", "0", "1", "0", "0"}));
}

}  // namespace
}  // namespace asperity
