// Discriminations, from the rows of a study to thresholds, tests and sentences.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric_function.h"
#include "app/exports/export_study.h"
#include "app/findings/found_numbers.h"
#include "app/findings/reading_table.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/study/discrimination_coverage.h"
#include "app/findings/study/discrimination_tasks.h"
#include "app/findings/study/discrimination_thresholds.h"
#include "app/findings/study/discrimination_tracks.h"
#include "app/findings/study/study_analysis.h"
#include "app/findings/study/study_tests.h"
#include "app/words/text_parts.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/atomic_file.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kStandard_m = 50e-6;

json discrimination_protocol(const std::string& judgement, double standard_m = kStandard_m) {
  json protocol = json::parse(R"({"kind": "discrimination",
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {}}},
    "blocks": {"only": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "which", "prompt": "Which is rougher?"}}},
    "analysis": {"family": ["order", "conditions", "point_of_subjective_equality"]}})");
  protocol["stimuli"]["grating"]["parameters"]["amplitude_m"] = standard_m;
  protocol["blocks"]["only"]["question"]["judgement"] = judgement;
  return protocol;
}

/// One response of a discrimination.
struct MadeUpChoice {
  double value_m = 0.0;
  bool chose_comparison = false;
  bool comparison_first = false;
  std::string texture{};  ///< a level of another factor; empty: none
  bool is_performance = true;
  std::string block = "only";
};

MadeUpTrial discriminated(const MadeUpChoice& choice) {
  MadeUpTrial trial{};
  json factors{{"amplitude_m", choice.value_m}};
  if (!choice.texture.empty()) factors["texture"] = choice.texture;
  trial.factors_json = factors.dump();
  trial.surfaces = {surface_of("standard", "sinusoid", ""),
                    surface_of("comparison", "sinusoid", "")};
  if (choice.comparison_first) std::swap(trial.surfaces[0], trial.surfaces[1]);
  trial.answers = {choice.chose_comparison ? "comparison" : "standard"};
  trial.options = {"standard", "comparison"};
  trial.block = choice.block;
  if (choice.is_performance) trial.right = {"comparison"};
  return trial;
}

/// An observer whose proportion of choices of the comparison is a psychometric function.
class MadeUpObserver {
 public:
  MadeUpObserver(PsychometricFunction function, unsigned seed)
      : function_(function), random_(seed) {}

  /// The first positions are balanced within each level.
  std::vector<MadeUpChoice> choices(const std::vector<double>& values_m, int per_level,
                                    bool is_performance) {
    std::vector<MadeUpChoice> all{};
    for (const double value_m : values_m) {
      const double x = is_performance ? std::abs(value_m - standard_m) : value_m;
      for (int i = 0; i < per_level; ++i) {
        const bool first = i % 2 == 0;
        const double p = function_.value(x) + (first ? bias_to_first : -bias_to_first);
        const double drawn = static_cast<double>(random_()) / 4294967296.0;
        all.push_back({.value_m = value_m,
                       .chose_comparison = drawn < p,
                       .comparison_first = first,
                       .is_performance = is_performance});
      }
    }
    return all;
  }

  double bias_to_first = 0.0;
  double standard_m = kStandard_m;

 private:
  PsychometricFunction function_;
  std::mt19937 random_;
};

std::vector<MadeUpTrial> trials_of(const std::vector<MadeUpChoice>& choices) {
  std::vector<MadeUpTrial> trials{};
  for (const MadeUpChoice& choice : choices) trials.push_back(discriminated(choice));
  return trials;
}

const std::vector<double> kAbove_m{52.5e-6, 55e-6, 60e-6, 65e-6, 75e-6};
const std::vector<double> kAround_m{35e-6, 40e-6, 45e-6, 50e-6, 55e-6, 60e-6, 65e-6};
constexpr PsychometricFunction kPerformer{
    .shape = PsychometricShape::weibull, .alpha = 10e-6, .beta = 2.0, .gamma = 0.5, .lambda = 0.02};
constexpr PsychometricFunction kComparer{.shape = PsychometricShape::normal,
                                         .alpha = 54e-6,
                                         .beta = 1.0 / 6e-6,
                                         .gamma = 0.02,
                                         .lambda = 0.02};

AnalysisOutcome outcome_of_discrimination(MadeUpStudy& made) {
  std::vector<AnalysisOutcome> outcomes = analyze_study(made.study(), std::nullopt, {});
  EXPECT_EQ(outcomes.size(), 1U);
  return std::move(outcomes.front());
}

/// `people` observers with the same function.
AnalysisOutcome outcome_of_observers(const PsychometricFunction& function, int people,
                                     const std::vector<double>& values_m, bool is_performance,
                                     int per_level = 40, double bias_to_first = 0.0) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol(
      "jnd", "discrimination",
      discrimination_protocol(is_performance ? "performance" : "comparison").dump());
  for (int person = 0; person < people; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    MadeUpObserver observer(function, static_cast<unsigned>(100 + person));
    observer.bias_to_first = bias_to_first;
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(observer.choices(values_m, per_level, is_performance)));
  }
  return outcome_of_discrimination(made);
}

std::vector<Finding> part_of(const AnalysisOutcome& outcome, const std::string& analysis) {
  std::vector<Finding> part{};
  std::copy_if(outcome.findings.begin(), outcome.findings.end(), std::back_inserter(part),
               [&](const Finding& each) { return each.analysis == analysis; });
  return part;
}

const NamedTable& discrimination_table(const AnalysisOutcome& outcome, const std::string& name) {
  const auto found = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                                  [&name](const NamedTable& each) { return each.name == name; });
  if (found == outcome.tables.end()) throw std::runtime_error("there is no table " + name);
  return *found;
}

std::string answer_to(const AnalysisOutcome& outcome, const std::string& name) {
  const auto found =
      std::find_if(outcome.questions.begin(), outcome.questions.end(),
                   [&name](const AnsweredQuestion& each) { return each.name == name; });
  return found == outcome.questions.end() ? std::string() : found->answer.english();
}

std::string sentence_about(const AnalysisOutcome& outcome, const std::string& test,
                           const std::string& about = {}) {
  for (const TestSentence& each : outcome.test_sentences) {
    if (each.test == test && (about.empty() || each.about == about)) return each.text;
  }
  return {};
}

TEST(Discrimination, RecoversTheThresholdOfObserversWithinItsInterval) {
  const AnalysisOutcome outcome = outcome_of_observers(kPerformer, 12, kAbove_m, true);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const double jnd_m = kPerformer.inverse(0.75);
  int holding = 0;
  for (const Finding* const jnd : FoundNumbers(thresholds).all("jnd")) {
    ASSERT_TRUE(jnd->value && jnd->low && jnd->high) << jnd->key;
    EXPECT_EQ(jnd->unit, "m");
    holding += *jnd->low <= jnd_m && jnd_m <= *jnd->high ? 1 : 0;
  }
  EXPECT_GE(holding, 10) << "of 12 intervals of 95 %";
  const FoundNumbers found(means);
  const Finding* const mean = found.find("mean.jnd", "all");
  ASSERT_NE(mean, nullptr);
  EXPECT_EQ(mean->n, 12U);
  EXPECT_LE(*mean->low, jnd_m);
  EXPECT_GE(*mean->high, jnd_m);
  EXPECT_NEAR(*found.value("mean.weber", "all"), *mean->value / kStandard_m, 1e-12);
  // d' = 1 corresponds to 76 %, which is slightly above 75 %.
  const double unit_m = *found.value("mean.jnd.dprime1", "all");
  EXPECT_GT(unit_m, *mean->value);
  EXPECT_NEAR(unit_m / *mean->value, kPerformer.inverse(0.7602499) / jnd_m, 0.02);
}

// Three participants whose thresholds differ by a factor of 8: the t interval of their arithmetic mean begins below 0,
// and no JND is negative.
TEST(Discrimination, HasGeometricMeansWithoutNegativeLimits) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  for (const double alpha_m : {3e-6, 4e-6, 24e-6}) {
    const std::string label = "p" + std::to_string(std::lround(alpha_m * 1e6));
    PsychometricFunction function = kPerformer;
    function.alpha = alpha_m;
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(MadeUpObserver(function, 3)
                                   .choices({51e-6, 52e-6, 54e-6, 58e-6, 66e-6, 82e-6}, 60, true)));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const FoundNumbers found(means);
  double sum_of_logs = 0.0;
  for (const Finding* const jnd : FoundNumbers(thresholds).all("jnd")) {
    ASSERT_TRUE(jnd->value) << jnd->key;
    sum_of_logs += std::log(*jnd->value);
  }
  const Finding* const arithmetic = found.find("mean.jnd", "all");
  const Finding* const geometric = found.find("geomean.jnd", "all");
  ASSERT_TRUE(arithmetic != nullptr && geometric != nullptr);
  EXPECT_LT(*arithmetic->low, 0.0);
  EXPECT_NEAR(*geometric->value, std::exp(sum_of_logs / 3.0), 1e-12);
  EXPECT_GT(*geometric->low, 0.0);
  EXPECT_NEAR(*geometric->low * *geometric->high, *geometric->value * *geometric->value, 1e-15);
  EXPECT_NEAR(*found.value("geomean.weber", "all"), *geometric->value / kStandard_m, 1e-12);
  EXPECT_EQ(found.find("geomean.pse", "all"), nullptr);
  EXPECT_THAT(answer_to(outcome, "threshold"), Not(HasSubstr("[−")));
  const NamedTable& table = discrimination_table(outcome, "mean_thresholds");
  for (const char* const column : {"mean", "geometric_mean", "geometric_mean_low"}) {
    EXPECT_TRUE(column_of(table.table, column)) << column;
  }
}

TEST(Discrimination, ByPerformanceHasNoPointOfSubjectiveEquality) {
  const AnalysisOutcome outcome = outcome_of_observers(kPerformer, 4, kAbove_m, true);
  for (const Finding& finding : outcome.findings)
    EXPECT_EQ(finding.quantity.find("pse"), std::string::npos);
  EXPECT_EQ(answer_to(outcome, "point_of_subjective_equality"), "");
  EXPECT_THAT(sentence_about(outcome, "point_of_subjective_equality"),
              HasSubstr("there is no point of subjective equality"));
  EXPECT_THAT(sentence_about(outcome, "conditions"), HasSubstr("there is only one condition"));
  EXPECT_THAT(answer_to(outcome, "threshold"),
              HasSubstr("Geometric mean of the just-noticeable differences: "));
  EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("µm"));
  EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("Weber fraction"));
}

TEST(Discrimination, ByComparisonRecoversThePointOfSubjectiveEquality) {
  const AnalysisOutcome outcome = outcome_of_observers(kComparer, 12, kAround_m, false);
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const FoundNumbers found(means);
  const Finding* const pse = found.find("mean.pse", "all");
  const Finding* const jnd = found.find("mean.jnd", "all");
  ASSERT_TRUE(pse != nullptr && jnd != nullptr);
  EXPECT_LE(*pse->low, 54e-6);
  EXPECT_GE(*pse->high, 54e-6);
  // ½(x75 − x25) of a normal distribution with a standard deviation of 6 µm.
  EXPECT_LE(*jnd->low, 0.67449 * 6e-6);
  EXPECT_GE(*jnd->high, 0.67449 * 6e-6);
  EXPECT_EQ(found.find("mean.jnd.dprime1", "all"), nullptr);
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality"), HasSubstr("standard: 50 µm"));
  EXPECT_THAT(sentence_about(outcome, "point_of_subjective_equality"),
              HasSubstr("The point of subjective equality of the amplitude was significantly above "
                        "the standard: Wilcoxon signed-rank test"));
}

TEST(Discrimination, CountsChoicesOfTheStandardWhereTheComparisonIsChosenLessOften) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("smoother", "discrimination", discrimination_protocol("comparison").dump());
  made.add_person("p1", "");
  MadeUpObserver observer(kComparer, 7);
  std::vector<MadeUpChoice> choices = observer.choices(kAround_m, 40, false);
  for (MadeUpChoice& choice : choices) choice.chose_comparison = !choice.chose_comparison;
  made.add_session("p1", protocol, trials_of(choices));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  EXPECT_NEAR(*FoundNumbers(thresholds).value("pse", "p1|all"), 54e-6, 2e-6);
  EXPECT_THAT(discrimination_table(outcome, "psychometric").note.english(),
              HasSubstr("choices of the standard"));
}

TEST(Discrimination, OfAStandardOfZeroIsADetectionWithoutAWeberFraction) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol(
      "detection", "discrimination", discrimination_protocol("performance", 0.0).dump());
  for (int person = 0; person < 3; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    MadeUpObserver observer(kPerformer, static_cast<unsigned>(person));
    observer.standard_m = 0.0;
    made.add_session(label, protocol,
                     trials_of(observer.choices({2.5e-6, 5e-6, 10e-6, 15e-6, 25e-6}, 40, true)));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  for (const Finding& finding : outcome.findings) {
    EXPECT_EQ(finding.quantity.find("weber"), std::string::npos) << finding.quantity;
  }
  EXPECT_THAT(answer_to(outcome, "threshold"),
              HasSubstr("Geometric mean of the detection thresholds: "));
  const StudyAnalysis& analysis = *find_analysis("discrimination");
  EXPECT_THAT(analysis.estimates(outcome).text, HasSubstr("detection threshold"));
}

TEST(Discrimination, ReportsAThresholdOutsideTheLevelsAsAStatus) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  made.add_person("perfect", "");
  made.add_person("poor", "");
  PsychometricFunction always = kPerformer;
  always.gamma = 1.0;
  always.lambda = 0.0;
  PsychometricFunction poor = kPerformer;
  poor.alpha = 40e-6;
  made.add_session("perfect", protocol,
                   trials_of(MadeUpObserver(always, 1).choices(kAbove_m, 20, true)));
  made.add_session("poor", protocol,
                   trials_of(MadeUpObserver(poor, 2).choices(kAbove_m, 300, true)));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  for (const auto& [key, word] :
       {std::pair{"perfect|all", "below_levels"}, std::pair{"poor|all", "outside_levels"}}) {
    for (const char* const quantity : {"jnd", "jnd.dprime1", "weber", "slope"}) {
      const Finding* const finding = found.find(quantity, key);
      ASSERT_NE(finding, nullptr) << key << quantity;
      EXPECT_FALSE(finding->value) << key << quantity;
      EXPECT_EQ(finding->word, word) << key << quantity;
    }
  }
  EXPECT_TRUE(part_of(outcome, "mean_thresholds").empty());
  EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("could not be estimated"));
  const NamedTable& table = discrimination_table(outcome, "thresholds");
  const Table shown = reading_table(table);
  EXPECT_EQ(shown.rows[0].back(), Cell(std::string("below_levels")));
  // The same remedies as in the list of the report, which has the statuses of the findings.
  EXPECT_EQ(found.find("jnd", "poor|all")->status,
            "the threshold is above the presented levels: present larger differences");
  for (const char* const key : {"perfect|all", "poor|all"}) {
    std::string sentence = found.find("jnd", key)->status;
    EXPECT_THAT(table.note.english(), HasSubstr(sentence.substr(1)));
  }
  EXPECT_THAT(table.note.english(), Not(HasSubstr("running the procedure again")));
}

TEST(Discrimination, OfOneParticipantHasThresholdsWithoutTests) {
  const AnalysisOutcome outcome = outcome_of_observers(kPerformer, 1, kAbove_m, true);
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const Finding* const mean = FoundNumbers(means).find("mean.jnd", "all");
  ASSERT_TRUE(mean != nullptr && mean->value);
  EXPECT_FALSE(mean->low);
  EXPECT_THAT(sentence_about(outcome, "order"), HasSubstr("cannot be tested with one participant"));
  EXPECT_THAT(answer_to(outcome, "order"), HasSubstr("Not tested: "));
}

// A staircase presents each participant other levels, and few trials at each.
TEST(Discrimination, TakesLevelsWithUnequalNumbersOfTrials) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  for (int person = 0; person < 8; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    MadeUpObserver observer(kPerformer, static_cast<unsigned>(person));
    std::vector<MadeUpChoice> choices{};
    for (int step = 1; step <= 30; ++step) {
      for (const MadeUpChoice& one :
           observer.choices({kStandard_m + step * 0.8e-6}, 1 + (step + person) % 7, true)) {
        choices.push_back(one);
      }
    }
    std::vector<MadeUpTrial> trials = trials_of(choices);
    MadeUpTrial unanswered = trials.front();  // at a level at which there is no response
    unanswered.factors_json = json{{"amplitude_m", 90e-6}}.dump();
    unanswered.answers.clear();
    unanswered.right.clear();
    unanswered.outcome = AttemptOutcome::timed_out;
    trials.push_back(unanswered);
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const Finding* const mean = FoundNumbers(means).find("mean.jnd", "all");
  ASSERT_TRUE(mean != nullptr && mean->low);
  EXPECT_EQ(mean->n, 8U);
  EXPECT_LE(*mean->low, kPerformer.inverse(0.75));
  EXPECT_GE(*mean->high, kPerformer.inverse(0.75));
  const NamedTable& levels = discrimination_table(outcome, "psychometric");
  EXPECT_EQ(levels.table.rows.size(), 8U * 30U) << "none at the level without a response";
}

/// The first line of the exported wide table by name of its column, and that of the given row.
std::map<std::string, std::string> wide_row(MadeUpStudy& made, std::size_t row) {
  ExportOptions options{};
  options.formats = {ExportFormat::wide};
  export_study(made.study(), built_in_models(), made.beside("wide"), options);
  std::istringstream file(read_file(made.beside("wide") / "wide.csv"));
  std::string header{};
  std::string line{};
  std::getline(file, header);
  for (std::size_t i = 0; i <= row; ++i) std::getline(file, line);
  for (std::string* const each : {&header, &line}) {
    if (each->ends_with('\r')) each->pop_back();
  }
  const std::vector<std::string> names = parts_of(header, ',');
  const std::vector<std::string> cells = parts_of(line, ',');
  std::map<std::string, std::string> found{};
  for (std::size_t i = 0; i < names.size(); ++i) found[names[i]] = cells.at(i);
  return found;
}

TEST(Discrimination, HasThresholdsInTheWideTable) {
  MadeUpStudy made;
  const std::int64_t performed = made.add_protocol("performed", "discrimination",
                                                   discrimination_protocol("performance").dump());
  const std::int64_t compared =
      made.add_protocol("compared", "discrimination", discrimination_protocol("comparison").dump());
  made.add_person("p1", "");
  made.add_session("p1", performed,
                   trials_of(MadeUpObserver(kPerformer, 1).choices(kAbove_m, 40, true)));
  made.add_session("p1", compared,
                   trials_of(MadeUpObserver(kComparer, 1).choices(kAround_m, 40, false)));
  const auto outcomes = analyze_study(made.study(), std::nullopt, {});
  ExportOptions options{};
  options.formats = {ExportFormat::wide};
  export_study(made.study(), built_in_models(), made.beside("out"), options);
  std::istringstream file(read_file(made.beside("out") / "wide.csv"));
  std::string header{};
  std::string row{};
  std::getline(file, header);
  std::getline(file, row);
  for (std::string* const line : {&header, &row}) {
    if (line->ends_with('\r')) line->pop_back();
  }
  const std::vector<std::string> names = parts_of(header, ',');
  const std::vector<std::string> cells = parts_of(row, ',');
  const auto cell = [&](const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? std::string("no such column")
                             : cells.at(static_cast<std::size_t>(at - names.begin()));
  };
  for (const AnalysisOutcome& outcome : outcomes) {
    const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
    const FoundNumbers found(thresholds);
    EXPECT_NEAR(std::stod(cell(outcome.protocol + "_which_jnd")), *found.value("jnd", "p1|all"),
                1e-12);
    EXPECT_NEAR(std::stod(cell(outcome.protocol + "_which_weber")), *found.value("weber", "p1|all"),
                1e-9);
    if (outcome.protocol == "compared") {
      EXPECT_NEAR(std::stod(cell("compared_which_pse")), *found.value("pse", "p1|all"), 1e-12);
    }
  }
  EXPECT_EQ(cell("performed_which_n"), "200");
  EXPECT_EQ(cell("performed_which_pse"), "no such column");
  EXPECT_EQ(header.find("correct"), std::string::npos) << header;
}

TEST(Discrimination, TestsWhetherThresholdsDifferBetweenConditions) {
  const auto outcome_with = [](const std::vector<std::string>& textures) {
    MadeUpStudy made;
    const std::int64_t protocol =
        made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
    for (int person = 0; person < 8; ++person) {
      const std::string label = "p" + std::to_string(person);
      made.add_person(label, "");
      std::vector<MadeUpTrial> trials{};
      for (std::size_t i = 0; i < textures.size(); ++i) {
        PsychometricFunction function = kPerformer;
        function.alpha = i == 0 ? 5e-6 : 14e-6;
        MadeUpObserver observer(function,
                                static_cast<unsigned>(10 * person) + static_cast<unsigned>(i));
        std::vector<MadeUpChoice> choices = observer.choices(kAbove_m, 40, true);
        for (MadeUpChoice& choice : choices) choice.texture = textures[i];
        for (const MadeUpTrial& trial : trials_of(choices)) trials.push_back(trial);
      }
      made.add_session(label, protocol, trials);
    }
    return outcome_of_discrimination(made);
  };
  const AnalysisOutcome two = outcome_with({"metal", "wood"});
  EXPECT_THAT(sentence_about(two, "conditions", "JND"),
              HasSubstr("The JND was significantly different between the conditions: Wilcoxon"));
  EXPECT_THAT(answer_to(two, "conditions"), HasSubstr("metal: "));
  EXPECT_THAT(answer_to(two, "conditions"), HasSubstr("wood: "));
  const std::vector<Finding> means = part_of(two, "mean_thresholds");
  const FoundNumbers found(means);
  EXPECT_LT(*found.value("mean.jnd", "metal"), *found.value("mean.jnd", "wood"));
  for (const Finding& finding : two.findings) {
    EXPECT_FALSE(finding.quantity.starts_with("friedman.")) << "a pair has one test";
  }
  const AnalysisOutcome three = outcome_with({"metal", "stone", "wood"});
  EXPECT_THAT(sentence_about(three, "conditions", "JND"), HasSubstr("Friedman test"));
  EXPECT_THAT(find_analysis("discrimination")->estimates(three).text, HasSubstr("stone, JND "));
}

// As strings "0.01" comes before "9e-04".
TEST(Discrimination, NamesConditionsThatAreNumbersByTheirFactor) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  for (unsigned person = 0; person < 3; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials{};
    for (const double wavelength_m : {0.01, 0.0009}) {
      for (MadeUpTrial& trial :
           trials_of(MadeUpObserver(kPerformer, person).choices(kAbove_m, 40, true))) {
        json factors = json::parse(trial.factors_json);
        factors["wavelength_m"] = wavelength_m;
        factors.erase("texture");
        trial.factors_json = factors.dump();
        trials.push_back(std::move(trial));
      }
    }
    made.add_session(label, protocol, trials);
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::string answer = answer_to(outcome, "conditions");
  EXPECT_THAT(answer, HasSubstr("wavelength 900 µm: "));
  EXPECT_LT(answer.find("wavelength 900 µm"), answer.find("wavelength 10 mm"));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("wavelength 10 mm, JND "));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  EXPECT_NE(FoundNumbers(means).find("mean.jnd", "wavelength_m 9e-04"), nullptr);
}

TEST(Discrimination, StatesThatNoParticipantHasAllConditions) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  for (unsigned person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    std::vector<MadeUpChoice> choices =
        MadeUpObserver(kPerformer, person).choices(kAbove_m, 40, true);
    for (MadeUpChoice& choice : choices) choice.texture = person % 2 == 0 ? "metal" : "wood";
    made.add_session(label, protocol, trials_of(choices));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(sentence_about(outcome, "conditions", "JND"),
              HasSubstr("no participant has trials in every condition"));
  EXPECT_THAT(answer_to(outcome, "conditions"),
              HasSubstr("no participant has trials in every condition"));
}

TEST(Discrimination, DoesNotDivideTheTrialsByFactorsThatAreDrawn) {
  for (const bool is_drawn : {false, true}) {
    json protocol = discrimination_protocol("performance");
    if (is_drawn) protocol["blocks"]["only"]["drawn"] = {"texture"};
    MadeUpStudy made;
    const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
    made.add_person("p1", "");
    std::vector<MadeUpChoice> choices = MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true);
    for (std::size_t i = 0; i < choices.size(); ++i) {
      choices[i].texture = i % 4 < 2 ? "metal" : "wood";
    }
    made.add_session("p1", id, trials_of(choices));
    const AnalysisOutcome outcome = outcome_of_discrimination(made);
    const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
    EXPECT_EQ(FoundNumbers(thresholds).find("jnd", "p1|all") != nullptr, is_drawn);
    ExportOptions options{};
    options.formats = {ExportFormat::wide};
    export_study(made.study(), built_in_models(), made.beside("out"), options);
    const std::string wide = read_file(made.beside("out") / "wide.csv");
    EXPECT_EQ(wide.find("jnd_which_jnd") != std::string::npos, is_drawn);
    EXPECT_EQ(wide.find("jnd_which_metal_jnd") != std::string::npos, !is_drawn);
  }
}

TEST(Discrimination, RemarksThatTheDirectionOfTheChoicesIsUncertain) {
  PsychometricFunction guessing = kComparer;
  guessing.gamma = guessing.lambda = 0.5;
  const auto has_remark = [](const AnalysisOutcome& outcome) {
    return std::any_of(outcome.remarks.begin(), outcome.remarks.end(), [](const Phrase& remark) {
      return remark.english().find("increase or decrease with the level") != std::string::npos;
    });
  };
  EXPECT_TRUE(has_remark(outcome_of_observers(guessing, 2, kAround_m, false)));
  EXPECT_FALSE(has_remark(outcome_of_observers(kComparer, 2, kAround_m, false)));
  EXPECT_FALSE(has_remark(outcome_of_observers(kPerformer, 2, kAbove_m, true)));
}

TEST(Discrimination, TakesTheDirectionOfTheQuestionFromTheProtocolWhereItIsStated) {
  DiscriminationTask task{.is_performance = false};
  EXPECT_TRUE(counts_standard(task, -3.0)) << "from the responses";
  EXPECT_FALSE(counts_standard(task, 3.0));
  task.asks_for_less = true;
  EXPECT_TRUE(counts_standard(task, 3.0));
  task.asks_for_less = false;
  EXPECT_FALSE(counts_standard(task, -3.0));
  EXPECT_FALSE(counts_standard({.is_performance = true}, -3.0));
}

TEST(Discrimination, AlwaysEstimatesTheEffectOfTheOrder) {
  const AnalysisOutcome biased = outcome_of_observers(kComparer, 8, kAround_m, false, 40, 0.2);
  const std::vector<Finding> order = part_of(biased, "order");
  const Finding* const mean = FoundNumbers(order).find("order.difference");
  ASSERT_TRUE(mean != nullptr && mean->value);
  EXPECT_GT(*mean->low, 0.0);
  EXPECT_THAT(sentence_about(biased, "order"),
              HasSubstr("The comparison was chosen significantly more often as surface A than as "
                        "surface B: Wilcoxon signed-rank test"));
  EXPECT_THAT(answer_to(biased, "order"), HasSubstr("percentage points"));
  const AnalysisOutcome other = outcome_of_observers(kComparer, 8, kAround_m, false, 40, -0.2);
  EXPECT_THAT(sentence_about(other, "order"), HasSubstr("significantly less often"));
  const AnalysisOutcome none = outcome_of_observers(kComparer, 8, kAround_m, false);
  EXPECT_THAT(sentence_about(none, "order"), HasSubstr("not significantly different"));
}

// Of three participants the first chooses the comparison equally often in both positions. The p of the other two is at
// least 2/2² = .5; of six it is 2/2⁶ = .031.
TEST(Discrimination, StatesWhoIsLeftOutOfASignedRankTestAndHowManyItNeeds) {
  MadeUpStudy made;
  json undeclared = discrimination_protocol("performance");
  undeclared["analysis"]["family"] = {"order"};
  const std::int64_t id = made.add_protocol("jnd", "discrimination", undeclared.dump());
  for (int person = 0; person < 3; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    std::vector<MadeUpChoice> choices{};
    for (const double value_m : kAbove_m) {
      for (int i = 0; i < 8; ++i) {
        const bool first = i % 2 == 0;
        choices.push_back(
            {.value_m = value_m,
             .chose_comparison = first || i < 2 || person == 0 || (i < 4 && person == 1),
             .comparison_first = first});
      }
    }
    made.add_session(label, id, trials_of(choices));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(answer_to(outcome, "order"),
              HasSubstr("the smallest attainable p is .500, so that no result could be significant "
                        "with 2 participants whose difference is not zero; at least 6 such "
                        "participants are required"));
  EXPECT_THAT(
      answer_to(outcome, "order"),
      HasSubstr("One of 3 participants has a difference of zero and is left out of the test."));
  EXPECT_THAT(discrimination_table(outcome, "tests").note.english(),
              HasSubstr("whom n does not count: position of the comparison (1 of 3)."));
}

TEST(Discrimination, CountsErrorsInCatchTrialsAndEstimatesNothingFromThem) {
  const auto outcome_with = [](bool with_catch_trials) {
    MadeUpStudy made;
    const std::int64_t protocol =
        made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
    for (const std::string label : {"p1", "p2"}) {
      MadeUpObserver observer(kPerformer, label == "p1" ? 1 : 2);
      std::vector<MadeUpTrial> trials = trials_of(observer.choices(kAbove_m, 40, true));
      for (int i = 0; i < 5 && with_catch_trials; ++i) {
        MadeUpTrial easy = discriminated({.value_m = 100e-6, .chose_comparison = i > 0});
        if (i == 4) {  // a missed deadline
          easy.outcome = AttemptOutcome::timed_out;
          easy.answers.clear();
          easy.right.clear();
        }
        easy.repetition = 0;
        easy.is_catch = true;
        easy.valid = label == "p1" || i != 3;
        trials.push_back(easy);
      }
      made.add_person(label, "");
      made.add_session(label, protocol, trials);
    }
    return outcome_of_discrimination(made);
  };
  const AnalysisOutcome with = outcome_with(true);
  const AnalysisOutcome without = outcome_with(false);
  EXPECT_EQ(discrimination_table(with, "thresholds").table.rows,
            discrimination_table(without, "thresholds").table.rows);
  EXPECT_EQ(discrimination_table(with, "order").table.rows,
            discrimination_table(without, "order").table.rows);
  EXPECT_EQ(with.count.planned_trials, without.count.planned_trials);
  const Table& caught = discrimination_table(with, "catch_trials").table;
  const std::vector<std::vector<Cell>> expected{
      {std::string("p1"), std::string("only"), std::int64_t{3}, std::int64_t{5}, 0.6},
      {std::string("p2"), std::string("only"), std::int64_t{2}, std::int64_t{4}, 0.5}};
  EXPECT_EQ(caught.rows, expected);
  EXPECT_THROW(discrimination_table(without, "catch_trials"), std::runtime_error);
}

TEST(Discrimination, NeverReportsProportionsOverLevelsOfAProcedure) {
  json protocol = discrimination_protocol("performance");
  MadeUpStudy made;
  const std::int64_t constant = made.add_protocol("constant", "discrimination", protocol.dump());
  protocol["blocks"]["only"]["procedure"] = {{"method", "transformed_up_down"}};
  const std::int64_t adaptive = made.add_protocol("adaptive", "discrimination", protocol.dump());
  for (const char* const label : {"p1", "p2"}) {
    made.add_person(label, "");
    for (const std::int64_t id : {constant, adaptive}) {
      made.add_session(label, id,
                       trials_of(MadeUpObserver(kPerformer, 3).choices(kAbove_m, 20, true)));
    }
  }
  for (const AnalysisOutcome& outcome : analyze_study(made.study(), std::nullopt, {})) {
    const bool is_constant = outcome.protocol == "constant";
    EXPECT_EQ(column_of(discrimination_table(outcome, "order").table, "share_first").has_value(),
              is_constant);
    EXPECT_EQ(column_of(discrimination_table(outcome, "trial_course").table, "share").has_value(),
              is_constant);
    EXPECT_TRUE(column_of(discrimination_table(outcome, "order").table, "difference"));
  }
}

/// Two participants, with the choices of two blocks.
AnalysisOutcome outcome_of_two_blocks(const json& protocol, const std::vector<MadeUpChoice>& only,
                                      std::vector<MadeUpChoice> other) {
  for (MadeUpChoice& choice : other) choice.block = "other";
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("two", "discrimination", protocol.dump());
  for (const char* const label : {"p1", "p2"}) {
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials = trials_of(only);
    for (const MadeUpTrial& trial : trials_of(other)) trials.push_back(trial);
    made.add_session(label, id, trials);
  }
  return outcome_of_discrimination(made);
}

json protocol_with_two_blocks(const std::string& judgement) {
  json protocol = discrimination_protocol(judgement);
  protocol["blocks"]["other"] = protocol["blocks"]["only"];
  return protocol;
}

TEST(Discrimination, MakesBlocksOfTheSameTaskConditions) {
  json protocol = protocol_with_two_blocks("performance");
  protocol["stimuli"]["fine"] = protocol["stimuli"]["grating"];
  for (json& surface : protocol["blocks"]["other"]["presented"]) surface["stimulus"] = "fine";
  // How the levels are stated does not matter.
  protocol["blocks"]["other"]["vary"].erase("levels");
  protocol["blocks"]["other"]["vary"]["levels_percent"] = json::array();
  PsychometricFunction worse = kPerformer;
  worse.alpha = 16e-6;
  const AnalysisOutcome outcome =
      outcome_of_two_blocks(protocol, MadeUpObserver(kPerformer, 5).choices(kAbove_m, 80, true),
                            MadeUpObserver(worse, 6).choices(kAbove_m, 80, true));
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  EXPECT_FALSE(found.find("jnd", "p1|all"));
  EXPECT_NEAR(*found.value("jnd", "p1|only"), kPerformer.inverse(0.75), 3e-6);
  EXPECT_NEAR(*found.value("jnd", "p1|other"), worse.inverse(0.75), 5e-6);
  EXPECT_NE(answer_to(outcome, "threshold"), "") << "it is one task";
  EXPECT_THAT(answer_to(outcome, "conditions"), HasSubstr("other: "));
}

TEST(Discrimination, SeparatesTasksByTheirQuestion) {
  for (const char* const key : {"name", "prompt"}) {
    json protocol = protocol_with_two_blocks("performance");
    protocol["blocks"]["other"]["question"][key] = "Which is harder?";
    const std::vector<MadeUpChoice> choices =
        MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true);
    const AnalysisOutcome outcome = outcome_of_two_blocks(protocol, choices, choices);
    EXPECT_NE(answer_to(outcome, "threshold:only"), "") << key;
    EXPECT_NE(answer_to(outcome, "threshold:other"), "") << key;
  }
}

TEST(Discrimination, AnswersWithTheTestsOfTheTaskOnly) {
  json protocol = protocol_with_two_blocks("comparison");
  protocol["blocks"]["only_harder"] = protocol["blocks"]["other"];
  protocol["blocks"].erase("other");
  protocol["blocks"]["only_harder"]["question"]["prompt"] = "Which is smoother?";
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("two", "discrimination", protocol.dump());
  for (unsigned person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "");
    std::vector<MadeUpChoice> choices =
        MadeUpObserver(kComparer, 10 + person).choices(kAround_m, 40, false);
    for (MadeUpChoice choice :
         MadeUpObserver(kComparer, 30 + person).choices(kAround_m, 40, false)) {
      choice.block = "only_harder";
      choice.chose_comparison = !choice.chose_comparison;
      choices.push_back(choice);
    }
    made.add_session(label, id, trials_of(choices));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality:only"),
              Not(HasSubstr("only_harder")));
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality:only_harder"),
              HasSubstr("(only_harder)"));
  const std::string note = discrimination_table(outcome, "psychometric").note.english();
  EXPECT_THAT(note, HasSubstr("only: Hits are choices of the comparison."));
  EXPECT_THAT(note, HasSubstr("only_harder: Hits are choices of the standard"));
}

TEST(Discrimination, StatesReasonsInTheWordsOfTheJudgement) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("compared", "discrimination", discrimination_protocol("comparison").dump());
  PsychometricFunction always = kComparer;
  always.gamma = 1.0;
  always.lambda = 0.0;
  PsychometricFunction never = kComparer;
  never.gamma = 0.0;
  never.lambda = 1.0;
  PsychometricFunction high = kComparer;
  high.alpha = 70e-6;
  PsychometricFunction steep = kComparer;
  steep.gamma = steep.lambda = 0.0;
  steep.beta = 1e9;
  for (const auto& [label, function] :
       {std::pair{"always", always}, std::pair{"high", high}, std::pair{"never", never},
        std::pair{"steep", steep}, std::pair{"usual", kComparer}}) {
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(MadeUpObserver(function, 3).choices(kAround_m, 60, false)));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  for (const auto& [key, quantity, word] : {std::tuple{"always|all", "pse", "below_levels"},
                                            std::tuple{"high|all", "pse", "outside_levels"},
                                            std::tuple{"high|all", "slope", "outside_levels"},
                                            std::tuple{"never|all", "pse", "above_levels"},
                                            std::tuple{"never|all", "slope", "above_levels"},
                                            std::tuple{"steep|all", "jnd", "slope_at_bound"},
                                            std::tuple{"steep|all", "slope", "slope_at_bound"}}) {
    const Finding* const finding = found.find(quantity, key);
    ASSERT_NE(finding, nullptr) << key << quantity;
    EXPECT_FALSE(finding->value) << key << quantity;
    EXPECT_EQ(finding->word, word) << key << quantity;
    EXPECT_THAT(finding->status, Not(HasSubstr("correct"))) << key << quantity;
    EXPECT_THAT(finding->status, Not(HasSubstr("differences"))) << key << quantity;
  }
  EXPECT_TRUE(found.value("slope", "usual|all"));
}

TEST(Discrimination, ByComparisonWithAStandardOfZeroIsNotADetection) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol(
      "zero", "discrimination", discrimination_protocol("comparison", 0.0).dump());
  for (const char* const label : {"p1", "p2", "p3"}) {
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(MadeUpObserver(kComparer, 4).choices(kAround_m, 40, false)));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::string text = find_analysis("discrimination")->estimates(outcome).text;
  EXPECT_THAT(text, HasSubstr("JND "));
  EXPECT_THAT(text, Not(HasSubstr("detection")));
}

TEST(Discrimination, SeparatesBlocksThatVaryDifferentParameters) {
  json protocol = discrimination_protocol("performance");
  protocol["blocks"]["other"] = protocol["blocks"]["only"];
  protocol["blocks"]["other"]["question"]["judgement"] = "comparison";
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("two", "discrimination", protocol.dump());
  for (const char* const label : {"p1", "p2"}) {
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials =
        trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true));
    std::vector<MadeUpChoice> compared = MadeUpObserver(kComparer, 6).choices(kAround_m, 40, false);
    for (MadeUpChoice& choice : compared) choice.block = "other";
    for (const MadeUpTrial& trial : trials_of(compared)) trials.push_back(trial);
    made.add_session(label, id, trials);
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  EXPECT_TRUE(found.value("jnd", "p1|only"));
  EXPECT_TRUE(found.value("pse", "p1|other"));
  EXPECT_FALSE(found.find("pse", "p1|only"));
  EXPECT_NE(answer_to(outcome, "threshold:only"), "");
  EXPECT_NE(answer_to(outcome, "point_of_subjective_equality:other"), "");
}

// Two interleaved tracks in each of two runs of a block, and one of a second session.
TEST(Discrimination, ListsTheTrialsOfTracksInTheirOrder) {
  MadeUpStudy made;
  const std::int64_t id =
      made.add_protocol("jnd", "discrimination", discrimination_protocol("performance").dump());
  made.add_person("p1", "");
  const auto run_of = [](int block_ordinal, int tracks) {
    std::vector<MadeUpTrial> trials{};
    int count = 0;
    for (MadeUpTrial& trial : trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 2, true))) {
      trial.block_ordinal = block_ordinal;
      trial.track = 1 + count % tracks;
      trial.step = 1 + count++ / tracks;
      trials.push_back(trial);
    }
    return trials;
  };
  std::vector<MadeUpTrial> trials = run_of(2, 2);
  for (const MadeUpTrial& trial : run_of(4, 2)) trials.push_back(trial);
  made.add_session("p1", id, trials);
  made.add_session("p1", id, run_of(2, 1));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const Table& tracks = discrimination_table(outcome, "tracks").table;
  ASSERT_EQ(tracks.rows.size(), 30U);
  std::vector<std::vector<std::int64_t>> expected{};
  for (const auto& [session, block_ordinal, track, steps] :
       {std::tuple{1, 2, 1, 5}, std::tuple{1, 2, 2, 5}, std::tuple{1, 4, 1, 5},
        std::tuple{1, 4, 2, 5}, std::tuple{2, 2, 1, 10}}) {
    for (int step = 1; step <= steps; ++step) {
      expected.push_back({session, block_ordinal, track, step});
    }
  }
  std::vector<std::vector<std::int64_t>> listed{};
  for (const std::vector<Cell>& row : tracks.rows) {
    std::vector<std::int64_t>& one = listed.emplace_back();
    for (const char* const column : {"session", "block_ordinal", "track", "step"}) {
      one.push_back(std::get<std::int64_t>(row[*column_of(tracks, column)]));
    }
  }
  EXPECT_EQ(listed, expected);
  EXPECT_EQ(tracks.rows.back()[*column_of(tracks, "level")], Cell(kAbove_m.back()));
}

/// A 3-down/1-up staircase from 2 to 100 % above the standard, as in the library's amplitude_jnd.
json staircase_protocol(int trials) {
  json protocol = discrimination_protocol("performance");
  json& block = protocol["blocks"]["only"];
  block["vary"].erase("levels");
  block["vary"]["levels_percent"] = {{"lowest", 2}, {"highest", 100}, {"step", 2}};
  block["procedure"] = {{"method", "transformed_up_down"},
                        {"down", 3},
                        {"up", 1},
                        {"steps", {16, 8, 4}},
                        {"stop", {{"trials", trials}}},
                        {"tracks", {{{"start", 50}}, {{"start", 34}}}}};
  return protocol;
}

/// The trials of the tracks of the staircase by this observer.
std::vector<MadeUpTrial> staircase_trials(const PsychometricFunction& observer,
                                          const json& protocol, std::uint64_t seed) {
  const StoredProtocol::Block block = stored_protocol(protocol.dump()).blocks.at("only");
  std::vector<MadeUpTrial> trials{};
  for (std::size_t i = 0; i < block.tracks.size(); ++i) {
    const auto chance = [&](double level) {
      return observer.value(block.vary->value_of(level) - kStandard_m);
    };
    const Random of_track = Random(seed).split(static_cast<std::uint64_t>(i));
    int step = 0;
    for (const LevelAnswer& answer : simulated_track(block.tracks[i], chance, of_track)) {
      MadeUpTrial trial = discriminated({.value_m = block.vary->value_of(answer.level),
                                         .chose_comparison = answer.is_correct,
                                         .comparison_first = step % 2 == 0});
      trial.track = static_cast<int>(i) + 1;
      trial.step = ++step;
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

AnalysisOutcome outcome_of_staircases(const json& protocol, int people, std::size_t kept) {
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  for (int person = 0; person < people; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials =
        staircase_trials(kPerformer, protocol, 200 + static_cast<std::uint64_t>(person));
    trials.resize(std::min(kept, trials.size()));
    made.add_session(label, id, trials);
  }
  return outcome_of_discrimination(made);
}

TEST(Discrimination, RepeatsTheProcedureForTheIntervalsOfItsThresholds) {
  const json protocol = staircase_protocol(40);
  const AnalysisOutcome outcome = outcome_of_staircases(protocol, 12, 80);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  const double jnd_m = kPerformer.inverse(0.75);
  int given = 0;
  int holding = 0;
  for (const Finding* const jnd : found.all("jnd")) {
    if (!jnd->value) continue;
    ASSERT_TRUE(jnd->low && jnd->high) << jnd->key;
    EXPECT_THAT(jnd->method, HasSubstr("running the procedure again: 500 repetitions"));
    EXPECT_THAT(jnd->method, Not(HasSubstr("delta")));
    EXPECT_LT(*jnd->low, *jnd->value);
    EXPECT_GT(*jnd->high, *jnd->value);
    ++given;
    holding += *jnd->low <= jnd_m && jnd_m <= *jnd->high ? 1 : 0;
    const auto without = found.value("without", jnd->key);
    ASSERT_TRUE(without);
    EXPECT_LT(*without, 250.0);
  }
  EXPECT_GE(given, 10);
  EXPECT_GE(holding, given - 2) << "of 95 % intervals";
  const std::vector<Finding> functions = part_of(outcome, "psychometric");
  for (const Finding* const beta : FoundNumbers(functions).all("fit.beta")) {
    EXPECT_GE(*beta->value, 1.0);
    EXPECT_LE(*beta->value, 8.0);
  }
  const NamedTable& table = discrimination_table(outcome, "thresholds");
  const auto without = column_of(table.table, "without_threshold");
  ASSERT_TRUE(without);
  EXPECT_EQ(table.table.rows[0][*column_of(table.table, "repetitions")], Cell(std::int64_t{500}));
  const Table shown = reading_table(table);
  EXPECT_FALSE(column_of(shown, "repetitions"));
  const Cell of_all = shown.rows[0][*column_of(shown, "without_threshold")];
  EXPECT_THAT(std::get<std::string>(of_all), testing::EndsWith("/500"));
  EXPECT_THAT(table.note.english(), HasSubstr("running the procedure again"));
  EXPECT_THAT(table.note.english(), Not(HasSubstr("delta"))) << "no interval is of this method";
  EXPECT_EQ(part_of(outcome_of_staircases(protocol, 2, 80), "thresholds"),
            part_of(outcome_of_staircases(protocol, 2, 80), "thresholds"))
      << "the same for the same responses";
}

// A track that ended before its rule did is repeated with as many trials as it has.
TEST(Discrimination, RepeatsUnfinishedTracksWithTheirNumberOfTrials) {
  const json protocol = staircase_protocol(120);
  const AnalysisOutcome unfinished = outcome_of_staircases(protocol, 1, 60);
  const AnalysisOutcome finished = outcome_of_staircases(staircase_protocol(60), 1, 60);
  const std::vector<Finding> thresholds = part_of(unfinished, "thresholds");
  EXPECT_EQ(thresholds, part_of(finished, "thresholds"));
  const Finding* const jnd = FoundNumbers(thresholds).find("jnd", "p10|all");
  EXPECT_TRUE(jnd != nullptr && jnd->low && jnd->high);
  const StoredProtocol::Block block = stored_protocol(protocol.dump()).blocks.at("only");
  ASSERT_EQ(block.tracks.size(), 2U);
  Dimension varied = *block.vary;
  const DiscriminationTask task{.is_performance = true, .varied = varied};
  const PlacedTrials placed{.tracks = {{.settings = block.tracks[0], .levels = varied}},
                            .fixed = {{60e-6, 7}}};
  std::uint64_t trials = 0;
  for (const PsychometricBlock& one : run_again(task, placed, kPerformer, Random(1))) {
    trials += one.trials;
  }
  EXPECT_EQ(trials, 120U + 7U);
}

// The third session was stopped after 60 of its 80 trials: the second track has 20 of 40.
TEST(Discrimination, MarksParticipantsWithAnUnfinishedTrack) {
  const json protocol = staircase_protocol(40);
  const auto study_of = [&](MadeUpStudy& made, SessionState last) {
    const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
    for (int person = 0; person < 3; ++person) {
      const std::string label = "p" + std::to_string(10 + person);
      made.add_person(label, "");
      std::vector<MadeUpTrial> trials =
          staircase_trials(kPerformer, protocol, 200 + static_cast<std::uint64_t>(person));
      if (person == 2) {
        trials.resize(60);
        made.set_state(last);
      }
      made.add_session(label, id, trials);
    }
  };
  MadeUpStudy made;
  study_of(made, SessionState::stopped);
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const NamedTable& table = discrimination_table(outcome, "thresholds");
  const auto unfinished = column_of(table.table, "unfinished_tracks");
  ASSERT_TRUE(unfinished);
  EXPECT_EQ(table.table.rows[0][*unfinished], Cell{});
  EXPECT_EQ(table.table.rows[2][*unfinished], Cell(std::int64_t{1}));
  EXPECT_THAT(table.note.english(),
              HasSubstr("Unfinished tracks: tracks that were begun and not finished"));
  EXPECT_THAT(
      answer_to(outcome, "threshold"),
      HasSubstr(" Participants with an unfinished track: 1 of 3. Estimates from unfinished tracks "
                "that are included in the mean, because the presented trials were sufficient: 1 of "
                "1."));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("Tracks of one of 3 participants were unfinished; the threshold was "
                        "estimated from the presented trials and is included in the means."));
  EXPECT_EQ(wide_row(made, 2).at("jnd_which_unfinished_tracks"), "1");

  // In a completed session the missing answers belong to attempts that do not count.
  MadeUpStudy completed;
  study_of(completed, SessionState::completed);
  EXPECT_FALSE(
      column_of(discrimination_table(outcome_of_discrimination(completed), "thresholds").table,
                "unfinished_tracks"));
  EXPECT_FALSE(wide_row(completed, 2).contains("jnd_which_unfinished_tracks"));
}

// Three trials at one or two levels have no threshold.
TEST(Discrimination, StatesNothingAboutTheMeanWhereAnUnfinishedTrackHasNoThreshold) {
  const json protocol = staircase_protocol(40);
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  made.add_person("p10", "");
  std::vector<MadeUpTrial> trials = staircase_trials(kPerformer, protocol, 200);
  trials.resize(3);
  made.set_state(SessionState::stopped);
  made.add_session("p10", id, trials);
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(answer_to(outcome, "threshold"),
              testing::AllOf(HasSubstr(" Participants with an unfinished track: 1 of 1."),
                             Not(HasSubstr("included in the mean"))));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("Tracks of the only participant were unfinished; no threshold could be "
                        "estimated from the presented trials."));
}

/// The same levels with psi, in two tracks.
json psi_protocol(int trials) {
  json protocol = staircase_protocol(trials);
  protocol["blocks"]["only"]["procedure"] = {
      {"method", "psi"},
      {"stop", {{"trials", trials}}},
      {"tracks", json::array({json::object(), json::object()})}};
  return protocol;
}

TEST(Discrimination, ReportsThePosteriorThresholdOfPsiNextToTheFittedOne) {
  const AnalysisOutcome outcome = outcome_of_staircases(psi_protocol(40), 8, 80);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  const double jnd_m = kPerformer.inverse(0.75);
  int holding = 0;
  for (const Finding* const posterior : found.all("jnd.posterior")) {
    ASSERT_TRUE(posterior->value && posterior->low && posterior->high) << posterior->key;
    EXPECT_EQ(posterior->unit, "m");
    EXPECT_THAT(posterior->method, HasSubstr("credible interval"));
    EXPECT_LT(*posterior->low, *posterior->value);
    EXPECT_GT(*posterior->high, *posterior->value);
    EXPECT_NEAR(std::log10(*posterior->value / jnd_m), 0.0, 0.25);
    holding += *posterior->low <= jnd_m && jnd_m <= *posterior->high ? 1 : 0;
    const auto fitted = found.value("jnd", posterior->key);
    if (fitted) {
      EXPECT_NEAR(std::log10(*posterior->value / *fitted), 0.0, 0.15);
    }
  }
  EXPECT_EQ(found.all("jnd.posterior").size(), 8U);
  const Finding* const fitted = found.find("jnd", "p10|all");
  ASSERT_NE(fitted, nullptr);
  EXPECT_FALSE(fitted->low);
  EXPECT_EQ(found.find("without", "p10|all"), nullptr) << "the procedure is not run again";
  EXPECT_GE(holding, 6) << "of 95 % intervals";
  const NamedTable& table = discrimination_table(outcome, "thresholds");
  EXPECT_TRUE(column_of(table.table, "jnd_posterior_low"));
  EXPECT_THAT(table.note.english(), HasSubstr("Posterior JND: mean of the posterior"));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  EXPECT_TRUE(FoundNumbers(means).value("geomean.jnd.posterior", "all"));
  const AnalysisOutcome of_staircases = outcome_of_staircases(staircase_protocol(40), 1, 80);
  EXPECT_FALSE(column_of(discrimination_table(of_staircases, "thresholds").table, "jnd_posterior"));
}

// The same probabilities from the trials themselves: 41 thresholds from 2 to 100 % of 50 µm, 8 slopes, 4 lapse rates.
TEST(Discrimination, ComputesThePosteriorThresholdWithThePriorOfTheProtocol) {
  const json protocol = psi_protocol(20);
  const AnalysisOutcome outcome = outcome_of_staircases(protocol, 1, 40);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const auto stated = FoundNumbers(thresholds).value("jnd.posterior", "p10|all");
  ASSERT_TRUE(stated);
  double sum = 0.0;
  double weighted = 0.0;
  for (int i = 0; i < 41; ++i) {
    for (int j = 0; j < 8; ++j) {
      for (int k = 0; k < 4; ++k) {
        PsychometricFunction f{.shape = PsychometricShape::weibull,
                               .alpha = 1.0,
                               .beta = std::pow(8.0, j / 7.0),
                               .gamma = 0.5,
                               .lambda = 0.02 * k};
        const double threshold_m = 1e-6 * std::pow(50.0, i / 40.0);
        f.alpha = threshold_m / f.inverse(0.75);
        double likelihood = 1.0;
        for (const MadeUpTrial& trial : staircase_trials(kPerformer, protocol, 200)) {
          const double value_m = json::parse(trial.factors_json)["amplitude_m"].get<double>();
          const double hit = f.value(value_m - kStandard_m);
          likelihood *= trial.answers.front() == "comparison" ? hit : 1.0 - hit;
        }
        sum += likelihood;
        weighted += likelihood * std::log(threshold_m);
      }
    }
  }
  EXPECT_NEAR(*stated / std::exp(weighted / sum), 1.0, 1e-6);
}

TEST(Discrimination, HasNoPosteriorThresholdThatThePriorDetermines) {
  const json protocol = psi_protocol(30);
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  made.add_person("guesser", "");
  const PsychometricFunction guesser{
      .shape = PsychometricShape::weibull, .alpha = 1.0, .beta = 1.0, .gamma = 0.5};
  made.add_session("guesser", id, staircase_trials(guesser, protocol, 3));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const Finding* const posterior = FoundNumbers(thresholds).find("jnd.posterior", "guesser|all");
  ASSERT_NE(posterior, nullptr);
  EXPECT_FALSE(posterior->value);
  EXPECT_EQ(posterior->word, "at_end_of_prior");
  EXPECT_THAT(posterior->status, HasSubstr("widen the range"));
}

TEST(Discrimination, HasNoIntervalOfAProcedureThatCannotBeRepeated) {
  const json protocol = staircase_protocol(40);
  json unknown = protocol;
  unknown["blocks"]["only"]["procedure"]["steps"] = {3};  // not on the grid
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", unknown.dump());
  made.add_person("p1", "");
  made.add_session("p1", id, staircase_trials(kPerformer, protocol, 3));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const Finding* const jnd = FoundNumbers(thresholds).find("jnd", "p1|all");
  ASSERT_TRUE(jnd != nullptr && jnd->value);
  EXPECT_FALSE(jnd->low || jnd->high);
  EXPECT_THAT(jnd->method, HasSubstr("cannot be repeated"));
}

TEST(Discrimination, StatesTheSimulatedCoverageOfItsIntervals) {
  const auto note_of = [](const json& protocol, std::size_t kept) {
    return discrimination_table(outcome_of_staircases(protocol, 1, kept), "thresholds")
        .note.english();
  };
  const auto coverages = simulated_coverages();
  const auto is_of_library = [](const SimulatedCoverage& each) {
    return each.down == 3 && each.tracks == 2 && each.trials == 40;
  };
  std::vector<SimulatedCoverage> rows{};
  std::copy_if(coverages.begin(), coverages.end(), std::back_inserter(rows), is_of_library);
  ASSERT_EQ(rows.size(), 2U);
  const bool deviates = std::any_of(rows.begin(), rows.end(), [](const SimulatedCoverage& row) {
    return row.coverage_percent < 93.0 || row.coverage_percent > 97.0;
  });
  const std::string simulated = note_of(staircase_protocol(40), 80);
  EXPECT_EQ(simulated.find("3-down/1-up, 2 × 40 trials") != std::string::npos, deviates)
      << simulated;
  EXPECT_THAT(simulated, Not(HasSubstr("was not simulated")));
  EXPECT_THAT(note_of(staircase_protocol(41), 82), HasSubstr("was not simulated"));
}

TEST(Discrimination, StatesWhyThereAreNoThresholds) {
  json protocol = discrimination_protocol("performance");
  protocol["blocks"]["only"].erase("vary");
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("old", "discrimination", protocol.dump());
  made.add_person("p1", "");
  made.add_session("p1", id, trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 4, true)));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(outcome.remarks.back().english(), HasSubstr("thresholds cannot be estimated"));
}

TEST(Discrimination, ShowsThresholdsWithTheirUnits) {
  const AnalysisOutcome outcome = outcome_of_observers(kPerformer, 3, kAbove_m, true);
  for (const char* const name : {"thresholds", "mean_thresholds", "psychometric"}) {
    const Table shown = reading_table(discrimination_table(outcome, name));
    EXPECT_FALSE(column_of(shown, "unit")) << name;
    const bool has_unit =
        std::any_of(shown.rows.front().begin(), shown.rows.front().end(), [](const Cell& cell) {
          const auto* const text = std::get_if<std::string>(&cell);
          return text != nullptr && text->find("µm") != std::string::npos;
        });
    EXPECT_TRUE(has_unit) << name;
  }
}

TEST(Discrimination, IsDescribedInTheReportAndInAPaper) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name != "amplitude_jnd") continue;
    const Protocol protocol =
        read_protocol(each.text, "amplitude_jnd.json", declarations_of(built_in_models()));
    const StudyAnalysis& analysis = *find_analysis("discrimination");
    const std::string task = analysis.task(protocol);
    EXPECT_THAT(task, HasSubstr("Task: two-interval forced choice."));
    EXPECT_THAT(
        task,
        HasSubstr("The amplitude of the standard is 50 µm; that of the comparison "
                  "differs from it by 2 % to 100 % in 50 levels. Choice of the level: "
                  "3-down/1-up staircase (79.4 %), 40 trials × 2 interleaved tracks, one catch "
                  "trial in every 20 trials. In a catch trial the comparison differs from "
                  "the standard by 150 %; no threshold is estimated from these trials."));
    EXPECT_THAT(task, HasSubstr("The comparison is the correct response"));
    const std::string paper = analysis.task_for_paper(protocol);
    EXPECT_THAT(paper, HasSubstr("(two-interval forced choice, 2IFC)"));
    EXPECT_THAT(paper,
                HasSubstr("could differ from it by 2 % to 100 % in 50 levels. The choice of the "
                          "comparison was correct. A 3-down/1-up staircase [Levitt 1971]"));
    const std::string fit = analysis.fit_for_paper(protocol);
    EXPECT_THAT(fit, HasSubstr("guess rate fixed at 50 % and a lapse rate between 0 and 6 %"));
    EXPECT_THAT(fit, HasSubstr("with 500 simulated observers"));
    EXPECT_THAT(paper, Not(HasSubstr("subjective equality")));
    return;
  }
  ADD_FAILURE() << "the library has no such protocol";
}

}  // namespace
}  // namespace asperity
