// Discriminations by the choice of a surface, from the rows of a study to thresholds, the order effect and sentences.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/study/analyze_study.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "tests/app/coverage_counts.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Discrimination, RecoversTheThresholdOfObserversWithinItsInterval) {
  const AnalysisOutcome& outcome = outcome_of_performers();
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
  constexpr std::array kAlphas_m{3e-6, 4e-6, 24e-6};
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 3}, [&](int person) {
        PsychometricFunction function = kPerformer;
        function.alpha = kAlphas_m.at(static_cast<std::size_t>(person));
        return trials_of(MadeUpObserver(function, 3)
                             .choices({51e-6, 52e-6, 54e-6, 58e-6, 66e-6, 82e-6}, 60, true));
      });
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
  const StoredTable& table = table_of(outcome, "mean_thresholds");
  for (const char* const column : {"mean", "geometric_mean", "geometric_mean_low"}) {
    EXPECT_TRUE(column_of(table.table, column)) << column;
  }
}

/// "22 to 95 %": of the geometric mean of the JNDs of participants who lapse or never do.
std::string coverage_of_comparisons(bool have_lapses) {
  std::vector<DrawnCount> counts = coverage_counts("comparison_thresholds", "geomean.jnd");
  std::erase_if(counts, [have_lapses](const DrawnCount& count) {
    return (count.effect > 0.0) != have_lapses;
  });
  return span_of_coverage(counts);
}

// Without lapses the fixed rate of 2 % makes the function steeper than it is.
TEST(Discrimination, ByComparisonStatesThatTheLapseRateIsAssumed) {
  EXPECT_THAT(answer_to(outcome_of_comparers(), "threshold"),
              HasSubstr("take the lapse rates of 2 % as known"));
  EXPECT_THAT(table_of(outcome_of_comparers(), "mean_thresholds").note.english(),
              HasSubstr("in " + coverage_of_comparisons(false) + " of the studies"));
  EXPECT_THAT(table_of(outcome_of_comparers(), "mean_thresholds").note.english(),
              HasSubstr("in " + coverage_of_comparisons(true) + " with lapse rates of 2 %"));
  EXPECT_THAT(answer_to(outcome_of_comparers(), "threshold"),
              HasSubstr("in " + coverage_of_comparisons(false) + " of the studies (" +
                        coverage_of_comparisons(true) + " with lapse rates"));
  const Finding* const mean =
      FoundNumbers(outcome_of_comparers().findings).find("geomean.jnd", "all");
  ASSERT_NE(mean, nullptr);
  EXPECT_EQ(mean->method.ends_with(coverage_of_comparisons(false) +
                                   " where participants never lapse, and " +
                                   coverage_of_comparisons(true) + " with lapse rates of 2 %"),
            mean->low.has_value());
  EXPECT_THAT(estimate_sentence(outcome_of_comparers()).text,
              AllOf(HasSubstr("The JNDs assume lapse rates of 2 %"),
                    HasSubstr("in " + coverage_of_comparisons(false) + " of simulated studies")));
  EXPECT_THAT(answer_to(outcome_of_performers(), "threshold"), Not(HasSubstr("lapse rates")));
  EXPECT_THAT(estimate_sentence(outcome_of_performers()).text, Not(HasSubstr("lapse rates")));
}

TEST(Discrimination, ByPerformanceHasNoPointOfSubjectiveEquality) {
  const AnalysisOutcome& outcome = outcome_of_performers();
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
  const AnalysisOutcome& outcome = outcome_of_comparers();
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
  std::vector<MadeUpChoice> choices = MadeUpObserver(kComparer, 7).choices(kAround_m, 40, false);
  for (MadeUpChoice& choice : choices) choice.chose_comparison = !choice.chose_comparison;
  const AnalysisOutcome outcome = outcome_of_choices(
      discrimination_protocol("comparison"), {.first = 1}, [&](int) { return trials_of(choices); });
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  EXPECT_NEAR(*FoundNumbers(thresholds).value("pse", "p1|all"), 54e-6, 2e-6);
  EXPECT_THAT(table_of(outcome, "psychometric").note.english(),
              HasSubstr("choices of the standard"));
}

TEST(Discrimination, OfAStandardOfZeroIsADetectionWithoutAWeberFraction) {
  const AnalysisOutcome outcome = outcome_of_choices(
      discrimination_protocol("performance", 0.0), {.number = 3}, [](int person) {
        MadeUpObserver observer(kPerformer, static_cast<unsigned>(person));
        observer.standard_m = 0.0;
        return trials_of(observer.choices({2.5e-6, 5e-6, 10e-6, 15e-6, 25e-6}, 40, true));
      });
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
       {std::pair{"perfect|all", "below_levels"}, std::pair{"poor|all", "above_levels"}}) {
    for (const QuantityName quantity :
         std::initializer_list<QuantityName>{"jnd", "jnd.dprime1", "weber", "slope"}) {
      const Finding* const finding = found.find(quantity, key);
      ASSERT_NE(finding, nullptr) << key << quantity;
      EXPECT_FALSE(finding->value) << key << quantity;
      EXPECT_EQ(finding->word, word) << key << quantity;
    }
  }
  EXPECT_TRUE(part_of(outcome, "mean_thresholds").empty());
  EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("could not be estimated"));
  const StoredTable& table = table_of(outcome, "thresholds");
  const Table shown = shown_table(outcome, "thresholds");
  EXPECT_EQ(shown.rows[0].back(),
            Cell(words_of_status("jnd, jnd_dprime1, weber: below_levels").english()));
  EXPECT_EQ(words_of_status("jnd, jnd_dprime1: below_levels; weber: not_defined").english(),
            "just-noticeable difference (JND), JND at d′ = 1: below the presented levels; Weber "
            "fraction: not defined");
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
  const AnalysisOutcome& outcome = outcome_of_observers({.function = kPerformer});
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const Finding* const mean = FoundNumbers(means).find("mean.jnd", "all");
  ASSERT_TRUE(mean != nullptr && mean->value);
  EXPECT_FALSE(mean->low);
  EXPECT_THAT(sentence_about(outcome, "order"), HasSubstr("cannot be tested with one participant"));
  EXPECT_THAT(answer_to(outcome, "order"), HasSubstr("Not tested: "));
}

// A staircase presents each participant other levels, and few trials at each.
TEST(Discrimination, TakesLevelsWithUnequalNumbersOfTrials) {
  const auto trials_of_person = [](int person) {
    MadeUpObserver observer(kPerformer, static_cast<unsigned>(person));
    std::vector<MadeUpTrial> trials{};
    for (int step = 1; step <= 30; ++step) {
      for (const MadeUpChoice& one :
           observer.choices({kStandard_m + step * 0.8e-6}, 1 + (step + person) % 7, true)) {
        trials.push_back(discriminated(one));
      }
    }
    MadeUpTrial unanswered = trials.front();  // at a level at which there is no response
    unanswered.factors_json = json{{"amplitude_m", 90e-6}}.dump();
    unanswered.answers.clear();
    unanswered.right.clear();
    unanswered.outcome = AttemptOutcome::timed_out;
    trials.push_back(unanswered);
    return trials;
  };
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 8}, trials_of_person);
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  const Finding* const mean = FoundNumbers(means).find("mean.jnd", "all");
  ASSERT_TRUE(mean != nullptr && mean->low);
  EXPECT_EQ(mean->n, 8U);
  EXPECT_LE(*mean->low, kPerformer.inverse(0.75));
  EXPECT_GE(*mean->high, kPerformer.inverse(0.75));
  const StoredTable& levels = table_of(outcome, "psychometric");
  EXPECT_EQ(levels.table.rows.size(), 8U * 30U) << "none at the level without a response";
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
  const std::map<std::string, std::string> row = wide_rows(made).at(0);
  for (const AnalysisOutcome& outcome : outcomes) {
    const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
    const FoundNumbers found(thresholds);
    EXPECT_NEAR(std::stod(row.at(outcome.protocol + "_which_jnd")), *found.value("jnd", "p1|all"),
                1e-12);
    EXPECT_NEAR(std::stod(row.at(outcome.protocol + "_which_weber")),
                *found.value("weber", "p1|all"), 1e-9);
    if (outcome.protocol == "compared") {
      EXPECT_NEAR(std::stod(row.at("compared_which_pse")), *found.value("pse", "p1|all"), 1e-12);
    }
  }
  EXPECT_EQ(row.at("performed_which_n"), "200");
  EXPECT_FALSE(row.contains("performed_which_pse"));
  for (const auto& [column, cell] : row) EXPECT_THAT(column, Not(HasSubstr("correct")));
}

TEST(Discrimination, RemarksThatTheDirectionOfTheChoicesIsUncertain) {
  PsychometricFunction guessing = kComparer;
  guessing.gamma = guessing.lambda = 0.5;
  const AnalysisOutcome& guesses =
      outcome_of_observers({.function = guessing, .people = 2, .is_performance = false});
  const auto is_uncertain = HasSubstr("increase or decrease with the level");
  EXPECT_THAT(remarks_of(guesses), is_uncertain);
  EXPECT_THAT(remarks_of(outcome_of_comparers()), Not(is_uncertain));
  EXPECT_THAT(remarks_of(outcome_of_performers()), Not(is_uncertain));
}

TEST(Discrimination, TakesTheDirectionOfTheQuestionFromTheProtocolWhereItIsStated) {
  using AsksFor = DiscriminationQuestion::AsksFor;
  DiscriminationTask task{.is_performance = false};
  EXPECT_TRUE(counts_standard(task, -3.0)) << "from the responses";
  EXPECT_FALSE(counts_standard(task, 3.0));
  task.asks_for = AsksFor::less;
  EXPECT_TRUE(counts_standard(task, 3.0));
  task.asks_for = AsksFor::more;
  EXPECT_FALSE(counts_standard(task, -3.0));
  EXPECT_FALSE(counts_standard({.is_performance = true}, -3.0));
}

TEST(Discrimination, AlwaysEstimatesTheEffectOfTheOrder) {
  const auto outcome_with_bias = [](double bias) -> const AnalysisOutcome& {
    return outcome_of_observers(
        {.function = kComparer, .people = 8, .is_performance = false, .bias_to_first = bias});
  };
  const AnalysisOutcome& biased = outcome_with_bias(0.2);
  const std::vector<Finding> order = part_of(biased, "order");
  const Finding* const mean = FoundNumbers(order).find("order.difference");
  ASSERT_TRUE(mean != nullptr && mean->value);
  EXPECT_GT(*mean->low, 0.0);
  EXPECT_THAT(sentence_about(biased, "order"),
              HasSubstr("The comparison was chosen significantly more often as surface A than as "
                        "surface B: Wilcoxon signed-rank test"));
  EXPECT_THAT(answer_to(biased, "order"), HasSubstr("percentage points"));
  EXPECT_THAT(sentence_about(outcome_with_bias(-0.2), "order"),
              HasSubstr("significantly less often"));
  EXPECT_THAT(sentence_about(outcome_of_comparers(), "order"),
              HasSubstr("not significantly different"));
}

// Eleven participants choose the comparison by a tenth more often as surface A, and one always as surface B: by ranks p = .033,
// and the mean difference is (11·0.1 − 1)/12 = 0.8 percentage points.
TEST(Discrimination, EstablishesNoOrderEffectWhereRanksAndMeanDisagree) {
  json declared = discrimination_protocol("performance");
  declared["analysis"]["family"] = {"order"};
  const AnalysisOutcome outcome = outcome_of_choices(declared, {.number = 12}, [](int person) {
    std::vector<MadeUpChoice> choices{};
    for (int i = 0; i < 20; ++i) {
      const bool first = i % 2 == 0;
      const bool chose = person == 11 ? !first : i < 10 || i == 10;
      choices.push_back({.value_m = kAbove_m[static_cast<std::size_t>(i / 4)],
                         .chose_comparison = chose,
                         .comparison_first = first});
    }
    return trials_of(choices);
  });
  EXPECT_THAT(answer_to(outcome, "order"),
              testing::StartsWith("Not established: the difference between the proportions of "
                                  "choices of the comparison, presented first minus presented "
                                  "second, was 0.8 percentage points (95 % CI ["));
  EXPECT_THAT(answer_to(outcome, "order"),
              HasSubstr("but the 95 % CI of the difference contains 0"));
  EXPECT_THAT(
      sentence_about(outcome, "order"),
      testing::StartsWith("It was not established that the comparison was chosen more often "
                          "as surface A than as surface B"));
}

// Eleven points of subjective equality half a micrometre above the standard and one 10 µm below it: by ranks p = .033, and the
// mean is below the standard, with a CI that contains it.
TEST(Discrimination, EstablishesNoPointOfSubjectiveEqualityWhereRanksAndMeanDisagree) {
  json declared = discrimination_protocol("comparison");
  declared["analysis"]["family"] = {"point_of_subjective_equality"};
  const AnalysisOutcome outcome = outcome_of_choices(declared, {.number = 12}, [](int person) {
    PsychometricFunction observer = kComparer;
    observer.alpha = person == 11 ? 40e-6 : 50.5e-6;
    std::vector<MadeUpChoice> choices{};
    constexpr int kPerLevel = 40;
    for (const double value_m : kAround_m) {
      for (int i = 0; i < kPerLevel; ++i) {
        choices.push_back({.value_m = value_m,
                           .chose_comparison = i < std::lround(kPerLevel * observer.value(value_m)),
                           .comparison_first = i % 2 == 0,
                           .is_performance = false});
      }
    }
    return trials_of(choices);
  });
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality"),
              HasSubstr("Not established: difference from the standard, "));
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality"),
              HasSubstr("but the 95 % CI of the mean contains the standard"));
  EXPECT_THAT(sentence_about(outcome, "point_of_subjective_equality"),
              testing::StartsWith("It was not established that "));
}

// Of three participants the first chooses the comparison equally often in both positions. The p of the other two is at
// least 2/2² = .5; of six it is 2/2⁶ = .031.
TEST(Discrimination, StatesWhoIsLeftOutOfASignedRankTestAndHowManyItNeeds) {
  json undeclared = discrimination_protocol("performance");
  undeclared["analysis"]["family"] = {"order"};
  const AnalysisOutcome outcome = outcome_of_choices(undeclared, {.number = 3}, [](int person) {
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
    return trials_of(choices);
  });
  EXPECT_THAT(answer_to(outcome, "order"),
              HasSubstr("the smallest attainable p is .500, so that no result could be significant "
                        "with 2 participants whose difference is not zero; at least 6 such "
                        "participants are required"));
  EXPECT_THAT(
      answer_to(outcome, "order"),
      HasSubstr("One of 3 participants has a difference of zero and is left out of the test."));
  EXPECT_THAT(table_of(outcome, "tests").note.english(),
              HasSubstr("whom n does not count: position of the comparison (1 of 3)."));
}

TEST(Discrimination, ByComparisonWithAStandardOfZeroIsNotADetection) {
  const AnalysisOutcome outcome = outcome_of_choices(
      discrimination_protocol("comparison", 0.0), {.number = 3},
      [](int) { return trials_of(MadeUpObserver(kComparer, 4).choices(kAround_m, 40, false)); });
  const std::string text = find_analysis("discrimination")->estimates(outcome).text;
  EXPECT_THAT(text, HasSubstr("JND "));
  EXPECT_THAT(text, Not(HasSubstr("detection")));
}

TEST(Discrimination, StatesWhyThereAreNoThresholds) {
  json protocol = discrimination_protocol("performance");
  protocol["blocks"]["only"].erase("vary");
  const AnalysisOutcome outcome = outcome_of_choices(protocol, {}, [](int) {
    return trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 4, true));
  });
  EXPECT_THAT(outcome.remarks.back().english(), HasSubstr("thresholds cannot be estimated"));
}

// The estimable participants are a selection: their mean is a bound, and an interval would be about others.
TEST(Discrimination, HasNoIntervalOfAMeanThatLeavesOutThresholds) {
  PsychometricFunction always = kPerformer;
  always.gamma = 1.0;
  always.lambda = 0.0;
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 4}, [&](int person) {
        MadeUpObserver observer(person == 0 ? always : kPerformer,
                                static_cast<unsigned>(person + 1));
        return trials_of(observer.choices(kAbove_m, 60, true));
      });
  EXPECT_THAT(
      answer_to(outcome, "threshold"),
      HasSubstr("Left out of 4 thresholds: 1 below the presented levels; the mean of the others is "
                "an upper bound and has no CI."));
  EXPECT_THAT(answer_to(outcome, "threshold"), HasSubstr("differences: at most "));
  EXPECT_THAT(answer_to(outcome, "threshold"), Not(HasSubstr("95 % CI")));
  EXPECT_THAT(estimate_sentence(outcome).text, HasSubstr("JND at most "));
  EXPECT_THAT(
      estimate_sentence(outcome).text,
      HasSubstr("Of the 4 JNDs, the mean does not include 1 below the presented levels; the "
                "mean of the others is an upper bound and has no CI."));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  for (const QuantityName quantity :
       std::initializer_list<QuantityName>{"mean.jnd", "geomean.jnd", "geomean.weber"}) {
    const Finding* const mean = FoundNumbers(means).find(quantity, "all");
    ASSERT_TRUE(mean != nullptr && mean->value) << quantity;
    EXPECT_FALSE(mean->low || mean->high || mean->confidence) << quantity;
  }
  EXPECT_THAT(table_of(outcome, "mean_thresholds").note.english(),
              HasSubstr("contained the true mean in 75 and 48 % of the studies"));
  EXPECT_THAT(answer_to(outcome_of_performers(), "threshold"), Not(HasSubstr("Left out")));
}

TEST(Discrimination, ShowsThresholdsWithTheirUnits) {
  const AnalysisOutcome& outcome = outcome_of_performers();
  for (const char* const name : {"thresholds", "mean_thresholds", "psychometric"}) {
    const Table shown = shown_table(outcome, name);
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
    const std::string fit = analysis.fit_for_paper(protocol, {});
    EXPECT_THAT(fit, HasSubstr("guess rate fixed at 50 % and a lapse rate between 0 and 6 %"));
    EXPECT_THAT(fit, HasSubstr("with 500 simulated observers"));
    EXPECT_THAT(paper, Not(HasSubstr("subjective equality")));
    return;
  }
  ADD_FAILURE() << "the library has no such protocol";
}

}  // namespace
}  // namespace asperity
