// Discriminations in which one of three surfaces is chosen, from the rows of a study to thresholds, tables and sentences.

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ThreeJson = nlohmann::json;

constexpr PsychometricFunction kObserverOfThree{.shape = PsychometricShape::weibull,
                                                .alpha = 10e-6,
                                                .beta = 2.0,
                                                .gamma = 1.0 / 3.0,
                                                .lambda = 0.02};

const std::vector<const DiscriminationDesign*>& designs_of_three() {
  static const std::vector<const DiscriminationDesign*> kDesigns{&three_alternatives(),
                                                                 &oddity_task()};
  return kDesigns;
}

ThreeJson protocol_of_three(const DiscriminationDesign& design) {
  ThreeJson protocol = discrimination_protocol("performance");
  protocol["blocks"]["only"]["design"] = std::string(design.id);
  return protocol;
}

/// A trial with the correct surface at a place, and the answer at another or the same one.
MadeUpTrial chosen_of_three(const DesignTrial& type, double value_m, std::size_t correct,
                            std::size_t chosen) {
  MadeUpTrial trial{};
  trial.factors_json = ThreeJson{{"amplitude_m", value_m}}.dump();
  // The last role of a type is that of the correct surface.
  const std::string odd(type.roles[2]);
  const std::string other(type.roles[0]);
  bool has_other = false;
  for (std::size_t place = 0; place < 3; ++place) {
    const std::string item = place == correct ? odd : other + (has_other ? "_2" : "");
    has_other = has_other || place != correct;
    trial.surfaces.push_back(surface_of(item, "sinusoid", ""));
    trial.surfaces.back().role = place == correct ? odd : other;
    trial.options.push_back(item);
  }
  trial.answers = {trial.options.at(chosen)};
  trial.right = {odd};
  return trial;
}

/// Errors are at the next place, or with a preference always at the first one where that is incorrect.
enum class Errors { at_any_place, at_first_place };

std::vector<MadeUpTrial> trials_of_three(const DiscriminationDesign& design,
                                         const PsychometricFunction& observer, int rounds,
                                         unsigned seed, Errors errors) {
  std::mt19937 random(seed);
  std::vector<MadeUpTrial> trials{};
  std::size_t count = 0;
  for (int round = 0; round < rounds; ++round) {
    for (const double value_m : kAbove_m) {
      for (const DesignTrial& type : design.trials) {
        const std::size_t correct = (count++ + static_cast<std::size_t>(round)) % 3;
        const bool is_correct =
            static_cast<double>(random()) / 4294967296.0 < observer.value(value_m - kStandard_m);
        const std::size_t wrong =
            errors == Errors::at_first_place && correct != 0 ? 0 : (correct + 1 + random() % 2) % 3;
        trials.push_back(chosen_of_three(type, value_m, correct, is_correct ? correct : wrong));
      }
    }
  }
  return trials;
}

constexpr PsychometricFunction kGuesserAmongThree{.shape = PsychometricShape::weibull,
                                                  .alpha = 1.0,
                                                  .beta = 2.0,
                                                  .gamma = 1.0 / 3.0,
                                                  .lambda = 0.02};

/// Computed once in this process for twelve participants with 30 trials of each type and level, or with 60.
const AnalysisOutcome& outcome_of_three(const DiscriminationDesign& design,
                                        const PsychometricFunction& observer, int trials = 60) {
  const int rounds = trials / static_cast<int>(design.trials.size());
  return outcome_once(outcome_key("three", design.id, observer.alpha, rounds), [&] {
    return outcome_of_choices(protocol_of_three(design), {.number = 12}, [&](int person) {
      return trials_of_three(design, observer, rounds, static_cast<unsigned>(300 + person),
                             Errors::at_any_place);
    });
  });
}

// The planted threshold is at 2/3 correct, halfway between guessing and certainty.
TEST(ChoiceOfThreeAnalysis, RecoversThePlantedThreshold) {
  const double jnd_m = kObserverOfThree.inverse(2.0 / 3.0);
  for (const DiscriminationDesign* const design : designs_of_three()) {
    SCOPED_TRACE(std::string(design->id));
    const AnalysisOutcome& outcome = outcome_of_three(*design, kObserverOfThree);
    const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
    int given = 0;
    int holding = 0;
    for (const Finding* const jnd : FoundNumbers(thresholds).all("jnd")) {
      if (!jnd->value || !jnd->low || !jnd->high) continue;
      ++given;
      holding += *jnd->low <= jnd_m && jnd_m <= *jnd->high ? 1 : 0;
    }
    EXPECT_GE(given, 10) << "of 12 participants";
    EXPECT_GE(holding, given - 2) << "of 95 % intervals";
    const std::vector<Finding> functions = part_of(outcome, "psychometric");
    EXPECT_DOUBLE_EQ(*FoundNumbers(functions).value("fit.gamma", "p10|all"), 1.0 / 3.0);
    EXPECT_THAT(table_of(outcome, "thresholds").note.english(), HasSubstr("guess rate of 1/3"));
    EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("just-noticeable differences"));
  }
}

TEST(ChoiceOfThreeAnalysis, StatesTheDifferenceWithUnitSensitivityByTheRuleOfTheDesign) {
  EXPECT_NEAR(
      ForcedChoice{.alternatives = 3}.dprime(proportion_at_unit_sensitivity(three_alternatives())),
      1.0, 1e-9);
  EXPECT_NEAR(Oddity{}.dprime(proportion_at_unit_sensitivity(oddity_task())), 1.0, 1e-9);
  // As the notes below the tables state them.
  EXPECT_NEAR(proportion_at_unit_sensitivity(three_alternatives()), 0.634, 5e-4);
  EXPECT_NEAR(proportion_at_unit_sensitivity(oddity_task()), 0.418, 5e-4);
  EXPECT_EQ(proportion_at_unit_sensitivity(two_alternatives()), kProportionAtUnitSensitivity);
  EXPECT_EQ(proportion_at_threshold(two_alternatives()), kProportionAtThreshold);
}

TEST(ChoiceOfThreeAnalysis, HasSensitivitiesByEveryRuleOfTheDesign) {
  for (const DiscriminationDesign* const design : designs_of_three()) {
    const AnalysisOutcome& outcome = outcome_of_three(*design, kObserverOfThree);
    const Table& table = table_of(outcome, "sensitivity_of_choices").table;
    EXPECT_EQ(table.rows.size(), 12U * kAbove_m.size());
    const auto share = column_of(table, "share");
    const auto dprime = column_of(table, "d_prime");
    const auto independent = column_of(table, "d_prime_independent");
    ASSERT_TRUE(share && dprime);
    EXPECT_EQ(independent.has_value(), design->asks_for_odd_one);
    for (const std::vector<Cell>& row : table.rows) {
      const double p = std::get<double>(row[*share]);
      if (p == 1.0) {
        EXPECT_EQ(row[*dprime], Cell{}) << "infinite";
        continue;
      }
      const double expected = design->asks_for_odd_one
                                  ? Oddity{.rule = DecisionRule::differencing}.dprime(p)
                                  : ForcedChoice{.alternatives = 3}.dprime(p);
      EXPECT_NEAR(std::get<double>(row[*dprime]), expected, 1e-9);
      if (!independent) continue;
      EXPECT_NEAR(std::get<double>(row[*independent]),
                  Oddity{.rule = DecisionRule::independent}.dprime(p), 1e-9);
    }
  }
}

// The interval of the mean over twelve participants has 95 %; 3.29/1.96 of it contain the planted d′ with 99.9 %.
TEST(ChoiceOfThreeAnalysis, StatesTheMeanSensitivityOverTheParticipants) {
  for (const DiscriminationDesign* const design : designs_of_three()) {
    SCOPED_TRACE(std::string(design->id));
    const AnalysisOutcome& outcome = outcome_of_three(*design, kObserverOfThree);
    const std::vector<Finding> sensitivity = part_of(outcome, "sensitivity");
    const FoundNumbers found(sensitivity);
    EXPECT_EQ(found.all("dprime.mean").size(), kAbove_m.size());
    for (const char* const level : {"6e-05", "6.5e-05"}) {
      const Finding* const mean = found.find("dprime.mean", std::string("all|") + level);
      ASSERT_TRUE(mean != nullptr && mean->value && mean->low && mean->high) << level;
      const double p = kObserverOfThree.value(std::stod(level) - kStandard_m);
      const double planted =
          design->asks_for_odd_one ? Oddity{}.dprime(p) : ForcedChoice{.alternatives = 3}.dprime(p);
      const double reach = 3.29 / 1.96 * 0.5 * (*mean->high - *mean->low);
      EXPECT_NEAR(*mean->value, planted, reach) << level;
      EXPECT_LT(reach, 0.25 * planted) << "the interval is of use";
    }
    EXPECT_THAT(answer_to(outcome, "sensitivity"),
                HasSubstr("Mean d′ by the amplitude of the comparison: 52.5 µm: "));
    EXPECT_THAT(answer_to(outcome, "sensitivity"), HasSubstr("; 60 µm: "));
    EXPECT_THAT(answer_to(outcome, "sensitivity"), HasSubstr(" (95 % CI ["));
  }
}

// 30 trials at each level have a standard error of d′ of about 0.27; the mean of twelve participants has 0.08.
TEST(ChoiceOfThreeAnalysis, HasAMeanSensitivityOfZeroForObserversWhoGuessAmongAlternatives) {
  const std::vector<Finding> sensitivity =
      part_of(outcome_of_three(three_alternatives(), kGuesserAmongThree, 30), "sensitivity");
  for (const Finding* const mean : FoundNumbers(sensitivity).all("dprime.mean")) {
    EXPECT_NEAR(*mean->value, 0.0, 3.29 * 0.08) << mean->key;
  }
}

// Twelve guessing participants with 150 trials each: the mean proportion correct has a standard error of 0.011, and no
// place is preferred.
TEST(ChoiceOfThreeAnalysis, IsAtChanceForGuessingObservers) {
  for (const DiscriminationDesign* const design : designs_of_three()) {
    SCOPED_TRACE(std::string(design->id));
    const AnalysisOutcome& outcome = outcome_of_three(*design, kGuesserAmongThree, 30);
    const Table& levels = table_of(outcome, "psychometric").table;
    double hits = 0.0;
    double trials = 0.0;
    for (const std::vector<Cell>& row : levels.rows) {
      hits += static_cast<double>(std::get<std::int64_t>(row[*column_of(levels, "hits")]));
      trials += static_cast<double>(std::get<std::int64_t>(row[*column_of(levels, "responses")]));
    }
    EXPECT_NEAR(hits / trials, 1.0 / 3.0, 3.29 * std::sqrt(2.0 / 9.0 / trials));
    const std::vector<Finding> order = part_of(outcome, "order");
    for (const char* const place : {"A", "B", "C"}) {
      const auto mean = FoundNumbers(order).value("place.proportion", place);
      ASSERT_TRUE(mean);
      EXPECT_NEAR(*mean, 1.0 / 3.0, 3.29 * std::sqrt(2.0 / 9.0 / trials)) << place;
    }
  }
}

TEST(ChoiceOfThreeAnalysis, FindsAPreferenceForAPlace) {
  for (const DiscriminationDesign* const design : designs_of_three()) {
    const int rounds = 30 / static_cast<int>(design->trials.size());
    const AnalysisOutcome outcome =
        outcome_of_choices(protocol_of_three(*design), {.number = 8}, [&](int person) {
          return trials_of_three(*design, kObserverOfThree, rounds,
                                 static_cast<unsigned>(300 + person), Errors::at_first_place);
        });
    const Table& places = table_of(outcome, "choices_by_place").table;
    ASSERT_EQ(places.rows.size(), 8U);
    for (const std::vector<Cell>& row : places.rows) {
      const double a = std::get<double>(row[*column_of(places, "chosen_a")]);
      const double b = std::get<double>(row[*column_of(places, "chosen_b")]);
      const double c = std::get<double>(row[*column_of(places, "chosen_c")]);
      EXPECT_NEAR(a + b + c, 1.0, 1e-12);
    }
    const std::vector<Finding> order = part_of(outcome, "order");
    const FoundNumbers found(order);
    EXPECT_GT(*found.value("place.proportion", "A"), 0.36);
    EXPECT_LT(*found.value("place.proportion", "B"), 1.0 / 3.0);
    EXPECT_LT(*found.value("place.proportion", "C"), 1.0 / 3.0);
    EXPECT_THAT(sentence_about(outcome, "order"),
                HasSubstr("The proportions of choices of the three positions were significantly "
                          "different"));
    EXPECT_THAT(answer_to(outcome, "order"), HasSubstr("Yes: mean proportions of choices: A "));
    EXPECT_EQ(find_table(outcome, "order"), nullptr);
  }
}

// The likelihood-ratio interval of a repeated staircase contains the planted threshold.
TEST(ChoiceOfThreeAnalysis, RepeatsAProcedureWithTheGuessRateOfTheDesign) {
  const Dimension levels{.factor = "amplitude_m",
                         .parameter = "amplitude_m",
                         .role = "comparison",
                         .standard_role = "standard",
                         .measure = LevelMeasure::difference,
                         .standard = kStandard_m};
  const UpDownTrack track{.grid = {.lowest = 1e-6, .highest = 40e-6, .step = 1e-6},
                          .start = 20e-6,
                          .rule = {.up = 1, .down = 2},
                          .steps_up = {2e-6, 1e-6},
                          .steps_down = {2e-6, 1e-6},
                          .stop = {.trials = 80}};
  DiscriminationTask task{.name = "only", .design = &oddity_task(), .varied = levels};
  PlacedTrials placed{};
  placed.tracks.push_back({.settings = TransformedUpDown{track}, .levels = levels});
  const auto blocks = run_again(task, placed, kObserverOfThree, Random(5));
  DiscriminationData data{.key = "p1|all", .by_procedure = true, .placed = placed};
  for (const PsychometricBlock& block : blocks) {
    data.hits[kStandard_m + block.x] = {.hits = block.hits, .trials = block.trials};
  }
  const DiscriminationFit fit = fit_discrimination(task, {&data, 1});
  const Finding* const jnd = FoundNumbers(fit.thresholds).find("jnd", "p1|all");
  ASSERT_NE(jnd, nullptr);
  ASSERT_TRUE(jnd->value && jnd->low && jnd->high) << jnd->status;
  EXPECT_LE(*jnd->low, kObserverOfThree.inverse(2.0 / 3.0));
  EXPECT_GE(*jnd->high, kObserverOfThree.inverse(2.0 / 3.0));
}

TEST(ChoiceOfThreeAnalysis, HasThresholdsInTheWideTable) {
  for (const DiscriminationDesign* const design : designs_of_three()) {
    MadeUpStudy made;
    const std::int64_t protocol =
        made.add_protocol("jnd", "discrimination", protocol_of_three(*design).dump());
    made.add_person("p10", "");
    made.add_session("p10", protocol,
                     trials_of_three(*design, kObserverOfThree, 30, 1, Errors::at_any_place));
    const std::vector<Finding> thresholds = part_of(outcome_of_discrimination(made), "thresholds");
    const std::map<std::string, std::string> row = wide_rows(made).at(0);
    EXPECT_NEAR(std::stod(row.at("jnd_which_jnd")),
                *FoundNumbers(thresholds).value("jnd", "p10|all"), 1e-12)
        << design->id;
  }
}

TEST(ChoiceOfThreeAnalysis, IsDescribedInTheReportAndInAPaper) {
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name != "amplitude_jnd") continue;
    Protocol protocol =
        read_protocol(each.text, "amplitude_jnd.json", declarations_of(built_in_models()));
    const StudyAnalysis& analysis = *find_analysis("discrimination");
    Protocol::Block& block = protocol.blocks.at("comparisons");
    block.own = DiscriminationBlock{&three_alternatives()};
    EXPECT_THAT(analysis.task(protocol),
                HasSubstr("Task: three-alternative forced choice. In each trial, three surfaces "
                          "are presented one after the other, two standards and a comparison"));
    EXPECT_THAT(analysis.task_for_paper(protocol),
                HasSubstr("(three-alternative forced choice, 3AFC)"));
    EXPECT_THAT(analysis.fit_for_paper(protocol, {}), HasSubstr("guess rate fixed at 33.3 %"));
    EXPECT_THAT(analysis.fit_for_paper(protocol, {}), HasSubstr("at 66.7 % correct responses"));
    block.own = DiscriminationBlock{&oddity_task()};
    EXPECT_THAT(analysis.task(protocol), HasSubstr("Task: oddity task. In each trial, three"));
    EXPECT_THAT(analysis.task(protocol), HasSubstr("The odd surface is the correct response."));
    EXPECT_THAT(analysis.task_for_paper(protocol),
                HasSubstr("The choice of the odd surface was correct."));
    return;
  }
  ADD_FAILURE() << "the library has no such protocol";
}

}  // namespace
}  // namespace asperity
