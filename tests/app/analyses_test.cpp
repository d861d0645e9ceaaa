// The chapter's three experiments, rebuilt answer by answer from its printed counts.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <stop_token>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/number_text.h"
#include "app/cli/output/analysis_output.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/study/estimate_sentences.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/analysed_study.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

testing::Matcher<const Phrase&> says(const std::string& words) {
  return testing::Property(&Phrase::english, testing::HasSubstr(words));
}

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> kModels{"height_map", "sinusoid", "stochastic"};
const std::vector<std::string> kTextures{"metal", "stone", "wood", "brick"};
const std::vector<std::string> kPictures{"metal", "stone", "wood", "brick", "gravel", "grass"};

std::string person(int number) { return "p" + std::to_string(100 + number); }

/// The first ten are women, as in the chapter.
void add_twenty_people(MadeUpStudy& made) {
  for (int i = 0; i < 20; ++i) made.add_person(person(i), i < 10 ? "F" : "M");
}

std::string in_column(int column) { return R"({"column": )" + std::to_string(column) + "}"; }

MadeUpTrial choice_among_models(const std::string& chosen, const std::string& texture) {
  MadeUpTrial trial{};
  for (const std::string& model : kModels) {
    trial.surfaces.push_back(surface_of(model, model, texture));
  }
  trial.answers = {chosen};
  trial.options = kModels;
  return trial;
}

/// Table 1: of twenty people 12, 7 and 1 in the first column, 11, 8 and 1, and 13, 7 and 0.
AnalysisOutcome analyze_selections_of_the_chapter() {
  MadeUpStudy made;
  add_twenty_people(made);
  constexpr std::array<std::array<int, 3>, 3> kChosen{{{12, 7, 1}, {11, 8, 1}, {13, 7, 0}}};
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  for (int i = 0; i < 20; ++i) {
    std::vector<MadeUpTrial> trials{};
    for (int column = 1; column <= 3; ++column) {
      const auto& counts = kChosen[static_cast<std::size_t>(column - 1)];
      const std::size_t model = i < counts[0] ? 0 : i < counts[0] + counts[1] ? 1 : 2;
      trials.push_back(choice_among_models(kModels[model], kTextures[0]));
      trials.back().factors_json = in_column(column);
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Worked out once: every row is a file synced to disk.
const AnalysisOutcome& selections_of_the_chapter() {
  static const AnalysisOutcome kOutcome = analyze_selections_of_the_chapter();
  return kOutcome;
}

MadeUpTrial made_up_matching(const std::vector<std::string>& answers) {
  MadeUpTrial trial{};
  for (const std::string& texture : kTextures) {
    trial.surfaces.push_back(surface_of(texture, "height_map", texture));
  }
  trial.answers = answers;
  trial.right = kTextures;
  trial.options = kTextures;
  return trial;
}

MadeUpTrial recognition(const std::string& felt, const std::string& answer) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(felt, "height_map", felt)};
  trial.answers = {answer};
  trial.right = {felt};
  trial.options = kPictures;
  return trial;
}

/// The cells of a row, found by its first cells.
const std::vector<Cell>& row_of(const Table& table, const std::vector<std::string>& keys) {
  for (const std::vector<Cell>& row : table.rows) {
    bool same = true;
    for (std::size_t i = 0; i < keys.size(); ++i) same = same && row[i] == Cell{keys[i]};
    if (same) return row;
  }
  throw std::runtime_error("no row " + keys.front());
}

const Cell& cell_named(const Table& table, const std::vector<std::string>& keys,
                       const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) throw std::runtime_error("no column " + column);
  return row_of(table, keys)[static_cast<std::size_t>(found - table.columns.begin())];
}

double number(const Table& table, const std::vector<std::string>& keys, const std::string& column) {
  const Cell& cell = cell_named(table, keys, column);
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  return std::get<double>(cell);
}

TEST(Selection, ReproducesTheChaptersFirstTable) {
  const Table& table = table_of(selections_of_the_chapter(), "table_1").table;
  EXPECT_THAT(table.columns, ElementsAre("item", "column_1", "column_2", "column_3", "all"));
  using Row = std::vector<Cell>;
  const auto n = [](std::int64_t count) { return Cell{count}; };
  EXPECT_THAT(table.rows, ElementsAre(Row{"height_map", n(12), n(11), n(13), n(36)},
                                      Row{"sinusoid", n(7), n(8), n(7), n(22)},
                                      Row{"stochastic", n(1), n(1), n(0), n(2)}));
}

// 12 of 20: Clopper–Pearson [0.36, 0.81], Wilson [0.39, 0.78]; against 1/3 the exact p is 0.016.
TEST(Selection, GivesSharesWithBothIntervalsAndTheExactTest) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& shares = table_of(outcome, "shares").table;
  const std::vector<std::string> keys{"1", "height_map"};
  EXPECT_DOUBLE_EQ(number(shares, keys, "share"), 0.60);
  EXPECT_NEAR(number(shares, keys, "clopper_pearson_low"), 0.36, 0.005);
  EXPECT_NEAR(number(shares, keys, "clopper_pearson_high"), 0.81, 0.005);
  EXPECT_NEAR(number(shares, keys, "wilson_low"), 0.39, 0.005);
  EXPECT_NEAR(number(shares, keys, "wilson_high"), 0.78, 0.005);
  EXPECT_DOUBLE_EQ(number(shares, keys, "chance"), 1.0 / 3.0);
  EXPECT_NEAR(number(shares, keys, "p"), 0.016, 0.0005);
  EXPECT_EQ(number(shares, {"all", "height_map"}, "of"), 60);
  EXPECT_EQ(number(shares, {"all", "height_map"}, "persons"), 20);
}

// 12 against 7 among 19: p = 0.36. The chapter's claim of superiority does not survive this row.
TEST(Selection, SetsTwoModelsAgainstEachOtherAmongTheChoicesOfEither) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& pairs = table_of(outcome, "pairs").table;
  const std::vector<std::string> keys{"1", "height_map", "sinusoid"};
  EXPECT_EQ(number(pairs, keys, "chosen"), 12);
  EXPECT_EQ(number(pairs, keys, "of"), 19);
  EXPECT_NEAR(number(pairs, keys, "p"), 0.36, 0.005);
}

TEST(Selection, CountsCannotTellButKeepsItOutOfTheShares) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_person("b", "M");
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  std::vector<MadeUpTrial> trials{choice_among_models("sinusoid", "wood"),
                                  choice_among_models("cannot_tell", "wood")};
  for (MadeUpTrial& trial : trials) trial.options.push_back("cannot_tell");
  made.add_session("a", protocol, {trials[0]});
  made.add_session("b", protocol, {trials[1]});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(number(table_of(outcome, "table_1").table, {"cannot_tell"}, "all"), 1);
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_EQ(number(shares, {"all", "sinusoid"}, "of"), 1);
  EXPECT_DOUBLE_EQ(number(shares, {"all", "sinusoid"}, "chance"), 1.0 / 3.0);
}

TEST(Selection, LeavesOutWhatSomebodyExcludedAndSaysSo) {
  MadeUpStudy made;
  made.add_person("p1", "F");
  made.add_person("p2", "F");
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  const std::vector<MadeUpTrial> trials{choice_among_models(kModels[0], kTextures[0]),
                                        choice_among_models(kModels[1], kTextures[0])};
  const std::int64_t first = made.add_session("p1", protocol, trials);
  const std::int64_t second = made.add_session("p2", protocol, trials);
  made.study().add_decision(
      first, {.trial = 2, .attempt = 1, .verdict = Verdict::exclude, .reason = "coughed"});
  EXPECT_EQ(analyze_study(made.study()).at(0).answers, 3U);
  made.study().add_decision(second, {.verdict = Verdict::exclude, .reason = "was asleep"});
  const AnalysisOutcome outcome = analyze_study(made.study()).at(0);
  EXPECT_EQ(outcome.answers, 1U);
  EXPECT_THAT(outcome.remarks, testing::Contains(says("3 excluded")));
}

TEST(Selection, WarnsWherePersonsArePooledAndGivesThePersonsAsUnit) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  EXPECT_THAT(outcome.remarks, testing::Contains(says("60 trials of 20 participants")));
  const Table& persons = table_of(outcome, "persons").table;
  EXPECT_EQ(number(persons, {"height_map"}, "persons"), 20);
  EXPECT_NEAR(number(persons, {"height_map"}, "mean"), 0.60, 1e-12);
  EXPECT_DOUBLE_EQ(number(persons, {"height_map"}, "minimum"), 0.0);
}

TEST(Selection, SetsTheAchievedTextureForceBesideTheOneAimedAt) {
  MadeUpStudy made;
  made.add_person("a", "F");
  MadeUpTrial trial = choice_among_models("sinusoid", "wood");
  for (PresentationRow& surface : trial.surfaces) {
    surface.matched_texture_force_N = 0.2;
    surface.achieved_texture_force_N = surface.model == "stochastic" ? 0.3 : 0.1;
  }
  made.add_session("a", made.add_protocol("selection", "selection"), {trial, trial});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const Table& force = table_of(outcome, "texture_force").table;
  EXPECT_EQ(number(force, {"stochastic"}, "surfaces"), 2);
  EXPECT_DOUBLE_EQ(number(force, {"stochastic"}, "matched_mean_N"), 0.2);
  EXPECT_DOUBLE_EQ(number(force, {"stochastic"}, "achieved_mean_N"), 0.3);
}

// Table 2 by sex: 9, 9 and 8 of ten women, 9, 10 and 9 of ten men have all four right. Whoever is
// wrong exchanges the last two.
AnalysisOutcome analyze_matchings_of_the_chapter() {
  MadeUpStudy made;
  add_twenty_people(made);
  constexpr std::array<int, 3> kWomen{9, 9, 8};
  constexpr std::array<int, 3> kMen{9, 10, 9};
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  for (int i = 0; i < 20; ++i) {
    std::vector<MadeUpTrial> trials{};
    for (std::size_t column = 0; column < 3; ++column) {
      const bool right = i < 10 ? i < kWomen[column] : i - 10 < kMen[column];
      trials.push_back(right ? made_up_matching(kTextures)
                             : made_up_matching({"metal", "stone", "brick", "wood"}));
      trials.back().factors_json = in_column(static_cast<int>(column) + 1);
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Worked out once: every row is a file synced to disk.
const AnalysisOutcome& matchings_of_the_chapter() {
  static const AnalysisOutcome kOutcome = analyze_matchings_of_the_chapter();
  return kOutcome;
}

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

TEST(AnalyzeStudy, SaysWhenTheAnswersAreGuessesByDeclaration) {
  MadeUpStudy made;
  made.add_virtual("virtual0001", "F");
  made.set_observer(R"({"expectation": "true_surface", "deaf": true})");
  made.add_session("virtual0001", made.add_protocol("recognition", "recognition"),
                   {recognition("stone", "stone")}, SessionMode::simulate);
  EXPECT_THAT(analyze_study(made.study()).front().remarks,
              testing::Contains(says("responses are guesses: 1")));
}

TEST(AnalyzeStudy, NeverMixesPeoplePilotsAndVirtualParticipants) {
  MadeUpStudy made;
  made.add_person("person", "F");
  made.add_person("pilot", "M");
  made.add_virtual("virtual0001", "F");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  const MadeUpTrial trial = recognition("stone", "stone");
  made.add_session("person", protocol, {trial});
  made.add_session("pilot", protocol, {trial, trial}, SessionMode::pilot);
  made.add_session("virtual0001", protocol, {trial, trial, trial}, SessionMode::simulate);
  const std::vector<AnalysisOutcome> outcomes = analyze_study(made.study());
  ASSERT_EQ(outcomes.size(), 3u);
  const std::array<AnswerGroup, 3> groups{AnswerGroup::people, AnswerGroup::pilot,
                                          AnswerGroup::virtual_participants};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(outcomes[i].group, groups[i]);
    EXPECT_EQ(number(table_of(outcomes[i], "shares").table, {"all", "Total"}, "of"),
              static_cast<double>(i + 1));
  }
}

// A virtual participant may be given a session of another mode; that makes nobody a person.
TEST(AnalyzeStudy, TakesAVirtualParticipantForVirtualInEveryMode) {
  MadeUpStudy made;
  made.add_virtual("virtual0001", "F");
  made.add_session("virtual0001", made.add_protocol("recognition", "recognition"),
                   {recognition("stone", "stone")}, SessionMode::run);
  const std::vector<AnalysisOutcome> outcomes = analyze_study(made.study());
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].group, AnswerGroup::virtual_participants);
}

TEST(AnalyzeStudy, CountsOnlyValidAnswersOfTheMainPhase) {
  MadeUpStudy made;
  made.add_person("a", "F");
  MadeUpTrial practice = recognition("stone", "stone");
  practice.phase = "practice";
  MadeUpTrial flagged = recognition("stone", "stone");
  flagged.flagged = true;
  MadeUpTrial invalid = recognition("stone", "stone");
  invalid.valid = false;
  MadeUpTrial late = invalid;
  late.outcome = AttemptOutcome::timed_out;
  late.answers.clear();
  late.right.clear();
  made.add_session("a", made.add_protocol("recognition", "recognition"),
                   {practice, flagged, invalid, late});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_EQ(number(table_of(outcome, "shares").table, {"all", "Total"}, "of"), 1);
  EXPECT_EQ(outcome.count.planned_trials, 3u);
  EXPECT_EQ(outcome.count.flagged, 1u);
  EXPECT_THAT(outcome.count.not_counted,
              ElementsAre(std::pair<const std::string, std::size_t>("answered but invalid", 1),
                          std::pair<const std::string, std::size_t>("timed_out", 1)));
}

TEST(AnalyzeStudy, NamesTheProtocolsThereAreWhenAskedForAnother) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session("a", made.add_protocol("recognition", "recognition"),
                   {recognition("stone", "stone")});
  EXPECT_THAT(refusal_of<ResultsError>([&] { analyze_study(made.study(), "matching"); }),
              HasSubstr("\"matching\"; choose a protocol that has sessions: \"recognition\""));
}

TEST(AnalyzeStudy, NeitherWaitsForNorRefusesABrokenFileOnceItWasAskedToStop) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session("a", made.add_protocol("recognition", "recognition"),
                   std::vector(60, recognition("stone", "stone")));  // the last page holds rows
  const std::filesystem::path folder = made.beside("broken");
  made.study().copy_to(folder);
  constexpr std::size_t kPage = 4096;
  std::string content = read_file(folder / "study.sqlite");
  content.replace(content.size() - kPage, kPage, kPage, '\x5a');
  write_file(folder / "study.sqlite", content, Overwrite::allow);
  const Study broken = Study::open(folder, Access::read_only);
  EXPECT_THROW(analyze_study(broken), ResultsError);
  std::stop_source stop{};
  stop.request_stop();
  EXPECT_TRUE(analyze_study(broken, {}, stop.get_token()).empty());
}

TEST(AnalysisOutput, PutsIntervalsInBracketsForReaders) {
  const std::string text = reading_text_of(selections_of_the_chapter());
  EXPECT_THAT(text, testing::StartsWith("selection 1 (selection, chapter): people\n"));
  EXPECT_THAT(text, testing::ContainsRegex("1 +height_map +12  20 +20  \\.60 +\\[\\.39, \\.78\\] +"
                                           "\\[\\.36, \\.81\\] +\\.333 +\\.016\n"));
}

TEST(AnalysisOutput, KeepsAllDigitsForPrograms) {
  const std::string text = analysis_json("made up", std::span(&selections_of_the_chapter(), 1));
  EXPECT_THAT(text, testing::StartsWith("{\n  \"format\": \"asperity.analysis/1\""));
  EXPECT_THAT(text, HasSubstr("\"chance\": 0.3333333333333333"));
}

TEST(AnalyzeStudy, HasAFindingForEveryNumberOfATable) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_session("a", made.add_protocol("recognition", "recognition"),
                   {recognition("stone", "stone")});
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  const auto found =
      std::find_if(outcome.findings.begin(), outcome.findings.end(), [](const Finding& finding) {
        return finding.quantity == "share_correct" && finding.key == "column=all person=Female" &&
               finding.method == "Clopper–Pearson interval";
      });
  ASSERT_NE(found, outcome.findings.end());
  EXPECT_EQ(found->value, 1.0);
  EXPECT_NEAR(found->low.value(), 0.025, 1e-12);  // (0.05/2)^(1/1)
  EXPECT_EQ(found->n, 1u);
}

// Every person has the same choice in a column, so that the table of all is the chapter's.
TEST(Selection, AnswersItsQuestionWithThePersonAsTheUnit) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const AnsweredQuestion& preference = question_of(outcome, "preference");
  EXPECT_EQ(&preference, &outcome.questions.front());
  EXPECT_THAT(preference.answer.english(),
              testing::StartsWith("height_map was chosen most often: in 60 % of a participant's "
                                  "choices on average (95 % CI "));
  EXPECT_THAT(preference.answer.english(), HasSubstr("compared with a chance level of 33 %"));
  EXPECT_EQ(preference.finding.n, 20U);
  EXPECT_EQ(preference.finding.quantity, "subj.mean");
  EXPECT_TRUE(preference.finding.low.has_value());
}

// 1, 1, 1, 1, 1 and 0.5 of the choices: Student's interval of the mean goes to 1.13, that on the logit scale does not
// leave 0 to 1.
TEST(Selection, SaysTheIntervalOfAShareInSentenceAndTableAsFarAsSharesGo) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("pair", "selection");
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "F");
    std::vector<MadeUpTrial> trials{};
    for (int trial = 0; trial < 2; ++trial) {
      MadeUpTrial& one = trials.emplace_back();
      // What is second is always the one.
      one.options = {"old", "new"};
      for (const std::string& model : one.options) {
        one.surfaces.push_back(surface_of(model, model, "wood"));
      }
      one.answers = {person == 5 && trial == 1 ? "old" : "new"};
    }
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = analyze_study(made.study()).front();
  EXPECT_GT(finding_of(outcome, "choice", "subj.ci.upper", "new").value.value(), 1.1);
  const double high = finding_of(outcome, "choice", "subj.mean", "new").high.value();
  EXPECT_GT(high, 0.95);
  EXPECT_LT(high, 1.0);
  EXPECT_EQ(number(table_of(outcome, "persons").table, {"new"}, "mean_high"), high);
  EXPECT_NEAR(number(table_of(outcome, "persons").table, {"old"}, "mean_low"), 1.0 - high, 1e-12);
  EXPECT_THAT(question_of(outcome, "preference").answer.english(), HasSubstr("(95 % CI "));
  // The position that stands out is named, not the first one alone.
  const AnsweredQuestion& position = question_of(outcome, "position");
  EXPECT_THAT(position.answer.english(),
              AllOf(testing::StartsWith("Test of equal proportions: p "),
                    HasSubstr("position 2 was chosen in 92 % of a participant's "
                              "choices on average (95 % CI ")));
  EXPECT_EQ(position.finding.key, "2");
}

// 20 people, each three times: whatever a table says of all of them, the family says too.
TEST(Selection, HasItsNumbersFromTheFamily) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& shares = table_of(outcome, "shares").table;
  EXPECT_EQ(finding_of(outcome, "choice", "count", "POOLED|height_map").value, 36.0);
  EXPECT_EQ(finding_of(outcome, "choice", "prop", "POOLED|height_map").value,
            number(shares, {"all", "height_map"}, "share"));
  EXPECT_EQ(finding_of(outcome, "choice", "wilson.lower", "POOLED|height_map").value,
            number(shares, {"all", "height_map"}, "wilson_low"));
  const Table& persons = table_of(outcome, "persons").table;
  EXPECT_EQ(finding_of(outcome, "choice", "subj.mean", "sinusoid").value,
            number(persons, {"sinusoid"}, "mean"));
  EXPECT_LT(number(persons, {"sinusoid"}, "mean_low"), number(persons, {"sinusoid"}, "mean"));
}

// Luce's worths of the best of three are the shares: 36, 22 and 2 of 60.
TEST(Selection, PutsTheModelsOnAScale) {
  const Table& scale = table_of(selections_of_the_chapter(), "scale").table;
  EXPECT_NEAR(number(scale, {"height_map"}, "worth"), 0.6, 1e-9);
  EXPECT_NEAR(number(scale, {"stochastic"}, "worth"), 2.0 / 60.0, 1e-9);
  EXPECT_NEAR(number(scale, {"height_map"}, "log_worth") - number(scale, {"sinusoid"}, "log_worth"),
              std::log(36.0 / 22.0), 1e-9);
  EXPECT_LT(number(scale, {"sinusoid"}, "log_worth_low"), number(scale, {"sinusoid"}, "log_worth"));
}

/// Six people choose between two models, four times each: 4, 4, 3, 3, 2 and 4 times the first.
AnalysisOutcome analyze_pairs(const std::string& source) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("pair", "selection", source);
  const std::array<int, 6> firsts{4, 4, 3, 3, 2, 4};
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    made.add_person("p" + std::to_string(i), "F");
    std::vector<MadeUpTrial> trials{};
    for (int trial = 0; trial < 4; ++trial) {
      MadeUpTrial& one = trials.emplace_back();
      one.options = {"old", "new"};
      if (trial % 2 == 1) std::swap(one.options[0], one.options[1]);
      for (const std::string& model : one.options) {
        one.surfaces.push_back(surface_of(model, model, trial < 2 ? "wood" : "metal"));
      }
      one.answers = {trial < firsts[i] ? "new" : "old"};
    }
    made.add_session("p" + std::to_string(i), protocol, trials);
  }
  return analyze_study(made.study()).front();
}

// The differences are 4, 4, 2, 2, 0 and 4 of one sign: of 2⁵ patterns of signs two are as far.
TEST(Selection, FlipsSignsWithinPersons) {
  const AnalysisOutcome outcome = analyze_pairs("{}");
  EXPECT_DOUBLE_EQ(finding_of(outcome, "choice", "signflip.p.two", "new|old").value.value(),
                   2.0 / 32.0);
  EXPECT_DOUBLE_EQ(number(table_of(outcome, "tests").table, {"pairs", "new|old"}, "p"), 2.0 / 32.0);
  // 20 wins to 4: Bradley and Terry's distance is ln 5.
  EXPECT_NEAR(number(table_of(outcome, "scale").table, {"new"}, "log_worth"), std::log(5.0) / 2.0,
              1e-9);
  EXPECT_NO_THROW(finding_of(outcome, "scale", "bt.order.beta", "first"));
}

TEST(StudyTests, AdjustTheFamilyThatTheProtocolDeclares) {
  const AnalysisOutcome outcome =
      analyze_pairs(R"({"analysis": {"target": "new", "family": ["target_pairs", "position"]}})");
  const NamedTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note,
              says("over the 2 confirmatory tests, the family that the protocol declares"));
  const double pair = number(tests.table, {"target_pairs", "new|old"}, "p");
  EXPECT_DOUBLE_EQ(pair, 2.0 / 32.0);
  EXPECT_DOUBLE_EQ(number(tests.table, {"target_pairs", "new|old"}, "p_holm"), 2.0 * pair);
  EXPECT_EQ(cell_named(tests.table, {"preference"}, "p_holm"), Cell{});
  EXPECT_EQ(cell_named(tests.table, {"position"}, "family"), Cell{"target_pairs, position"});
  EXPECT_EQ(finding_of(outcome, "tests", "p.holm", "test=target_pairs about=new|old").value,
            2.0 * pair);
  EXPECT_THAT(question_of(outcome, "pairs").answer.english(), HasSubstr(", Holm-corrected"));
  EXPECT_THAT(question_of(outcome, "textures").question.english(), HasSubstr("for new"));
}

TEST(StudyTests, SayThatAFamilyOfOneTestLeavesItsPAsItIs) {
  const AnalysisOutcome outcome =
      analyze_pairs(R"({"analysis": {"target": "new", "family": ["preference"]}})");
  const NamedTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note, says("The family that the protocol declares has one test (preference)"));
  EXPECT_DOUBLE_EQ(number(tests.table, {"preference"}, "p_holm"),
                   number(tests.table, {"preference"}, "p"));
  EXPECT_THAT(finding_of(outcome, "tests", "p.holm", "test=preference").method,
              HasSubstr("the only test of the family preference"));
}

TEST(StudyTests, SayThatNothingWasDeclared) {
  EXPECT_THAT(table_of(analyze_pairs("{}"), "tests").note, says("declares no family of tests"));
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

/// Two people, six goes: stone and metal are mixed up, the rest is right; gravel and grass are only
/// shown.
AnalysisOutcome analyze_recognitions() {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("recognition", "recognition");
  for (const char* label : {"a", "b"}) {
    made.add_person(label, label[0] == 'a' ? "F" : "M");
    std::vector<MadeUpTrial> trials{recognition("stone", "metal"), recognition("stone", "stone"),
                                    recognition("metal", "stone"), recognition("metal", "metal"),
                                    recognition("wood", "wood"),   recognition("brick", "brick")};
    if (label[0] == 'b') trials[2] = recognition("metal", "metal");
    made.add_session(label, protocol, trials);
  }
  return analyze_study(made.study()).front();
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

// The sentence about positions has the mean of the persons, and so has a table for its figure.
TEST(Selection, GivesTheMeansOfPersonsByPosition) {
  const AnalysisOutcome& outcome = selections_of_the_chapter();
  const Table& places = table_of(outcome, "persons_by_position").table;
  EXPECT_EQ(number(places, {"1"}, "persons"), 20);
  EXPECT_NEAR(number(places, {"1"}, "mean"),
              finding_of(outcome, "position", "subj.mean", "1").value.value(), 1e-12);
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
  const NamedTable& tests = table_of(outcome, "tests");
  EXPECT_THAT(tests.note, says("over the 2 confirmatory tests"));
  const double items = number(tests.table, {"items"}, "p");
  EXPECT_DOUBLE_EQ(number(tests.table, {"items"}, "p_holm"), 2.0 * items);
  // No split of all is as far: of the random ones and the observed one only the latter.
  EXPECT_DOUBLE_EQ(number(tests.table, {"sexes", "F|M"}, "p"), 1.0 / 10001.0);
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
  const NamedTable& tests = table_of(outcome, "tests");
  EXPECT_EQ(number(tests.table, {"sexes", "F|M"}, "value"), 2.0);
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

TEST(Matching, NamesChanceOnlyWhereAllGoesAreOfOneSize) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_person("b", "M");
  const std::int64_t protocol = made.add_protocol("matching", "matching");
  MadeUpTrial three = made_up_matching({"metal", "stone", "wood"});
  three.surfaces.pop_back();
  three.right = three.options = three.answers;
  for (const char* label : {"a", "b"})
    made.add_session(label, protocol, {made_up_matching(kTextures), three});
  EXPECT_THAT(question_of(analyze_study(made.study()).front(), "items").answer.english(),
              HasSubstr("compared with a chance level of 1 divided by the number of items, which "
                        "differs between trials"));
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
  EXPECT_THAT(answer, HasSubstr("Nothing is established: p is below .05, but the CI contains the "
                                "chance level"));
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
  EXPECT_THAT(answer, HasSubstr("Nothing is established: p is below .05, but the CI contains the "
                                "chance level"));
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
  EXPECT_DOUBLE_EQ(number(table_of(two, "tests").table, {"pairs", "sinusoid|stochastic"}, "p"),
                   0.5);
  // .5 of each, times three of the family.
  EXPECT_DOUBLE_EQ(
      number(table_of(two, "tests").table, {"pairs", "sinusoid|stochastic"}, "p_smallest"), 1.0);
  EXPECT_THAT(question_of(two, "pairs").answer.english(),
              HasSubstr("; the smallest attainable p is > .999"));
}

// What no analysis can be made of is said, and nothing falls over.
TEST(AnalyzeStudy, RefusesInSentencesWhatCannotBeTested) {
  MadeUpStudy made;
  made.add_person("a", "F");
  made.add_person("b", "M");
  // One participant, one model only.
  MadeUpTrial alone{};
  alone.surfaces = {surface_of("sinusoid", "sinusoid", "wood")};
  alone.answers = {"sinusoid"};
  alone.options = {"sinusoid"};
  made.add_session("a", made.add_protocol("s_one_model", "selection"), {alone});
  // All alike.
  const std::int64_t alike = made.add_protocol("s_alike", "selection");
  for (const char* label : {"a", "b"}) {
    made.add_session(label, alike, {choice_among_models("sinusoid", "wood")});
  }
  // Sets that differ between the trials.
  MadeUpTrial pair = choice_among_models("sinusoid", "wood");
  pair.surfaces.pop_back();
  made.add_session("a", made.add_protocol("s_sets", "selection"),
                   {pair, choice_among_models("stochastic", "metal")});
  // All wrong, all right, one texture only, thirteen items, an unknown kind.
  made.add_session("a", made.add_protocol("r_wrong", "recognition"),
                   {recognition("stone", "metal"), recognition("metal", "stone")});
  const std::int64_t right = made.add_protocol("r_right", "recognition");
  for (const char* label : {"a", "b"}) {
    made.add_session(label, right, {recognition("stone", "stone"), recognition("metal", "metal")});
  }
  made.add_session("a", made.add_protocol("m_right", "matching"), {made_up_matching(kTextures)});
  MadeUpTrial many{};
  for (int i = 0; i < 13; ++i) {
    const std::string name = "t" + std::to_string(10 + i);
    many.surfaces.push_back(surface_of(name, "height_map", name));
    many.answers.push_back(name);
    many.right.push_back(name);
    many.options.push_back(name);
  }
  made.add_session("a", made.add_protocol("m_thirteen", "matching"), {many});
  made.add_session("a", made.add_protocol("unknown", "adjustment"), {alone});

  std::map<std::string, AnalysisOutcome> outcomes{};
  for (AnalysisOutcome& outcome : analyze_study(made.study())) {
    outcomes[outcome.protocol] = std::move(outcome);
  }
  ASSERT_EQ(outcomes.size(), 8U);
  EXPECT_NO_THROW(table_of(outcomes["s_one_model"], "table_1"));
  const AnalysisOutcome& all_alike = outcomes["s_alike"];
  EXPECT_THAT(all_alike.remarks, testing::Contains(says("models cannot be placed on a scale")));
  EXPECT_THAT(question_of(all_alike, "preference").answer.english(), HasSubstr(" %, 100 %])"));
  EXPECT_THAT(outcomes["s_sets"].remarks,
              testing::Contains(says("Not every model is presented in every trial")));
  EXPECT_THAT(question_of(outcomes["s_sets"], "preference").finding.status, HasSubstr("scale"));
  EXPECT_THAT(question_of(outcomes["r_wrong"], "right").answer.english(),
              testing::StartsWith("Not significantly above chance: on average 0 %"));
  EXPECT_EQ(finding_of(outcomes["r_right"], "recognition", "dprime").word, "Inf");
  EXPECT_THAT(question_of(outcomes["r_right"], "right").answer.english(),
              HasSubstr("so there is no test"));
  EXPECT_EQ(finding_of(outcomes["m_right"], "matching", "mallows.theta").word, "Inf");
  EXPECT_THAT(outcomes["m_thirteen"].remarks,
              testing::Contains(says("the matchings are not analysed")));
  EXPECT_THAT(outcomes["unknown"].remarks, testing::Contains(says("kind \"adjustment\"")));
}

constexpr std::array<double, 5> kSpacings_m{0.0005, 0.001, 0.002, 0.004, 0.008};
constexpr const char* kEstimation = R"({
  "estimation": {"spacing": "texture", "condition": "tip"},
  "factors": {"texture": {"levels": ["s1", "s2", "s3", "s4", "s5"]}, "tip": {"levels": ["small", "large"]}},
  "textures": {"s1": {"spacing_m": 0.0005}, "s2": {"spacing_m": 0.001}, "s3": {"spacing_m": 0.002},
               "s4": {"spacing_m": 0.004}, "s5": {"spacing_m": 0.008}},
  "analysis": {"family": ["spacing", "interaction", "peaks"]}
})";

/// `log_of`: the decimal logarithm of the number that a person gives to a level under a tip.
AnalysisOutcome analyze_logarithms(
    int people, const std::function<double(int person, std::size_t level, bool is_small)>& log_of) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", kEstimation);
  for (int i = 0; i < people; ++i) {
    made.add_person(person(i), "F");
    std::vector<MadeUpTrial> trials{};
    for (const std::string tip : {"small", "large"}) {
      for (int level = -1; level < 5; ++level) {  // −1: the anchor
        const std::size_t at = level < 0 ? 2U : static_cast<std::size_t>(level);
        const double number = std::pow(10.0, log_of(i, at, tip == "small"));
        MadeUpTrial trial{};
        trial.surfaces = {surface_of("s", "pd_gradient", "s")};
        trial.factors_json =
            R"({"texture": "s)" + std::to_string(at + 1) + R"(", "tip": ")" + tip + "\"}";
        trial.answers = {text_of_number(level < 0 ? 1e6 : number)};
        trial.repetition = level < 0 ? 0 : 1;
        trials.push_back(trial);
      }
    }
    made.add_session(person(i), protocol, trials);
  }
  return analyze_study(made.study()).at(0);
}

/// Numbers on parabolas of the logarithms, roughest at 1 mm with the small tip and at 2 mm with the
/// large one, a little more or less for each of six people, who all have a scale of their own.
AnalysisOutcome analyze_numbers(int people = 6, double disagreement = 1.0) {
  return analyze_logarithms(people, [disagreement](int i, std::size_t level, bool is_small) {
    // The other way with the other tip, and half as far: people differ in how the tips differ and in
    // the curve over both.
    const double own = disagreement * (is_small ? 0.02 : -0.01) * (i - 2.5);
    const double away = std::log10(kSpacings_m.at(level) / (is_small ? 0.001 : 0.002)) - own;
    return 0.3 * i - away * away;
  });
}

TEST(Magnitudes, PeakWhereTheyWereMadeToPeak) {
  const AnalysisOutcome outcome = analyze_numbers();
  EXPECT_EQ(outcome.answers, 60U);
  EXPECT_EQ(outcome.count.anchors, 12U);
  EXPECT_EQ(outcome.count.planned_trials, 60U);
  const Table& peaks = table_of(outcome, "peaks").table;
  const auto peak_m = [&peaks](const char* tip) {
    return std::get<double>(row_of(peaks, {tip})[2]);
  };
  EXPECT_NEAR(peak_m("small"), 0.001, 1e-9);
  EXPECT_NEAR(peak_m("large"), 0.002, 1e-9);
  EXPECT_EQ(row_of(peaks, {"small"})[1], Cell{});
  EXPECT_EQ(row_of(peaks, {"small"})[9], Cell{std::int64_t{6}});  // inverted U, for everybody
  const auto asked = std::find_if(outcome.questions.begin(), outcome.questions.end(),
                                  [](const AnsweredQuestion& one) { return one.name == "peaks"; });
  ASSERT_NE(asked, outcome.questions.end());
  EXPECT_THAT(asked->answer, says("Peaks of the curves: small at 1 mm (95 % CI "));
  EXPECT_THAT(asked->answer,
              says("test for an interior maximum p < .001; R² of the mean parabola 1.00"));
  const std::string text = estimate_sentence(outcome).text;
  EXPECT_THAT(text, HasSubstr("at 1 mm, 95 % CI ["));
  EXPECT_THAT(text, HasSubstr("(small)"));
  EXPECT_THAT(text, HasSubstr("these curves are not power functions."));
  EXPECT_THAT(text, testing::Not(HasSubstr("exponent")));
}

TEST(Magnitudes, LoseEachParticipantsScaleAndKeepTheRawNumbersBeside) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& estimates = table_of(outcome, "estimates").table;
  ASSERT_EQ(estimates.rows.size(), 60U);
  // Whoever says numbers 10^0.3 times as large: the same shape, but for a peak a little elsewhere.
  const std::vector<Cell>& first = row_of(estimates, {person(0), "small"});
  const std::vector<Cell>& second = row_of(estimates, {person(1), "small"});
  EXPECT_NEAR(std::get<double>(second[4]) / std::get<double>(first[4]), std::pow(10.0, 0.3), 0.15);
  EXPECT_NEAR(std::get<double>(second[5]) / std::get<double>(first[5]), 1.0, 0.08);
  EXPECT_EQ(table_of(outcome, "roughness").table.rows.size(), 10U);
}

// With the large tip the parabola of the means has its maximum near the smallest spacing (0.3 decades below 1 mm), and
// three people's slopes there do not differ significantly from 0.
TEST(Magnitudes, ReportNoMaximumThatTheTestOfAnInteriorOneDoesNotShow) {
  const AnalysisOutcome outcome =
      analyze_logarithms(3, [](int i, std::size_t level, bool is_small) {
        const double x = std::log10(kSpacings_m.at(level) / 0.001);
        const double away = x - 0.05 * (i - 1) + (is_small ? 0.0 : 0.25);
        return -away * away;
      });
  const Table& peaks = table_of(outcome, "peaks").table;
  EXPECT_EQ(row_of(peaks, {"large"})[1], Cell{"no_interior_maximum"});
  EXPECT_EQ(row_of(peaks, {"large"})[2], Cell{});
  EXPECT_GT(number(peaks, {"large"}, "p_interior"), 0.05);
  EXPECT_GT(number(peaks, {"large"}, "r_squared"), 0.9);
  EXPECT_THAT(question_of(outcome, "peaks").answer.english(),
              HasSubstr("large without a significant interior maximum (p = "));
  EXPECT_THAT(table_of(outcome, "tests").table.rows.back().back(),
              Cell{"at least one condition has no interior maximum"});
}

// Their peaks are 0.15 decades apart, which t of one degree of freedom makes an interval of nearly two:
// wider than the spacings.
TEST(Magnitudes, OfTwoPeopleAreTooFewToSayWhereItPeaks) {
  const AnalysisOutcome outcome = analyze_numbers(2, 15.0);
  const std::vector<Cell>& peak = row_of(table_of(outcome, "peaks").table, {"large"});
  EXPECT_EQ(peak[1], Cell{"too_few_to_say"});
  EXPECT_EQ(peak[2], Cell{});
  EXPECT_EQ(peak[3], Cell{});
  const auto asked = std::find_if(outcome.questions.begin(), outcome.questions.end(),
                                  [](const AnsweredQuestion& one) { return one.name == "peaks"; });
  ASSERT_NE(asked, outcome.questions.end());
  EXPECT_THAT(asked->answer, says("large cannot be determined, because with 2 participants"));
}

// Neither by name nor as anybody met them.
TEST(Magnitudes, StandInTheOrderOfConditionsThatTheProtocolLists) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& roughness = table_of(outcome, "roughness").table;
  ASSERT_EQ(roughness.rows.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(roughness.rows[i][0], Cell{i < 5 ? "small" : "large"});
  }
  EXPECT_EQ(table_of(outcome, "peaks").table.rows.at(0)[0], Cell{"small"});
  const std::vector<Cell>& ratio = table_of(outcome, "peak_ratios").table.rows.at(0);
  EXPECT_EQ(ratio[0], Cell{"small"});
  EXPECT_EQ(ratio[1], Cell{"large"});
  const auto curve =
      std::find_if(outcome.findings.begin(), outcome.findings.end(),
                   [](const Finding& finding) { return finding.quantity == "geomean"; });
  ASSERT_NE(curve, outcome.findings.end());
  EXPECT_THAT(curve->key, testing::StartsWith("small|"));
}

TEST(Magnitudes, AreTestedInTheDeclaredFamily) {
  const AnalysisOutcome outcome = analyze_numbers();
  const Table& tests = table_of(outcome, "tests").table;
  for (const char* name : {"spacing", "interaction"}) {
    EXPECT_LT(number(tests, {name}, "p_holm"), 0.05) << name;
  }
  EXPECT_EQ(cell_named(tests, {"condition"}, "p_holm"), Cell{});
  ASSERT_FALSE(outcome.questions.empty());
  EXPECT_EQ(outcome.questions[0].name, "spacing");
  // Degrees of freedom, size and direction beside F: a reader of the sentence needs no table.
  EXPECT_THAT(outcome.questions[0].answer.english(),
              testing::ContainsRegex("Yes: F\\([0-9.]+, [0-9.]+\\) = [0-9.]+, ε = [01]?\\.[0-9]+, "
                                     "partial η² = [01]?\\.[0-9]+, p .*; .* mm was roughest and .* "
                                     "mm least rough .ratio of geometric means: [0-9.]+.\\."));
  EXPECT_THAT(question_of(outcome, "condition").answer.english(),
              testing::ContainsRegex("F\\(1, [0-9]+\\) = .*; .* was rougher than .* by a factor of "
                                     "[0-9.]+ \\(95 % CI \\[[0-9.]+, [0-9.]+\\]\\)\\."));
  EXPECT_THAT(outcome.remarks, testing::Contains(says("Estimates of anchors")));
}

// Five people who disagree wholly about five spacings, but for a hundredth of a decade from one to the
// next: the last one is the greatest in the mean, and that says nothing.
TEST(Magnitudes, HaveNoRoughestSpacingWhereTheTestShowsNone) {
  const AnalysisOutcome outcome =
      analyze_logarithms(5, [](int i, std::size_t level, bool is_small) {
        const int place = i + static_cast<int>(level) * (is_small ? 1 : 2);
        return 0.1 * (place % 5) + 0.01 * static_cast<double>(level) + (is_small ? 0.02 : 0.0);
      });
  const std::string said = question_of(outcome, "spacing").answer.english();
  // p is that of the corrected degrees of freedom, which therefore stand with F.
  const Table& tests = table_of(outcome, "tests").table;
  const double epsilon = number(tests, {"spacing"}, "epsilon");
  EXPECT_LT(epsilon, 1.0);
  EXPECT_EQ(number(tests, {"spacing"}, "df1"), 4.0);
  EXPECT_THAT(said, testing::StartsWith("Not significantly: F(" + fixed(4.0 * epsilon, 2) + ", " +
                                        fixed(16.0 * epsilon, 2) + ") = "));
  EXPECT_THAT(said, HasSubstr(", ε = " + reading_bounded(epsilon) + ", "));
  EXPECT_THAT(said, testing::Not(HasSubstr("rough")));
}

}  // namespace
}  // namespace asperity
