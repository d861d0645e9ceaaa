// Which responses the analysis of a study includes, what it refuses, and how its tables are printed.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/output/analysis_output.h"
#include "app/findings/study/analyze_study.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/chapter_studies.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
  const std::string text = display_text_of(selections_of_the_chapter());
  EXPECT_THAT(text, testing::StartsWith("selection 1 (selection, chapter): people\n"));
  EXPECT_THAT(text, testing::ContainsRegex("1 +height_map +12  20 +20 +\\.60 +\\[\\.39, \\.78\\] +"
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

}  // namespace
}  // namespace asperity
