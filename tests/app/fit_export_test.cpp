// What an export has to fit functions and to compute d′: responses "cannot tell", and tasks whose responses are words.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"
#include "protocols/kind_keys/discrimination_design.h"
#include "tests/app/exported_study.h"
#include "tests/app/made_up_choices.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

struct CountsOfLevel {
  double value_m = 0.0;
  int comparison = 0;
  int unsure = 0;
  int standard = 0;
};
const std::vector<CountsOfLevel> kUnsureCounts{
    {40e-6, 1, 4, 15}, {45e-6, 3, 6, 11}, {50e-6, 6, 8, 6}, {55e-6, 11, 6, 3}, {60e-6, 16, 3, 1}};

/// Trials of a choice between two surfaces with the option "cannot tell".
std::vector<MadeUpTrial> trials_of_counts(bool is_performance) {
  std::vector<MadeUpTrial> trials{};
  for (const CountsOfLevel& level : kUnsureCounts) {
    for (int i = 0; i < level.comparison + level.unsure + level.standard; ++i) {
      MadeUpTrial trial = discriminated({.value_m = level.value_m,
                                         .chose_comparison = i < level.comparison,
                                         .comparison_first = i % 2 == 0,
                                         .is_performance = is_performance});
      trial.options = {"standard", "comparison", "cannot_tell"};
      if (i >= level.comparison && i < level.comparison + level.unsure) {
        trial.answers = {"cannot_tell"};
      }
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

/// A study of one participant, and its export.
class ExportedDiscrimination {
 public:
  ExportedDiscrimination(const nlohmann::json& protocol, const std::vector<MadeUpTrial>& trials) {
    const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
    made.add_person("p1", "");
    made.add_session("p1", id, trials);
    outcome = export_to(made, out());
  }
  fs::path out() const { return made.beside("out"); }

  MadeUpStudy made;
  ExportOutcome outcome{};
};

std::vector<Finding> findings_of_file(const char* family, const fs::path& file,
                                      const std::string& options) {
  TidyInput input{.options = FamilyOptions::of_json(options, "options")};
  input.tables.emplace_back(read_file(file), file.filename().string());
  return tidy_family(family).findings(input);
}

TEST(ExportedFits, CountResponsesCannotTellNextToTheCorrectOnes) {
  const ExportedDiscrimination exported(discrimination_protocol("performance"),
                                        trials_of_counts(true));
  const Table fit = table_in(exported.out(), "fit.tsv");
  ASSERT_EQ(fit.rows.size(), kUnsureCounts.size());
  for (std::size_t row = 0; row < fit.rows.size(); ++row) {
    EXPECT_EQ(cell_of(fit, row, "k"), Cell{std::to_string(kUnsureCounts[row].comparison)});
    EXPECT_EQ(cell_of(fit, row, "unsure"), Cell{std::to_string(kUnsureCounts[row].unsure)});
    EXPECT_EQ(cell_of(fit, row, "n"), Cell{"20"});
    EXPECT_EQ(cell_of(fit, row, "m"), Cell{"2"});
  }
}

TEST(ExportedLanguages, AreAColumnOfAStudyInSeveralLanguages) {
  nlohmann::json protocol = discrimination_protocol("performance");
  ExportedDiscrimination exported(protocol, trials_of_counts(true));
  for (const char* const table : {"participants.tsv", "sessions.tsv", "fit.tsv"}) {
    EXPECT_THAT(read_file(exported.out() / table), Not(HasSubstr("language"))) << table;
  }
  protocol["language"] = "de";
  const std::int64_t german = exported.made.add_protocol("jnd", "discrimination", protocol.dump());
  exported.made.add_person("p2", "");
  exported.made.add_session("p2", german, trials_of_counts(true));
  const fs::path out = exported.made.beside("out_2");
  export_to(exported.made, out);
  for (const char* const table : {"participants.tsv", "sessions.tsv"}) {
    const Table rows = table_in(out, table);
    ASSERT_EQ(rows.rows.size(), 2U);
    EXPECT_EQ(cell_of(rows, 0, "language"), Cell{"en"}) << table;
    EXPECT_EQ(cell_of(rows, 1, "language"), Cell{"de"}) << table;
  }
  const Table fit = table_in(out, "fit.tsv");
  ASSERT_EQ(fit.rows.size(), 2 * kUnsureCounts.size());
  for (std::size_t row = 0; row < fit.rows.size(); ++row) {
    EXPECT_EQ(cell_of(fit, row, "language"),
              Cell{cell_of(fit, row, "participant") == Cell{"p1"} ? "en" : "de"});
  }
  const std::string wide = read_file(out / "wide.csv");
  EXPECT_THAT(wide.substr(0, wide.find('\n')), HasSubstr("language"));
}

// The points of subjective equality of the program and of the exported file are the same number, which is not that of counts
// in which "cannot tell" is a choice of the standard.
TEST(ExportedFits, AreFittedAsTheAnalysisDoes) {
  ExportedDiscrimination exported(discrimination_protocol("comparison"), trials_of_counts(false));
  const std::vector<Finding> thresholds =
      part_of(outcome_of_discrimination(exported.made), "thresholds");
  const Finding* const pse = FoundNumbers(thresholds).find("pse", "p1|all");
  ASSERT_TRUE(pse != nullptr && pse->value);
  const Table fit = table_in(exported.out(), "fit.tsv");
  EXPECT_EQ(fit.rows.size(), 2U * kUnsureCounts.size()) << "standard and comparison";
  const std::vector<Finding> findings = findings_of_file(
      "psyfit", exported.out() / "fit.tsv",
      R"({"shape": "normal", "gamma": 0.02, "lambda": 0.02, "pt": 0.5, "bootstrap": 400})");
  const Finding* const threshold =
      FoundNumbers(findings).find("threshold", "p1: jnd 1, which, comparison");
  ASSERT_TRUE(threshold != nullptr && threshold->value);
  EXPECT_NEAR(*threshold->value, *pse->value, 1e-12);
  ASSERT_TRUE(threshold->low && threshold->high && pse->low && pse->high);
  EXPECT_NEAR(*threshold->low, *pse->low, 1e-12);
  EXPECT_NEAR(*threshold->high, *pse->high, 1e-12);
  EXPECT_EQ(FoundNumbers(findings).find("deviance", "p1: jnd 1, which, comparison"), nullptr);
}

/// A trial of a task whose responses are words, and the rating of its confidence.
MadeUpTrial in_words(const DiscriminationDesign& design, const DesignTrial& type, double value_m,
                     bool says_yes, int confidence) {
  MadeUpTrial trial{};
  trial.factors_json = nlohmann::json{{"amplitude_m", value_m}}.dump();
  for (const std::string_view role : type.roles) {
    if (role.empty()) continue;
    const bool is_second = !trial.surfaces.empty() && trial.surfaces.front().role == role;
    trial.surfaces.push_back(
        surface_of(std::string(role) + (is_second ? "_2" : ""), "sinusoid", ""));
    trial.surfaces.back().role = std::string(role);
  }
  trial.options = {std::string(design.yes), std::string(design.no)};
  trial.questions = {"which", "sure"};
  trial.answers = {std::string(says_yes ? design.yes : design.no), std::to_string(confidence)};
  trial.right = {std::string(type.is_signal ? design.yes : design.no)};
  return trial;
}

/// The ratings are analysed separately.
AnalysisOutcome discrimination_in(MadeUpStudy& made) {
  for (AnalysisOutcome& outcome : analyze_study(made.study(), std::nullopt, {})) {
    if (outcome.kind == "discrimination") return std::move(outcome);
  }
  ADD_FAILURE() << "no discrimination";
  return {};
}

nlohmann::json protocol_in_words(const DiscriminationDesign& design) {
  nlohmann::json protocol = discrimination_protocol("performance");
  nlohmann::json& block = protocol["blocks"]["only"];
  block["design"] = std::string(design.id);
  const nlohmann::json asked = block["question"];
  block.erase("question");
  block["questions"] = {asked,
                        {{"name", "sure"},
                         {"prompt", "How sure?"},
                         {"scale", {{"minimum", 1}, {"maximum", 9}, {"points", 9}}},
                         {"confidence_of", asked.at("name")}}};
  return protocol;
}

/// At both levels 10 rounds of the types of the design. Hits at 60 µm in 9 of 10 trials, at 55 µm in 6; false alarms in 2. With
/// a signal the confidence is 8, without one 3.
std::vector<MadeUpTrial> trials_in_words(const DiscriminationDesign& design) {
  std::vector<MadeUpTrial> trials{};
  for (const double value_m : {55e-6, 60e-6}) {
    for (int i = 0; i < 10; ++i) {
      for (const DesignTrial& type : design.trials) {
        const int yes = !type.is_signal ? 2 : value_m > 58e-6 ? 9 : 6;
        trials.push_back(in_words(design, type, value_m, i < yes, type.is_signal ? 8 : 3));
      }
    }
  }
  return trials;
}

TEST(ExportedDetections, AreHitsAndFalseAlarmsAsTheAnalysisCountsThem) {
  for (const DiscriminationDesign* const design : {&yes_no_task(), &same_different_task()}) {
    SCOPED_TRACE(std::string(design->id));
    ExportedDiscrimination exported(protocol_in_words(*design), trials_in_words(*design));
    const Table counts = table_in(exported.out(), "detection.tsv");
    ASSERT_EQ(counts.rows.size(), 2U);
    const bool is_pair = design->surfaces() > 1;
    const std::string trials = is_pair ? "20" : "10";
    EXPECT_EQ(cell_of(counts, 0, "signal_yes"), Cell{is_pair ? "12" : "6"});
    EXPECT_EQ(cell_of(counts, 1, "signal_yes"), Cell{is_pair ? "18" : "9"});
    for (std::size_t row = 0; row < 2; ++row) {
      EXPECT_EQ(cell_of(counts, row, "signal_n"), Cell{trials});
      EXPECT_EQ(cell_of(counts, row, "noise_yes"), Cell{is_pair ? "8" : "4"});
      EXPECT_EQ(cell_of(counts, row, "noise_n"), Cell{is_pair ? "40" : "20"});
      EXPECT_EQ(cell_of(counts, row, "design"), Cell{is_pair ? "samediff" : "yesno"});
      EXPECT_EQ(cell_of(counts, row, "subject"), Cell{"p1"});
    }
    const QuantityName quantity =
        is_pair ? QuantityName("dprime.diff.loglinear") : "dprime.loglinear";
    const std::vector<Finding> own = part_of(discrimination_in(exported.made), "sensitivity");
    const std::vector<Finding> of_file =
        findings_of_file("dprime", exported.out() / "detection.tsv", "{}");
    EXPECT_EQ(FoundNumbers(of_file).value(quantity, "jnd 1, which, amplitude_m = 5.5e-05|p1"),
              FoundNumbers(own).value(quantity, "all|5.5e-05|p1"));
    EXPECT_TRUE(FoundNumbers(own).value(quantity, "all|5.5e-05|p1"));
    // A function of the correct responses would mix hits and correct rejections.
    EXPECT_THAT(names_in(exported.out()), Not(Contains("fit.tsv")));
    ASSERT_EQ(exported.outcome.not_written.size(), 1U);
    EXPECT_THAT(exported.outcome.not_written[0].english(), HasSubstr("are in detection.tsv"));
  }
}

TEST(ExportedDetections, HaveMeanRatingsOfTrialsWithAndWithoutASignal) {
  for (const DiscriminationDesign* const design : {&yes_no_task(), &same_different_task()}) {
    ExportedDiscrimination exported(protocol_in_words(*design), trials_in_words(*design));
    const std::map<std::string, std::string> row = wide_rows(exported.made).at(0);
    const bool is_pair = design->surfaces() > 1;
    const std::string signal = is_pair ? "different" : "signal";
    const std::string noise = is_pair ? "same" : "noise";
    EXPECT_EQ(row.at("jnd_sure_" + noise + "_mean"), "3");
    EXPECT_EQ(row.at("jnd_sure_" + noise + "_n"), is_pair ? "40" : "20");
    EXPECT_EQ(row.at("jnd_sure_" + signal + "_5_5e_05_mean"), "8");
    EXPECT_EQ(row.at("jnd_sure_" + signal + "_5_5e_05_n"), is_pair ? "20" : "10");
  }
}

}  // namespace
}  // namespace asperity
