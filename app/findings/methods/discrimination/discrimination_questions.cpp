// Questions on thresholds, point of subjective equality and conditions; that on the order is in order_questions.cpp.

#include "app/findings/methods/discrimination/discrimination_questions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "app/findings/methods/discrimination/order_questions.h"
#include "app/findings/methods/discrimination/thresholds/detection_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/unfinished_tracks.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

namespace {

/// "wood: 12.3 µm (95 % CI …); metal: at most 14 µm", without a name where there is one condition. Empty without a number.
Phrase mean_thresholds_text(const DiscriminationResults& results, QuantityName quantity,
                            QuantityName fraction) {
  const FoundNumbers found(results.means);
  Phrase all{};
  for (const std::string& condition : results.conditions) {
    const Finding* const mean = found.find(quantity, condition);
    if (mean == nullptr || !mean->value) continue;
    const auto with_bound = [&results](const Finding& of) {
      return mean_with_bound(of, left_out_of_mean(results.fit.thresholds, of));
    };
    Phrase one = with_bound(*mean);
    const Finding* const part = fraction.empty() ? nullptr : found.find(fraction, condition);
    if (part != nullptr && part->value) {
      one = phrase("Analysis", "%1, Weber fraction %2").with(one, with_bound(*part));
    }
    one = phrase("Analysis", "%1, n = %2").with(one, std::to_string(mean->n));
    if (results.conditions.size() > 1)
      one = phrase("Analysis", "%1: %2").with(words_of_condition(condition), one);
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// Whether the mean of a condition is neither an upper nor a lower bound, and therefore not reported.
bool has_no_bound(const DiscriminationResults& results, QuantityName quantity) {
  return std::any_of(results.means.begin(), results.means.end(),
                     [&](const Finding& mean) { return is(mean, quantity) && !mean.value; });
}

/// "wood: 12.3 µm; metal: 14 µm; ratio metal / wood: 1.14 (95 % CI …)", over the participants with all conditions.
Phrase compared_thresholds_text(const DiscriminationResults& results) {
  const FoundNumbers found(results.compared);
  Phrase all{};
  const auto add = [&all](const Phrase& one) {
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  };
  for (const std::string& condition : results.conditions) {
    const Finding* const mean = found.find(results.mean_of_threshold(), condition);
    if (mean == nullptr) continue;
    add(phrase("Analysis", "%1: %2")
            .with(words_of_condition(condition), quantity_with_interval(*mean)));
  }
  for (const Finding* const ratio : found.all(results.ratio_of_threshold())) {
    add(phrase("Analysis", "ratio %1 / %2: %3")
            .with(words_of_condition(results.conditions[1]),
                  words_of_condition(results.conditions[0]), quantity_with_interval(*ratio)));
  }
  return all;
}

/// The answer, and after it the number of participants without a threshold in every condition, whom the comparison leaves
/// out.
Phrase with_left_out_participants(const Phrase& answer, const DiscriminationResults& results,
                                  std::size_t complete) {
  std::set<std::uint32_t> people{};
  for (const auto& function : results.functions) people.insert(function.person);
  if (people.size() == complete) return answer;
  const Phrase left_out =
      phrase("Analysis",
             "%1 Left out: %2 of %3 participants, who do not have a threshold within the presented "
             "levels in every condition; the comparison does not describe them.")
          .with(answer, std::to_string(people.size() - complete), std::to_string(people.size()));
  const bool has_ratio_without_interval = results.conditions.size() == 2 && complete > 0 &&
                                          complete < results.participants_in_all_conditions();
  if (!has_ratio_without_interval) return left_out;
  return phrase("Analysis",
                "%1 The ratio therefore has no CI, and may differ from that of all participants.")
      .with(left_out);
}

/// The answer, and after it that its thresholds depend on a lapse rate that is fixed, where it is.
Phrase with_fixed_lapses(const Phrase& answer, const DiscriminationResults& results) {
  if (detection_task(*results.study.task.design)) {
    return phrase("Analysis",
                  "%1 The thresholds and their CIs take the lapse rates of 2 % as known.")
        .with(answer);
  }
  if (results.study.task.is_performance) return answer;
  return phrase("Analysis",
                "%1 The JNDs and their CIs take the lapse rates of 2 % as known: for participants "
                "who never lapse, simulated JNDs were too small by 11 to 13 %, and the CI of the "
                "mean contained the true JND in 22 to 95 % of the studies (91 to 96 % with lapse "
                "rates of 2 %).")
      .with(answer);
}

/// A signed-rank test that could not be made because at most one participant has a difference other than zero.
bool has_too_few_differences(const StudyTest& test) {
  return test.status == StudyTests::kOneDifference || test.status == StudyTests::kNoDifference;
}

const Finding* first_mean(const DiscriminationResults& results, QuantityName quantity,
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
                        .with(display_number(kSlopesOfProcedures.least),
                              display_number(kSlopesOfProcedures.greatest)));
}

void ask_thresholds(const DiscriminationResults& results, AnalysisOutcome& outcome) {
  const std::string parameter = words_of_parameter(results.study.task.varied.parameter);
  const bool is_detection = results.study.task.is_detection();
  const Phrase question =
      (is_detection ? phrase("Analysis", "What is the detection threshold of the %1?")
                    : phrase("Analysis", "How large is the just-noticeable difference of the %1?"))
          .with(parameter);
  const FoundNumbers found(results.means);
  const QuantityName quantity = results.mean_of_threshold();
  const Phrase means = mean_thresholds_text(results, quantity, "geomean.weber");
  Phrase answer =
      means.empty() && has_no_bound(results, quantity)
          ? phrase("Analysis", "No mean threshold is reported.")
      : means.empty()
          ? phrase("Analysis",
                   "It could not be estimated: no participant has a threshold within the presented "
                   "levels.")
          : (is_detection
                 ? phrase("Analysis", "Geometric mean of the detection thresholds: %1.")
                 : phrase("Analysis", "Geometric mean of the just-noticeable differences: %1."))
                .with(means);
  answer = with_left_out_thresholds(answer, results, results.quantity_of_threshold());
  if (!means.empty()) answer = with_fixed_lapses(answer, results);
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
    const Phrase answer = with_left_out_thresholds(
        has_no_bound(results, "mean.pse")
            ? phrase("Analysis", "No mean point of subjective equality is reported.")
            : phrase("Analysis",
                     "It could not be estimated: no participant has a point of subjective equality "
                     "within the presented levels."),
        results, "pse");
    add_question(outcome, name.c_str(), question,
                 with_unfinished_tracks(answer, results, "pse", means), method, kThresholds,
                 nullptr);
    return;
  }
  const std::string standard = stated_quantity(task.standard(), task.varied.unit);
  Phrase answer = phrase("Analysis", "Mean point of subjective equality: %1; standard: %2.")
                      .with(means, standard);
  answer = with_left_out_thresholds(answer, results, "pse");
  answer = with_unfinished_tracks(answer, results, "pse", means);
  for (std::size_t condition = 0; condition < results.conditions.size(); ++condition) {
    const StudyTest* const test =
        tests.find("point_of_subjective_equality", results.about_equality(condition));
    if (test == nullptr) continue;
    const Phrase about = words_of_subject(test->about);
    if (has_too_few_differences(*test)) {
      answer = phrase("Analysis", "%1 Not tested, %2: %3.")
                   .with(answer, about, words_of_status(test->status));
    }
    if (!test->p) continue;
    const TestStatements statements = statements_of(
        *test,
        {.numbers =
             phrase("Analysis", "difference from the standard, %1: %2.").with(about, p_text(*test)),
         .significant = phrase("Analysis", "Significant %1"),
         .not_significant = phrase("Analysis", "No significant %1"),
         .exploratory = phrase("Analysis", "Test of the %1")});
    answer = phrase("Analysis", "%1 %2").with(answer, said_of(*test, statements));
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
          ? phrase(
                "Analysis",
                "Wilcoxon signed-rank test of the thresholds of the participants with a threshold "
                "in both conditions. Ratio: geometric mean of the same participants' ratios, with "
                "a t-based CI on the logarithmic scale.")
          : phrase("Analysis",
                   "Friedman test of the thresholds of the participants with a threshold in every "
                   "condition.");
  const std::string name = results.name_of_question("conditions");
  const FoundNumbers found(results.compared);
  const std::vector<const Finding*> ratios = found.all(results.ratio_of_threshold());
  const Finding* const mean = first_mean(results, results.mean_of_threshold(), found);
  const Finding* const shown = ratios.empty() ? mean : ratios.front();
  const std::size_t complete = mean == nullptr ? 0 : mean->n;
  if (test != nullptr && has_too_few_differences(*test)) {
    add_question(outcome, name.c_str(), question,
                 with_left_out_participants(
                     phrase("Analysis", "Not tested: %1. Geometric mean thresholds: %2.")
                         .with(words_of_status(test->status), compared_thresholds_text(results)),
                     results, complete),
                 method, kMeanThresholds, shown);
    return;
  }
  if (test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 results.participants_in_all_conditions() > 0
                     ? phrase("Analysis",
                              "Not tested: fewer than two participants have a threshold in every "
                              "condition.")
                     : phrase("Analysis",
                              "Not tested: no participant has trials in every condition, and this "
                              "test compares conditions within participants."),
                 method, kThresholds, nullptr);
    return;
  }
  const Phrase means = compared_thresholds_text(results);
  const TestStatements statements =
      statements_of(
          *test,
          {.numbers = phrase("Analysis", "geometric mean thresholds of %1 participants: %2 (%3).")
                          .with(std::to_string(complete), means, p_text(*test)),
           .exploratory = {},
           .compares = true})
          .with([&](const Phrase& answer) {
            return with_left_out_participants(answer, results, complete);
          });
  add_question(outcome, name.c_str(), question, said_of(*test, statements), method, kMeanThresholds,
               shown);
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
