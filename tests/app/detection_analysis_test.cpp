// Discriminations whose responses are words, from the rows of a study to thresholds, tables and sentences.

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/detection_function.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "protocols/kind_keys/discrimination_design.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using DetectionJson = nlohmann::json;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kStandardOfDetections_m = 50e-6;
const std::vector<double> kDifferences_m{4e-6, 8e-6, 12e-6, 18e-6, 26e-6};

DetectionJson detection_protocol(const DiscriminationDesign& design) {
  DetectionJson protocol = DetectionJson::parse(R"({"kind": "discrimination",
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-05}}},
    "blocks": {"only": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "which", "prompt": "Did they differ?", "judgement": "performance"}}}})");
  protocol["blocks"]["only"]["design"] = std::string(design.id);
  return protocol;
}

MadeUpTrial detected(const DiscriminationDesign& design, const DesignTrial& type, double value_m,
                     bool says_yes) {
  MadeUpTrial trial{};
  trial.factors_json =
      DetectionJson{
          {"amplitude_m", type.presents("comparison") ? value_m : kStandardOfDetections_m}}
          .dump();
  for (const std::string_view role : type.roles) {
    if (role.empty()) continue;
    const bool is_second = !trial.surfaces.empty() && trial.surfaces.front().role == role;
    trial.surfaces.push_back(
        surface_of(std::string(role) + (is_second ? "_2" : ""), "sinusoid", ""));
    trial.surfaces.back().role = std::string(role);
  }
  trial.answers = {std::string(says_yes ? design.yes : design.no)};
  trial.options = {std::string(design.yes), std::string(design.no)};
  trial.right = {std::string(type.is_signal ? design.yes : design.no)};
  return trial;
}

/// The proportion of "yes" to a signal with this difference, and without a signal to 0.
using YesAt = double (*)(const DetectionFunction& observer, double x_m);
double as_modelled(const DetectionFunction& observer, double x_m) { return observer.value(x_m); }
double as_step(const DetectionFunction&, double x_m) { return x_m > 0.0 ? 1.0 : 0.0; }
double as_reversed(const DetectionFunction&, double x_m) { return x_m > 0.0 ? 0.0 : 1.0; }
double as_never(const DetectionFunction&, double) { return 0.0; }
double as_always(const DetectionFunction&, double) { return 1.0; }
double as_coin(const DetectionFunction&, double) { return 0.5; }

struct Detecting {
  const DiscriminationDesign& design;
  YesAt yes_at = as_modelled;
  int people = 12;
  int rounds = 30;
  YesAt of_every_other = nullptr;
  bool declares_order = true;
};

/// Computed once in this process for these participants.
const AnalysisOutcome& outcome_of_detections(const Detecting& detecting) {
  const DiscriminationDesign& design = detecting.design;
  const DetectionFunction observer{
      .task = design.surfaces() == 1 ? DetectionTask::yes_no : DetectionTask::same_different,
      .alpha = 10e-6,
      .beta = 1.2,
      .criterion = design.surfaces() == 1 ? 0.8 : 1.6,
      .lambda = 0.02};
  const auto trials_of_person = [&](int person) {
    const bool is_other = detecting.of_every_other != nullptr && person % 2 == 1;
    const YesAt yes_at = is_other ? detecting.of_every_other : detecting.yes_at;
    std::mt19937 random(static_cast<unsigned>(200 + person));
    std::vector<MadeUpTrial> trials{};
    for (int round = 0; round < detecting.rounds; ++round) {
      for (const double difference_m : kDifferences_m) {
        for (const DesignTrial& type : design.trials) {
          const double p = yes_at(observer, type.is_signal ? difference_m : 0.0);
          trials.push_back(detected(design, type, kStandardOfDetections_m + difference_m,
                                    static_cast<double>(random()) / 4294967296.0 < p));
        }
      }
    }
    return trials;
  };
  const auto code_of = [&observer](YesAt at) {
    return at == nullptr ? std::string("none") : outcome_key(at(observer, 0.0), at(observer, 1.0));
  };
  const std::string key =
      outcome_key("detected", design.id, code_of(detecting.yes_at), detecting.people,
                  detecting.rounds, code_of(detecting.of_every_other), detecting.declares_order);
  return outcome_once(key, [&] {
    DetectionJson protocol = detection_protocol(design);
    if (detecting.declares_order) protocol["analysis"]["family"] = {"order"};
    MadeUpStudy made;
    add_participants(made, made.add_protocol("jnd", "discrimination", protocol.dump()),
                     {.number = detecting.people}, trials_of_person);
    return outcome_of_discrimination(made);  // the only one
  });
}

const std::vector<const DiscriminationDesign*>& designs_in_words() {
  static const std::vector<const DiscriminationDesign*> kDesigns{&yes_no_task(),
                                                                 &same_different_task()};
  return kDesigns;
}

TEST(DetectionAnalysis, RecoversTheDifferenceAtUnitSensitivity) {
  for (const DiscriminationDesign* const design : designs_in_words()) {
    SCOPED_TRACE(std::string(design->id));
    const AnalysisOutcome& outcome = outcome_of_detections({.design = *design});
    const FoundNumbers found(outcome.findings);
    int holding = 0;
    for (const Finding* const jnd : found.all("jnd.dprime1")) {
      ASSERT_TRUE(jnd->value && jnd->low && jnd->high) << jnd->key << ' ' << jnd->status;
      EXPECT_EQ(jnd->unit, "m");
      holding += *jnd->low <= 10e-6 && 10e-6 <= *jnd->high ? 1 : 0;
      EXPECT_NEAR(*found.value("weber", jnd->key), *jnd->value / kStandardOfDetections_m, 1e-12);
    }
    EXPECT_GE(holding, 9) << "of 12 intervals of 95 %";
    EXPECT_EQ(found.find("jnd", "p10|all"), nullptr) << "there is no proportion correct";
    EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("just-noticeable differences"));
    EXPECT_THAT(answer_to(outcome, "sensitivity"), HasSubstr("Mean d′ by the amplitude"));
    EXPECT_TRUE(answer_to(outcome, "order").empty());
    EXPECT_EQ(find_table(outcome, "order"), nullptr);
  }
}

TEST(DetectionAnalysis, StatesHitsAndFalseAlarmsOfEveryLevelAndPair) {
  const AnalysisOutcome& outcome = outcome_of_detections({.design = same_different_task()});
  const StoredTable& sensitivity = table_of(outcome, "sensitivity");
  EXPECT_EQ(sensitivity.table.rows.size(), 12U * kDifferences_m.size());
  const auto signal = column_of(sensitivity.table, "signal_trials");
  const auto noise = column_of(sensitivity.table, "noise_trials");
  ASSERT_TRUE(signal && noise);
  EXPECT_EQ(sensitivity.table.rows[0][*signal], Cell{std::int64_t{60}});
  EXPECT_EQ(sensitivity.table.rows[0][*noise], Cell{std::int64_t{300}});
  const StoredTable& pairs = table_of(outcome, "responses_by_pair");
  // Made-up trials present every different pair in the listed order.
  EXPECT_EQ(pairs.table.rows.size(), 12U * 3U);
  EXPECT_EQ(find_table(outcome_of_detections({.design = yes_no_task()}), "responses_by_pair"),
            nullptr);
}

// k of the differencing rule from the corrected proportion F of false alarms: F = 2·Φ(−k/√2).
TEST(DetectionAnalysis, StatesTheCriterionOfSameDifferent) {
  const AnalysisOutcome& outcome = outcome_of_detections({.design = same_different_task()});
  const Table& table = table_of(outcome, "sensitivity").table;
  EXPECT_FALSE(column_of(table, "criterion"));
  const double k = number_of(table.rows[0][*column_of(table, "criterion_k")]).value();
  const double false_alarms =
      number_of(table.rows[0][*column_of(table, "false_alarm_rate")]).value();
  EXPECT_NEAR(std::erfc(0.5 * k), (300.0 * false_alarms + 0.5) / 301.0, 1e-9);
  const AnalysisOutcome& yes_no = outcome_of_detections({.design = yes_no_task()});
  const Table& of_yes_no = table_of(yes_no, "sensitivity").table;
  EXPECT_TRUE(column_of(of_yes_no, "criterion"));
  EXPECT_FALSE(column_of(of_yes_no, "criterion_k"));
}

// 10 trials with a signal and 50 without: z(½/11) − z(½/51).
TEST(DetectionAnalysis, StatesThatSensitivityWithoutAnyYesFollowsFromTheNumbersOfTrials) {
  for (const auto& [yes_at, expected] :
       {std::pair<YesAt, double>{as_never, 0.643}, {as_always, -0.643}}) {
    const AnalysisOutcome& outcome = outcome_of_detections(
        {.design = yes_no_task(), .yes_at = yes_at, .people = 1, .rounds = 10});
    const StoredTable& sensitivity = table_of(outcome, "sensitivity");
    const auto dprime = column_of(sensitivity.table, "d_prime");
    EXPECT_NEAR(number_of(sensitivity.table.rows[0][*dprime]).value(), expected, 1e-3);
    EXPECT_THAT(sensitivity.note.english(), HasSubstr("with and without a signal: 5. Their d′"));
  }
  const AnalysisOutcome& other = outcome_of_detections(
      {.design = yes_no_task(), .yes_at = as_coin, .people = 7, .rounds = 10});
  EXPECT_THAT(table_of(other, "sensitivity").note.english(), Not(HasSubstr("Their d′")));
}

// With 10 trials of each kind at a level and no error, d′ = z(10.5/11) − z(0.5/51) for every participant: its spread is no
// measure of precision.
TEST(DetectionAnalysis, StatesThatAMeanSensitivityAtTheCeilingIsALowerBound) {
  const AnalysisOutcome& outcome = outcome_of_detections(
      {.design = yes_no_task(), .yes_at = as_step, .people = 7, .rounds = 10});
  const FoundNumbers found(outcome.findings);
  const std::vector<const Finding*> means = found.all("dprime.mean");
  ASSERT_EQ(means.size(), kDifferences_m.size());
  for (const Finding* const mean : means) {
    EXPECT_TRUE(mean->value);
    EXPECT_FALSE(mean->low) << mean->key;
    EXPECT_THAT(mean->method, HasSubstr("d′ of 7 of 7 participants"));
  }
  EXPECT_THAT(answer_to(outcome, "sensitivity"), HasSubstr("(at least; ceiling: 7 of 7 "));
  EXPECT_THAT(answer_to(outcome, "sensitivity"), HasSubstr("is a lower bound and has no CI"));
  const AnalysisOutcome& other = outcome_of_detections(
      {.design = yes_no_task(), .yes_at = as_coin, .people = 7, .rounds = 10});
  EXPECT_THAT(answer_to(other, "sensitivity"), Not(HasSubstr("ceiling")));
  EXPECT_TRUE(FoundNumbers(other.findings).all("dprime.mean").front()->low);
}

// Without a correction, the d′ of those who respond "yes" only without a signal is −∞.
TEST(DetectionAnalysis, StatesThatAMeanSensitivityAtTheFloorIsNoLowerBound) {
  const AnalysisOutcome& reversed = outcome_of_detections(
      {.design = yes_no_task(), .yes_at = as_reversed, .people = 6, .rounds = 10});
  EXPECT_THAT(answer_to(reversed, "sensitivity"), HasSubstr("(at most; floor: 6 of 6 "));
  EXPECT_THAT(answer_to(reversed, "sensitivity"), HasSubstr("is an upper bound and has no CI"));
  EXPECT_THAT(answer_to(reversed, "sensitivity"), Not(HasSubstr("at least")));
  const AnalysisOutcome& both = outcome_of_detections({.design = yes_no_task(),
                                                       .yes_at = as_step,
                                                       .people = 6,
                                                       .rounds = 10,
                                                       .of_every_other = as_reversed});
  EXPECT_THAT(answer_to(both, "sensitivity"),
              HasSubstr("(ceiling: 3, floor: 3 of 6 participants)"));
  EXPECT_THAT(answer_to(both, "sensitivity"),
              HasSubstr("is neither a lower nor an upper bound, and has no CI"));
  for (const Finding* const mean : FoundNumbers(both.findings).all("dprime.mean")) {
    EXPECT_FALSE(mean->low) << mean->key;
    EXPECT_THAT(mean->method, HasSubstr("not a bound: d′ of 6 of 6 participants"));
  }
}

// The differencing rule has no negative d′: that of a guessing participant is 0 or greater by chance.
TEST(DetectionAnalysis, StatesThatMeansOfSmallSensitivitiesAreTooHigh) {
  const AnalysisOutcome& guesses = outcome_of_detections(
      {.design = same_different_task(), .yes_at = as_coin, .people = 7, .rounds = 10});
  const std::string answer = answer_to(guesses, "sensitivity");
  EXPECT_THAT(answer,
              HasSubstr("means of small d′ are too high. Participants with d′ = 0: 54 µm: "));
  for (const Finding& finding : guesses.findings) {
    if (finding.quantity == "dprime.diff.loglinear" && finding.low) {
      EXPECT_GE(*finding.low, 0.0) << finding.key;
    }
    if (finding.quantity.starts_with("dprime.") &&
        finding.quantity.find(".lower") != std::string::npos) {
      EXPECT_GE(finding.value.value_or(0.0), 0.0) << finding.quantity << ' ' << finding.key;
    }
  }
  EXPECT_THAT(
      answer_to(outcome_of_detections(
                    {.design = yes_no_task(), .yes_at = as_coin, .people = 7, .rounds = 10}),
                "sensitivity"),
      Not(HasSubstr("too high")));
}

TEST(DetectionAnalysis, StatesHowManyThresholdsCouldNotBeEstimated) {
  const AnalysisOutcome& outcome = outcome_of_detections(
      {.design = yes_no_task(), .people = 6, .rounds = 20, .of_every_other = as_always});
  EXPECT_THAT(
      answer_to(outcome, "threshold"),
      HasSubstr("No mean threshold is reported. Left out of 6 thresholds: 3 not estimated ("));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const Finding* const mean = FoundNumbers(means).find("geomean.jnd.dprime1", "all");
  ASSERT_NE(mean, nullptr);
  EXPECT_FALSE(mean->value);
  EXPECT_EQ(mean->word, "no_bound");
}

TEST(DetectionAnalysis, StatesWhichPairsHaveADifferenceOfZero) {
  const AnalysisOutcome& outcome = outcome_of_detections(
      {.design = same_different_task(), .yes_at = as_coin, .people = 7, .rounds = 10});
  EXPECT_THAT(table_of(outcome, "psychometric").note.english(),
              HasSubstr("two standards, or two comparisons of any level"));
}

TEST(DetectionAnalysis, HasNoThresholdOfAnObserverWithoutErrors) {
  for (const DiscriminationDesign* const design : designs_in_words()) {
    const AnalysisOutcome& outcome =
        outcome_of_detections({.design = *design, .yes_at = as_step, .people = 2, .rounds = 10});
    const Finding* const jnd = FoundNumbers(outcome.findings).find("jnd.dprime1", "p10|all");
    ASSERT_NE(jnd, nullptr);
    EXPECT_FALSE(jnd->value);
    EXPECT_EQ(jnd->word, "separated");
    EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("could not be estimated"));
  }
}

// Twelve guessing participants: the mean d′ of a level has a standard error of about 0.12 (yes/no, 30 and 150 trials).
TEST(DetectionAnalysis, HasASensitivityOfZeroOfGuessingObservers) {
  const AnalysisOutcome& outcome =
      outcome_of_detections({.design = yes_no_task(), .yes_at = as_coin});
  const FoundNumbers found(outcome.findings);
  const std::vector<const Finding*> means = found.all("dprime.mean");
  EXPECT_EQ(means.size(), kDifferences_m.size());
  for (const Finding* const mean : means) EXPECT_NEAR(*mean->value, 0.0, 3.29 * 0.12) << mean->key;
}

TEST(DetectionAnalysis, ExplainsWhyThereIsNoOrderEffect) {
  const AnalysisOutcome& outcome = outcome_of_detections({.design = yes_no_task()});
  const Table& tests = table_of(outcome, "tests").table;
  const auto status = column_of(tests, "status");
  ASSERT_TRUE(status);
  EXPECT_EQ(tests.rows[0][*status], Cell{std::string("no_choice_of_surface")});
}

TEST(DetectionAnalysis, TestsNoOrderThatTheProtocolDoesNotDeclare) {
  for (const DiscriminationDesign* const design : designs_in_words()) {
    const AnalysisOutcome& outcome = outcome_of_detections(
        {.design = *design, .people = 2, .rounds = 10, .declares_order = false});
    EXPECT_THAT(outcome.test_sentences, Not(Contains(Field(&TestSentence::test, "order"))))
        << design->id;
    EXPECT_EQ(answer_to(outcome, "order"), "") << design->id;
  }
}

}  // namespace
}  // namespace asperity
