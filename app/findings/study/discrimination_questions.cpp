#include "app/findings/study/discrimination_questions.h"

#include <cstddef>
#include <string>

#include "app/findings/found_numbers.h"
#include "app/findings/reading_number.h"
#include "app/findings/study/cell_words.h"
#include "app/findings/study/detection_thresholds.h"
#include "app/findings/study/discrimination_tracks.h"
#include "app/findings/study/left_out_thresholds.h"
#include "app/findings/study/order_questions.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/test_sentences.h"
#include "app/findings/study/unfinished_tracks.h"

namespace asperity {

namespace {

/// "wood: 12.3 µm (95 % CI …); metal: 14 µm (…)", without a name where there is one condition. Empty without a number.
Phrase mean_thresholds_text(const DiscriminationResults& results, const std::string& quantity,
                            const std::string& fraction) {
  const FoundNumbers found(results.means);
  Phrase all{};
  for (const std::string& condition : results.conditions) {
    const Finding* const mean = found.find(quantity, condition);
    if (mean == nullptr || !mean->value) continue;
    Phrase one = quantity_with_interval(*mean);
    const Finding* const part = fraction.empty() ? nullptr : found.find(fraction, condition);
    if (part != nullptr && part->value) {
      one = phrase("Analysis", "%1, Weber fraction %2").with(one, quantity_with_interval(*part));
    }
    one = phrase("Analysis", "%1, n = %2").with(one, std::to_string(mean->n));
    if (results.conditions.size() > 1)
      one = phrase("Analysis", "%1: %2").with(words_of_condition(condition), one);
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// A signed-rank test that could not be made because at most one participant has a difference other than zero.
bool has_too_few_differences(const StudyTest& test) {
  return test.status == StudyTests::kOneDifference || test.status == StudyTests::kNoDifference;
}

const Finding* first_mean(const DiscriminationResults& results, const std::string& quantity,
                          const FoundNumbers& found) {
  for (const std::string& condition : results.conditions) {
    const Finding* const mean = found.find(quantity, condition);
    if (mean != nullptr && mean->value) return mean;
  }
  return nullptr;
}

Phrase method_of_thresholds(const DiscriminationResults& results) {
  if (const auto detection = detection_task(*results.study.task.design)) {
    return *detection == DetectionTask::yes_no
               ? phrase("Analysis",
                        "For each participant and condition, responses “yes” were modelled by "
                        "signal detection, with d′ a power function of the difference from the "
                        "standard, by maximum likelihood; the threshold is the difference with "
                        "d′ = 1 [Macmillan 2005]. CIs of geometric means are t-based on the "
                        "logarithmic scale.")
               : phrase("Analysis",
                        "For each participant and condition, responses “different” were modelled "
                        "by signal detection with the differencing rule, with d′ a power function "
                        "of the difference from the standard, by maximum likelihood; the threshold "
                        "is the difference with d′ = 1 [Macmillan 2005]. CIs of geometric means "
                        "are t-based on the logarithmic scale.");
  }
  if (!results.study.task.is_performance) {
    return phrase(
        "Analysis",
        "For each participant and condition, a cumulative normal function of the parameter "
        "was fitted by maximum likelihood, with lapse rates of 2 % in both directions; the "
        "JND is half the distance between the values at 25 % and 75 %. CIs of geometric means "
        "are t-based on the logarithmic scale.");
  }
  const Phrase method =
      results.study.task.design->is_choice_of_three()
          ? phrase("Analysis",
                   "For each participant and condition, a Weibull function of the difference from "
                   "the standard was fitted by maximum likelihood, with a guess rate of 1/3 and a "
                   "lapse rate between 0 and 6 %; the threshold is the difference at 66.7 % "
                   "correct responses. CIs of geometric means are t-based on the logarithmic "
                   "scale.")
          : phrase("Analysis",
                   "For each participant and condition, a Weibull function of the difference from "
                   "the standard was fitted by maximum likelihood, with a guess rate of 1/2 and a "
                   "lapse rate between 0 and 6 %; the threshold is the difference at 75 % correct "
                   "responses. CIs of geometric means are t-based on the logarithmic scale.");
  if (!results.study.has_levels_of_procedure) return method;
  return phrase("Analysis", "%1 %2")
      .with(method, phrase("Analysis",
                           "With an adaptive procedure, the slope was limited "
                           "to %1 to %2.")
                        .with(reading_number(kSlopesOfProcedures.least),
                              reading_number(kSlopesOfProcedures.greatest)));
}

void ask_thresholds(const DiscriminationResults& results, AnalysisOutcome& outcome) {
  const std::string parameter = words_of_parameter(results.study.task.varied.parameter);
  const bool is_detection = results.study.task.is_detection();
  const Phrase question =
      (is_detection ? phrase("Analysis", "What is the detection threshold of the %1?")
                    : phrase("Analysis", "How large is the just-noticeable difference of the %1?"))
          .with(parameter);
  const FoundNumbers found(results.means);
  const std::string quantity = "geomean." + results.quantity_of_threshold();
  const Phrase means = mean_thresholds_text(results, quantity, "geomean.weber");
  Phrase answer =
      means.empty()
          ? phrase("Analysis",
                   "It could not be estimated: no participant has a threshold within the presented "
                   "levels.")
          : (is_detection
                 ? phrase("Analysis", "Geometric mean of the detection thresholds: %1.")
                 : phrase("Analysis", "Geometric mean of the just-noticeable differences: %1."))
                .with(means);
  if (!means.empty()) answer = with_left_out_thresholds(answer, results);
  add_question(outcome, results.name_of_question("threshold").c_str(), question,
               with_unfinished_tracks(answer, results, results.quantity_of_threshold(), means),
               method_of_thresholds(results), means.empty() ? kThresholds : kMeanThresholds,
               first_mean(results, quantity, found));
}

void ask_equality(const DiscriminationResults& results, const StudyTests& tests,
                  AnalysisOutcome& outcome) {
  if (results.study.task.is_performance) return;
  const DiscriminationTask& task = results.study.task;
  const Phrase question =
      phrase("Analysis", "Is the point of subjective equality different from the standard?");
  const Phrase method =
      phrase("Analysis",
             "Wilcoxon signed-rank test of the participants' points of subjective equality against "
             "the standard.");
  const FoundNumbers found(results.means);
  const Phrase means = mean_thresholds_text(results, "mean.pse", "");
  const std::string name = results.name_of_question("point_of_subjective_equality");
  if (means.empty()) {
    const Phrase answer = phrase("Analysis",
                                 "It could not be estimated: no participant has a point of "
                                 "subjective equality within the presented levels.");
    add_question(outcome, name.c_str(), question,
                 with_unfinished_tracks(answer, results, "pse", means), method, kThresholds,
                 nullptr);
    return;
  }
  const std::string standard = stated_quantity(task.standard(), task.varied.unit);
  Phrase answer = phrase("Analysis", "Mean point of subjective equality: %1; standard: %2.")
                      .with(means, standard);
  answer = with_unfinished_tracks(answer, results, "pse", means);
  for (std::size_t condition = 0; condition < results.conditions.size(); ++condition) {
    const StudyTest* const test =
        tests.find("point_of_subjective_equality", results.about_equality(condition));
    if (test == nullptr) continue;
    const Phrase about = words_of_cell("about", test->about);
    if (has_too_few_differences(*test)) {
      answer = phrase("Analysis", "%1 Not tested, %2: %3.")
                   .with(answer, about, words_of_cell("status", test->status));
    }
    if (!test->p) continue;
    // An exploratory test is stated without a conclusion.
    answer = (!test->adjusted
                  ? phrase("Analysis",
                           "%1 Exploratory test of the difference from the standard, %2: %3.")
              : test->shows()
                  ? phrase("Analysis", "%1 Significantly different from the standard, %2: %3.")
                  : phrase("Analysis", "%1 Not significantly different from the standard, %2: %3."))
                 .with(answer, about, p_text(*test));
    answer = with_zero_differences(answer, *test);
  }
  add_question(outcome, name.c_str(), question, answer, method, kMeanThresholds,
               first_mean(results, "mean.pse", found));
}

void ask_conditions(const DiscriminationResults& results, const StudyTests& tests,
                    AnalysisOutcome& outcome) {
  if (results.conditions.size() < 2) return;
  const std::string about = results.name.empty()
                                ? results.name_of_threshold()
                                : results.name_of_threshold() + " (" + results.name + ')';
  const StudyTest* const test = tests.find("conditions", about);
  const Phrase question = phrase("Analysis", "Do the thresholds differ between the conditions?");
  const Phrase method =
      results.conditions.size() == 2
          ? phrase("Analysis", "Wilcoxon signed-rank test of the participants' thresholds.")
          : phrase("Analysis", "Friedman test of the participants' thresholds.");
  const std::string name = results.name_of_question("conditions");
  const FoundNumbers found(results.means);
  const std::string quantity = "geomean." + results.quantity_of_threshold();
  if (test != nullptr && has_too_few_differences(*test)) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis", "Not tested: %1. Geometric mean thresholds: %2.")
                     .with(words_of_cell("status", test->status),
                           mean_thresholds_text(results, quantity, "")),
                 method, kMeanThresholds, first_mean(results, quantity, found));
    return;
  }
  if (test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 results.has_participant_in_all_conditions()
                     ? phrase("Analysis",
                              "Not tested: fewer than two participants have a threshold in every "
                              "condition.")
                     : phrase("Analysis",
                              "Not tested: no participant has trials in every condition, and this "
                              "test compares conditions within participants."),
                 method, kThresholds, nullptr);
    return;
  }
  const Phrase means = mean_thresholds_text(results, quantity, "");
  const auto with_numbers = [&](const Phrase& words) { return words.with(means, p_text(*test)); };
  const Sayings sayings{with_numbers(phrase("Analysis", "Yes: geometric mean thresholds %1 (%2).")),
                        with_numbers(phrase("Analysis",
                                            "Not significantly: geometric mean thresholds %1 (%2). "
                                            "This does not show that they are equal.")),
                        with_numbers(phrase("Analysis", "Geometric mean thresholds: %1 (%2)."))};
  add_question(outcome, name.c_str(), question, said_of(*test, sayings), method, kMeanThresholds,
               first_mean(results, quantity, found));
}

}  // namespace

void ask_discrimination(const DiscriminationResults& results, const StudyTests& tests,
                        AnalysisOutcome& outcome) {
  ask_thresholds(results, outcome);
  ask_equality(results, tests, outcome);
  ask_conditions(results, tests, outcome);
  ask_order_effect(results, tests, outcome);
}

}  // namespace asperity
