// What a report states of results: of simulated studies, their tests and their numbers.

#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/tidy/finding_list.h"
#include "app/report/text/report_numbers.h"
#include "app/report/text/report_sections.h"
#include "app/report/text/report_tests.h"
#include "app/report/text/study_report.h"
#include "app/tasks/simulation/simulation.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"
#include "tests/app/report_words.h"
#include "tests/app/small_study.h"
#include "tests/app/stored_tables.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A study that `simulate` has made: two virtual participants, three trials each.
const TemporaryFolder& simulated() {
  static const std::unique_ptr<TemporaryFolder> kFolder = [] {
    auto folder = std::make_unique<TemporaryFolder>();
    make_small_study(folder->path() / "study");
    write_file(folder->path() / "study" / "protocols" / "small.json", small_protocol(),
               Overwrite::refuse);
    SimulationInputs inputs{};
    inputs.protocols = {folder->path() / "study" / "protocols" / "small.json"};
    inputs.study = folder->path() / "study";
    inputs.participants = 2;
    inputs.seed = 5;
    inputs.recordings = Recordings::none;
    simulate(inputs, built_in_models(), {}, {}, {});
    return folder;
  }();
  return *kFolder;
}

Finding found(const std::string& quantity, const FindingKey& key, double value,
              const std::string& method = "") {
  Finding finding{};
  finding.quantity = quantity;
  finding.key = key;
  finding.value = value;
  finding.method = method;
  finding.n = 20;
  return finding;
}

TEST(StudyReport, TellsFurtherNumbersOnceInWordsAndWhereTheRestIs) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report report = study_report(study);
  ASSERT_EQ(report.chapters.size(), 3U);
  EXPECT_EQ(report.chapters[2].heading, "Appendix to " + report.chapters[1].heading);
  const ReportSection& numbers = section(report.chapters[2], "Further tests and numbers");
  std::set<std::vector<std::string>> rows{};
  for (const ReportPart& part : numbers.parts) {
    const auto* table = std::get_if<ReportTable>(&part);
    if (table == nullptr) continue;
    for (std::vector<std::string> row : table->rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        EXPECT_THAT(row[i], Not(testing::ContainsRegex("[0-9]e-"))) << table->columns[i].heading;
        // Things keep the names that the study has given them.
        if (table->columns[i].heading == "factor or level") continue;
        const std::size_t model = row[i].find("height_map");
        if (model != std::string::npos) row[i].erase(model, std::string("height_map").size());
        EXPECT_THAT(row[i], Not(HasSubstr("_"))) << table->columns[i].heading;
        EXPECT_THAT(row[i], Not(HasSubstr("subj.")));
      }
      row.push_back(table->title);
      EXPECT_TRUE(rows.insert(row).second) << testing::PrintToString(row) << " stands twice";
    }
  }
  EXPECT_GT(rows.size(), 3U);
  EXPECT_THAT(words_of(numbers), HasSubstr("asperity analyze STUDY --protocol"));
}

TEST(ReportNumbers, WriteCountsAsCountsAndNumbersWithTheirUnit) {
  Finding count = found("total.items", "", 234.0);
  Finding bits = found("H.response", "", 2.466);
  bits.unit = "bit";
  Finding share = found("precision", "wood", 0.8);
  share.low = 0.55;
  share.high = 0.975;
  const std::vector<Finding> findings{count, bits, share, found("subject.mean", "p1", 3.0)};
  const ReportTable table = further_numbers_table(findings);
  ASSERT_EQ(table.rows.size(), 3U) << "no number of a single participant";
  EXPECT_THAT(table.rows[0], ElementsAre("items", "–", "234", "–", "20"));
  EXPECT_THAT(table.rows[1], ElementsAre("response entropy H(R)", "–", "2.47 bit", "–", "20"));
  EXPECT_THAT(table.rows[2], ElementsAre("precision (positive predictive value)", "wood", "80 %",
                                         "55 % to 97 %", "20"));
}

TEST(StudyReport, TellsDesignAndMakingOfARealStudy) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report report = study_report(study);
  EXPECT_EQ(report.subtitle, "Data from sessions on a simulated clock, which has no date");
  const std::string design = words_of(section(report.chapters[1], "Design"));
  EXPECT_THAT(design, HasSubstr("A few short trials"));
  EXPECT_THAT(design, HasSubstr("Task: in each trial, several surfaces are presented, and one is "
                                "to be chosen: “Which felt more like the picture?”"));
  EXPECT_THAT(
      design,
      HasSubstr("A session was planned with 3 experimental trials. Two surfaces were presented "
                "in each answered trial."));
  EXPECT_THAT(design, HasSubstr("“Which felt more like the picture?”"));
  EXPECT_THAT(design, HasSubstr("explored for 500 ms to 2 s"));
  const std::string made = words_of(section(report.chapters[1], "Provenance"));
  EXPECT_THAT(made, HasSubstr(study.protocols().front().source_sha256));
  EXPECT_THAT(made, HasSubstr(study.sessions().front().program_commit));
  EXPECT_THAT(words_of(section(report.chapters[1], "Apparatus and conditions")),
              HasSubstr("Device: simulated mass, spring and damper.\n"
                        "Virtual participants neither see nor hear."));
  const std::string sessions = words_of(section(report.chapters[2], "Every session"));
  for (const SessionRow& session : study.sessions()) EXPECT_THAT(sessions, HasSubstr(session.seed));
}

TEST(StudyReport, IsTheSameOfTheSameStudyAndNumbersItsTables) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  const Report once = study_report(study);
  const Report again = study_report(study);
  int number = 0;
  for (std::size_t i = 0; i < once.chapters.size(); ++i) {
    EXPECT_EQ(words_of(once.chapters[i]), words_of(again.chapters.at(i)));
    for (const ReportSection& each : once.chapters[i].sections) {
      for (const ReportPart& part : each.parts) {
        if (const auto* table = std::get_if<ReportTable>(&part)) {
          EXPECT_EQ(table->number, ++number);
          for (const auto& row : table->rows) EXPECT_EQ(row.size(), table->columns.size());
        }
      }
    }
  }
  EXPECT_GT(number, 5);
}

TEST(StudyReport, EndsEarlyWhenItIsAskedTo) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  std::stop_source source{};
  source.request_stop();
  EXPECT_TRUE(study_report(study, {}, source.get_token()).chapters.empty());
}

TEST(StudyReport, RefusesAProtocolThatTheStudyHasNoSessionOf) {
  const Study study = Study::open(simulated().path() / "study", Access::read_only);
  EXPECT_THROW(study_report(study, "another"), ResultsError);
}

TEST(ReportTests, PutsStatisticDegreesAndAdjustedPTogether) {
  const std::vector<Finding> findings{
      found("chisq", "exp1", 9.1), found("chisq.df", "exp1", 2.0),
      found("chisq.p", "exp1", 0.0105672, "Pearson's X² against equal proportions"),
      found("chisq.p.holm", "exp1", 0.0317016)};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(sentence_of(tests[0]),
            "For exp1, Pearson's X² against equal proportions: χ²(2) = 9.10, p = .011, "
            "Holm-corrected p = "
            ".032 (n = 20).");
}

TEST(ReportTests, TakesNothingFromAnotherKeyOrAnalysis) {
  std::vector<Finding> findings{found("chisq", "a", 5.0), found("chisq", "b", 7.0),
                                found("chisq.p", "b", 0.5, "a test")};
  findings[2].analysis = "other";
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(tests[0].statistic, nullptr) << "a stranger's";
  findings[1].analysis = "other";
  EXPECT_EQ(tests_among(findings)[0].statistic, &findings[1]);
}

TEST(ReportTests, GivesAnFBothItsDegreesOfFreedom) {
  const std::vector<Finding> findings{found("df1", "spacing", 4.0), found("df2", "spacing", 44.0),
                                      found("F", "spacing", 20.5267),
                                      found("p", "spacing", 1.3e-9, "analysis of variance")};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(sentence_of(tests[0]),
            "For spacing, analysis of variance: F(4, 44) = 20.53, p < .001 (n = 20).");
}

TEST(ReportTests, TellsWholesFromTheirParts) {
  const std::vector<Finding> findings{found("p", "column=1 item=a", 0.2, "a test"),
                                      found("p", "column=all item=a", 0.1, "a test"),
                                      found("p", "texture=brick item=a", 0.3, "a test")};
  const std::vector<ReportedTest> tests = tests_among(findings);
  ASSERT_EQ(tests.size(), 3U);
  EXPECT_FALSE(tests[0].is_of_whole);
  EXPECT_TRUE(tests[1].is_of_whole);
  EXPECT_TRUE(tests[2].is_of_whole) << "there is no whole of its kind";
  EXPECT_EQ(words_of_key("column=all item=a"), "a (all repetitions)");
  EXPECT_EQ(words_of_key("column=1 person=Other or not told"),
            "repetition 1, Other or not reported");
  EXPECT_EQ(words_of_key("condition:spacing"), "spacing by condition");
  EXPECT_EQ(words_of_quantity("peak.fieller"), "Fieller’s CI of the peak");
}

// Both p are alike; a test is identified by its name.
TEST(ReportResults, ListsATestThatNoTableHasWhateverItsP) {
  AnalysisOutcome outcome{};
  outcome.findings = {found("signflip.p.two", {"a", "b"}, 0.25, "sign flips"),
                      found("signflip.p.two", {"a", "c"}, 0.25, "other sign flips")};
  outcome.tables.push_back(
      result_of({.name = "tests", .table = {{"test", "p"}, {{std::string("x"), 0.25}}}}));
  outcome.tests_in_tables.insert(name_of(outcome.findings[0]));
  const std::string words = words_of(numbers_section(outcome));
  EXPECT_THAT(words, HasSubstr("other sign flips | a, c"));
  EXPECT_THAT(words, Not(HasSubstr("a, b")));
}

TEST(ReportResults, SaysRefusalsAsSentences) {
  AnalysisOutcome outcome{};
  Finding refused{};
  refused.quantity = "p";
  refused.key = "item=a";
  refused.status =
      "the chance level differs between the trials, so that one test of all trials is not valid";
  outcome.findings = {refused};
  EXPECT_THAT(words_of(results_section(outcome, {})),
              HasSubstr("The test of a: the chance level differs between the trials, so that one "
                        "test of all trials is not valid."));
}

TEST(ReportResults, NamesWhatHasNoAnswerInWordsAndCountsTheStepsOfComputations) {
  const auto without = [](const char* quantity, const char* key, const char* analysis,
                          const char* status) {
    Finding finding{};
    finding.quantity = quantity;
    finding.key = key;
    finding.analysis = analysis;
    finding.status = status;
    return finding;
  };
  const char* undefined = kNotDefined;
  AnalysisOutcome outcome{};
  outcome.findings = {without("pooled.quad.vs.linear.F", "s1", "roughness", undefined),
                      without("peak.se.log10.pooledOLS", "s3", "roughness", undefined),
                      without("bt.order.status", "first", "scale", "nobody felt both orders"),
                      without("cochran.Q", "1", "position", "nobody differs"),
                      without("dprime", "", "recognition", "every response is correct"),
                      without("dprime.lower", "", "recognition", "every response is correct"),
                      without("replicates", "", "anova", "A has 2 rows")};
  const std::string words = words_of(results_section(outcome, {}));
  EXPECT_THAT(words, HasSubstr("The order effect on the scale of the items: "
                               "nobody felt both orders.\n"));
  EXPECT_THAT(words, HasSubstr("Cochran’s Q of position 1: nobody differs.\n"));
  EXPECT_THAT(words, HasSubstr("The sensitivity d′ and the CI of the sensitivity d′: every "
                               "response is correct.\n"));
  EXPECT_THAT(words, HasSubstr("2 numbers of the appendix or of tables are not defined for these "
                               "data; asperity analyze STUDY --json lists each by name.\n"));
  EXPECT_THAT(words, Not(HasSubstr("pooledOLS")));
  EXPECT_THAT(words, Not(HasSubstr("A has 2 rows")));
}

TEST(ReportResults, AnswersTheQuestionsOfAnAnalysisFirst) {
  AnalysisOutcome outcome{};
  outcome.questions.push_back({"preference",
                               Phrase("Is one chosen more often?"),
                               Phrase("Yes: 15 of 20 times"),
                               Phrase("by counting"),
                               "",
                               {},
                               Phrase("20 answers")});
  const ReportSection results = results_section(outcome, {});
  const auto& first = std::get<ReportText>(results.parts.at(0));
  EXPECT_EQ(first.text, "Is one chosen more often? Yes: 15 of 20 times.");
  EXPECT_EQ(first.tone, ReportText::Tone::lead);
  EXPECT_EQ(std::get<ReportText>(results.parts.at(1)).text, "By counting. n = 20 answers.");
}

TEST(ReportResults, PutsAFigureBesideItsQuestion) {
  AnalysisOutcome outcome{};
  for (const char* name : {"first", "second"}) {
    outcome.questions.push_back({name, Phrase("Is it?"), Phrase("Yes"), {}, "", {}, {}});
  }
  Figure figure{};
  figure.name = "of_second";
  figure.question = "second";
  const std::vector<Figure> figures{figure};
  const ReportSection results = results_section(outcome, figures);
  ASSERT_EQ(results.parts.size(), 3U);
  EXPECT_EQ(std::get<ReportFigure>(results.parts[2]).figure.name, "of_second");
  EXPECT_TRUE(tables_section(outcome, figures).parts.empty()) << "once";
}

TEST(ReportResults, PutsTheOtherFiguresBesideTheirTablesBehind) {
  AnalysisOutcome outcome{};
  outcome.tables = results_of(
      {{"one", Phrase("One"), {{"a"}, {}}, {}}, {"two", Phrase("Two"), {{"a"}, {}}, {}}});
  Figure of_two{};
  of_two.name = "of_two";
  of_two.table = "two";
  Figure free{};
  free.name = "free";
  const std::vector<Figure> figures{of_two, free};
  const ReportSection results = results_section(outcome, figures);
  ASSERT_EQ(results.parts.size(), 1U) << "what was counted";
  EXPECT_EQ(std::get<ReportTable>(results.parts[0]).title, "One");
  const ReportSection behind = tables_section(outcome, figures);
  ASSERT_EQ(behind.parts.size(), 3U);
  EXPECT_EQ(std::get<ReportFigure>(behind.parts[0]).figure.name, "free");
  EXPECT_EQ(std::get<ReportFigure>(behind.parts[1]).figure.name, "of_two");
  EXPECT_EQ(std::get<ReportTable>(behind.parts[2]).title, "Two");
}

TEST(ReadingNumber, HasTheDigitsThatMeanSomething) {
  EXPECT_EQ(display_number(0.60412345), "0.6041");
  EXPECT_EQ(display_number(47.0), "47");
  EXPECT_EQ(display_number(2.51e-23), "2.5e-23");
  EXPECT_EQ(display_p(0.0112), "p = .011");
  EXPECT_EQ(display_p(0.0004), "p < .001");
  EXPECT_EQ(display_p(1.0), "p > .999");
  EXPECT_EQ(display_p(0.9994), "p = .999");
  EXPECT_EQ(display_percent(0.7833), "78 %");
  EXPECT_EQ(display_percent(0.975), "97 %") << "as a table rounds it to two decimals";
  EXPECT_EQ(display_p_cell(0.0004), "< .001");
  EXPECT_EQ(display_percent(0.002), "0.2 %") << "not nothing";
  EXPECT_EQ(display_percent(0.998), "99.8 %") << "not all";
  EXPECT_EQ(display_percent(0.0004), "< 0.1 %") << "nor 0.0 %";
  EXPECT_EQ(display_percent(0.9996), "> 99.9 %") << "nor 100.0 %";
  EXPECT_EQ(display_percent(0.0), "0 %");
  EXPECT_EQ(display_percent(1.0), "100 %");
  EXPECT_EQ(display_quantity(31e-6, "s"), "31 µs");
  EXPECT_EQ(display_quantity(0.05, "m/s"), "50 mm/s");
  EXPECT_EQ(display_quantity(0.8, "N"), "0.8 N");
  EXPECT_EQ(display_quantity(6876.0, "Pa"), "6.88 kPa");
  EXPECT_EQ(display_quantity(2.5e6, "Pa"), "2.5 MPa");
  EXPECT_EQ(display_quantity(0.0, "s"), "0 s");
  EXPECT_EQ(display_count(9999), "9999");
  EXPECT_EQ(count_in_words(3), "three");
  EXPECT_EQ(count_in_words(12), "12");
}

TEST(ReadingNumber, HasAMinusSign) {
  EXPECT_EQ(display_number(-0.60412345), "−0.6041");
  EXPECT_EQ(display_number(-12.0), "−12");
  EXPECT_EQ(display_number(-0.0), "0");
  EXPECT_EQ(display_whole(-3), "−3");
  EXPECT_EQ(display_quantity(-0.002, "m"), "−2 mm");
}

TEST(UnbrokenNumbers, HaveNoBreakSpacesOnlyWithinNumbers) {
  const auto shown = [](const std::string& text) {  // with "_" for a no-break space
    std::string unbroken = with_numbers_unbroken(text);
    for (std::size_t at = unbroken.find("\u00A0"); at != std::string::npos;
         at = unbroken.find("\u00A0", at)) {
      unbroken.replace(at, 2, "_");
    }
    return unbroken;
  };
  EXPECT_EQ(shown("95 % CI [0.16, 0.49], N = 8"), "95_% CI [0.16,_0.49], N_=_8");
  EXPECT_EQ(shown("F(2, 38) = 5.17, p < .001, g = −0.10 [−0.16, 0.49]"),
            "F(2,_38)_=_5.17, p_<_.001, g_=_−0.10 [−0.16,_0.49]");
  EXPECT_EQ(shown("at 50 mm/s, 4 N and 1000 Hz."), "at 50_mm/s, 4_N and 1000_Hz.");
  EXPECT_EQ(shown("at most 20 N s/m."), "at most 20_N_s/m.");
  EXPECT_EQ(shown("62 % (95 % CI [< 0.1 %, 71 %])"), "62_% (95_% CI [<_0.1_%,_71_%])");
  EXPECT_EQ(shown("One of 4 participants (a, b) chose x = y in block 2 s1."),
            "One of 4 participants (a, b) chose x = y in block 2 s1.");
}

}  // namespace
}  // namespace asperity
