// Participants who are excluded by their errors in catch trials, as the protocol declares it.

#include "app/findings/methods/discrimination/catch/catch_exclusions.h"

#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/methods/discrimination/threshold_sentences.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/report/text/study_report.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

MadeUpTrial caught(bool is_correct) {
  MadeUpTrial trial = discriminated({.value_m = 100e-6, .chose_comparison = is_correct});
  trial.repetition = 0;
  trial.is_catch = true;
  return trial;
}

/// Two standards.
MadeUpTrial caught_without_signal(const std::string& answer) {
  MadeUpTrial trial = caught(true);
  trial.surfaces = {surface_of("standard", "sinusoid", ""),
                    surface_of("standard_2", "sinusoid", "")};
  trial.options = {"standard", "standard_2", "cannot_tell"};
  trial.answers = {answer};
  trial.right = {"cannot_tell"};
  return trial;
}

/// Participants p1, p2, … with these numbers of errors in 10 easy catch trials. The last one guesses in all trials.
void add_participants_with_errors(const std::vector<int>& errors, const json& rule,
                                  MadeUpStudy& made) {
  json protocol = discrimination_protocol("performance");
  if (!rule.is_null()) protocol["analysis"]["exclude"] = rule;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  const int people = static_cast<int>(errors.size());
  add_participants(made, id, {.number = people, .first = 1}, [&](int person) {
    PsychometricFunction function = kPerformer;
    if (person + 1 == people) function.alpha = 20e-6;
    MadeUpObserver observer(function, static_cast<unsigned>(person + 1));
    std::vector<MadeUpTrial> trials = trials_of(observer.choices(kAbove_m, 40, true));
    for (int i = 0; i < 10; ++i) {
      trials.push_back(caught(i >= errors[static_cast<std::size_t>(person)]));
    }
    return trials;
  });
}

AnalysisOutcome outcome_with_errors(const std::vector<int>& errors, const json& rule) {
  MadeUpStudy made;
  add_participants_with_errors(errors, rule, made);
  return outcome_of_discrimination(made);
}

/// The texts of the section for a paper.
std::string paper_of(MadeUpStudy& made) {
  const Report report = study_report(made.study());
  std::string text{};
  for (const ReportSection& section : report.chapters.at(1).sections) {
    if (section.heading != "Text for a paper") continue;
    for (const ReportPart& part : section.parts) {
      if (const auto* const words = std::get_if<ReportText>(&part)) text += words->text + ' ';
    }
  }
  return text;
}

std::size_t rows_of(const AnalysisOutcome& outcome, const std::string& table) {
  return table_of(outcome, table).table.rows.size();
}

double mean_threshold(const AnalysisOutcome& outcome, const std::string& analysis) {
  return FoundNumbers(part_of(outcome, analysis)).value("mean.jnd", "all").value_or(0.0);
}

TEST(CatchExclusions, AreByTheDeclaredNumberOrProportionOfErrors) {
  const CatchErrors three_of_ten{.participant = "p", .errors = 3, .trials = 10};
  EXPECT_FALSE(is_excluded({.more_errors_than = 3}, three_of_ten));
  EXPECT_TRUE(is_excluded({.more_errors_than = 2}, three_of_ten));
  EXPECT_FALSE(is_excluded({.error_rate_above = 0.3}, three_of_ten));
  EXPECT_TRUE(is_excluded({.error_rate_above = 0.25}, three_of_ten));
}

TEST(CatchExclusions, GiveTheResultsWithAndWithoutALapsingParticipant) {
  const AnalysisOutcome outcome =
      outcome_with_errors({0, 1, 2, 5}, {{"more_catch_errors_than", 2}});
  const AnalysisOutcome of_all = outcome_with_errors({0, 1, 2, 5}, {});
  EXPECT_EQ(rows_of(outcome, "thresholds"), 3U);
  EXPECT_EQ(rows_of(outcome, "thresholds_with_excluded"), 4U);
  EXPECT_EQ(table_of(outcome, "mean_thresholds_with_excluded").table.rows,
            table_of(of_all, "mean_thresholds").table.rows);
  EXPECT_EQ(table_of(outcome, "tests_with_excluded").table.rows,
            table_of(of_all, "tests").table.rows);
  EXPECT_EQ(mean_threshold(outcome, "mean_thresholds_with_excluded"),
            mean_threshold(of_all, "mean_thresholds"));
  EXPECT_LT(mean_threshold(outcome, "mean_thresholds"),
            0.9 * mean_threshold(of_all, "mean_thresholds"));
  const Table& exclusions = table_of(outcome, "exclusions").table;
  ASSERT_EQ(exclusions.rows.size(), 4U);
  EXPECT_EQ(exclusions.rows[2].back(), Cell(std::string("no")));
  EXPECT_EQ(exclusions.rows[3].front(), Cell(std::string("p4")));
  EXPECT_EQ(exclusions.rows[3].back(), Cell(std::string("yes")));
  EXPECT_EQ(rows_of(outcome, "catch_trials"), 4U) << "they are the reason";
  bool names_participant = false;
  for (const Phrase& remark : outcome.remarks) {
    names_participant = names_participant || remark.english().find(
                                                 "Participants whom the declared rule (more than 2 "
                                                 "errors) excludes: 1 of 4 (p4).") == 0;
  }
  EXPECT_TRUE(names_participant);
}

// 2 × 200 attempts in levels.
TEST(CatchExclusions, AreNotAmongTheAnalysedAttemptsOfAPaper) {
  MadeUpStudy made;
  add_participants_with_errors({0, 5}, {{"more_catch_errors_than", 2}}, made);
  const std::string paper = paper_of(made);
  EXPECT_THAT(paper, HasSubstr("200 of the 400 attempts at trials were analysed (of the others, "
                               "200 were made by one participant whom the rule of the protocol "
                               "for errors in catch trials excludes)"));
  EXPECT_THAT(paper, HasSubstr("They were made by one of the two participants."));
  MadeUpStudy without_rule;
  add_participants_with_errors({0, 5}, {}, without_rule);
  EXPECT_THAT(paper_of(without_rule), HasSubstr("The 400 attempts at trials were analysed"));
}

TEST(CatchExclusions, AreMarkedInTheWideTable) {
  MadeUpStudy made;
  add_participants_with_errors({0, 5}, {{"more_catch_errors_than", 2}}, made);
  const auto rows = wide_rows(made);
  EXPECT_EQ(rows.at(0).at("jnd_excluded"), "0");
  EXPECT_EQ(rows.at(1).at("jnd_excluded"), "1");
  MadeUpStudy without_rule;
  add_participants_with_errors({0, 5}, {}, without_rule);
  EXPECT_FALSE(wide_rows(without_rule).at(0).contains("jnd_excluded"));
}

TEST(CatchExclusions, AreThoseOfTheOtherParticipantsAlone) {
  const AnalysisOutcome outcome =
      outcome_with_errors({0, 1, 2, 5}, {{"catch_error_rate_above", 0.4}});
  // The same first three participants: the last one of that study is p4 with another threshold.
  const AnalysisOutcome longer = outcome_with_errors({0, 1, 2, 0}, {});
  const Table& own = table_of(outcome, "thresholds").table;
  const Table& others = table_of(longer, "thresholds").table;
  const auto jnd = column_of(own, "jnd");
  ASSERT_TRUE(jnd);
  for (std::size_t row = 0; row < 3; ++row) EXPECT_EQ(own.rows[row], others.rows[row]);
}

TEST(CatchExclusions, OfNoParticipantOrOfAllChangeNoResult) {
  const AnalysisOutcome plain = outcome_with_errors({0, 1}, {});
  for (const int most : {5, 0}) {
    const AnalysisOutcome outcome = outcome_with_errors(
        most == 5 ? std::vector{0, 1} : std::vector{1, 1}, {{"more_catch_errors_than", most}});
    EXPECT_EQ(table_of(outcome, "thresholds").table.rows, table_of(plain, "thresholds").table.rows);
    EXPECT_THROW(table_of(outcome, "thresholds_with_excluded"), std::runtime_error);
    EXPECT_EQ(rows_of(outcome, "exclusions"), 2U);
  }
  EXPECT_THROW(table_of(plain, "exclusions"), std::runtime_error);
}

TEST(CatchTrialsByType, CountAChoiceWithoutASignalAsAnError) {
  MadeUpStudy made;
  const std::int64_t id =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  MadeUpObserver observer(kPerformer, 1);
  std::vector<MadeUpTrial> trials = trials_of(observer.choices(kAbove_m, 20, true));
  trials.push_back(caught_without_signal("cannot_tell"));
  trials.push_back(caught_without_signal("standard_2"));
  trials.push_back(caught_without_signal("cannot_tell"));
  trials.push_back(caught(true));
  made.add_person("p1", "");
  made.add_session("p1", id, trials);
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const StoredTable& table = table_of(outcome, "catch_trials");
  const std::vector<std::vector<Cell>> expected{
      {std::string("p1"), std::string("only"), std::string("no_signal"), std::int64_t{2},
       std::int64_t{3}, 2.0 / 3.0},
      {std::string("p1"), std::string("only"), std::string("easy"), std::int64_t{1},
       std::int64_t{1}, 1.0}};
  EXPECT_EQ(table.table.rows, expected);
  EXPECT_THAT(table.note.english(), HasSubstr("Every choice is a false alarm"));
  EXPECT_THAT(thresholds_sentence(outcome).text,
              HasSubstr("Of 1 response in easy catch trials, 1 was correct. In 3 catch trials "
                        "without a signal, there was 1 response other than “cannot tell” "
                        "(a missed deadline would count as one)."));
}

}  // namespace
}  // namespace asperity
