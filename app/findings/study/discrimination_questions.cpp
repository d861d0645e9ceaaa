#include "app/findings/study/discrimination_questions.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/findings/found_numbers.h"
#include "app/findings/reading_number.h"
#include "app/findings/reading_table.h"
#include "app/findings/study/catch_exclusions.h"
#include "app/findings/study/cell_words.h"
#include "app/findings/study/detection_thresholds.h"
#include "app/findings/study/discrimination_methods.h"
#include "app/findings/study/left_out_thresholds.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/test_sentences.h"
#include "app/words/text_parts.h"
#include "protocols/design/protocol.h"

namespace asperity {

namespace {

/// "12.3 µm (95 % CI [10 µm, 14.6 µm])"
Phrase mean_threshold_text(const Finding& mean) {
  const std::string value = reading_quantity(*mean.value, mean.unit);
  if (!mean.low || !mean.high) return value;
  return phrase("Analysis", "%1 (95 % CI [%2, %3])")
      .with(value, reading_quantity(*mean.low, mean.unit), reading_quantity(*mean.high, mean.unit));
}

/// "wood: 12.3 µm (95 % CI …); metal: 14 µm (…)", without a name where there is one condition. Empty without a number.
Phrase mean_thresholds_text(const DiscriminationResults& results, const std::string& quantity,
                            const std::string& fraction) {
  const FoundNumbers found(results.means);
  Phrase all{};
  for (const std::string& condition : results.conditions) {
    const Finding* const mean = found.find(quantity, condition);
    if (mean == nullptr || !mean->value) continue;
    Phrase one = mean_threshold_text(*mean);
    const Finding* const part = fraction.empty() ? nullptr : found.find(fraction, condition);
    if (part != nullptr && part->value) {
      one = phrase("Analysis", "%1, Weber fraction %2").with(one, mean_threshold_text(*part));
    }
    one = phrase("Analysis", "%1, n = %2").with(one, std::to_string(mean->n));
    if (results.conditions.size() > 1)
      one = phrase("Analysis", "%1: %2").with(words_of_condition(condition), one);
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

/// Participants with an unfinished track, and the estimates of one quantity from unfinished tracks: one for each of these
/// participants and conditions.
struct UnfinishedTracks {
  std::set<std::string> participants{};
  std::set<std::string> of{};  ///< all participants
  bool is_measured = false;    ///< the task has this quantity
  std::size_t estimates = 0;
  std::size_t included = 0;  ///< estimates that exist, and are therefore included in the mean
};

UnfinishedTracks unfinished_tracks(const std::vector<Finding>& thresholds,
                                   std::string_view quantity) {
  UnfinishedTracks found{};
  const FoundNumbers numbers(thresholds);
  for (const Finding& finding : thresholds) {
    if (finding.analysis != kThresholds) continue;
    const std::string participant = finding.key.substr(0, finding.key.find('|'));
    found.of.insert(participant);
    found.is_measured = found.is_measured || finding.quantity == quantity;
    if (finding.quantity != "unfinished.tracks") continue;
    found.participants.insert(participant);
    ++found.estimates;
    if (numbers.value(quantity, finding.key)) ++found.included;
  }
  return found;
}

/// The answer, and after it how many participants have an unfinished track. `means`: empty without a mean.
Phrase with_unfinished_tracks(const Phrase& answer, const DiscriminationResults& results,
                              std::string_view quantity, const Phrase& means) {
  const UnfinishedTracks unfinished = unfinished_tracks(results.fit.thresholds, quantity);
  if (unfinished.participants.empty()) return answer;
  const Phrase stated = phrase("Analysis", "%1 Participants with an unfinished track: %2 of %3.")
                            .with(answer, std::to_string(unfinished.participants.size()),
                                  std::to_string(unfinished.of.size()));
  if (means.empty()) return stated;
  return phrase("Analysis",
                "%1 Estimates from unfinished tracks that are included in the mean, because the "
                "presented trials were sufficient: %2 of %3.")
      .with(stated, std::to_string(unfinished.included), std::to_string(unfinished.estimates));
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

std::string name_of_question(const char* name, const DiscriminationResults& results) {
  return results.name.empty() ? name : std::string(name) + ':' + results.name;
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
  add_question(outcome, name_of_question("threshold", results).c_str(), question,
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
  const std::string name = name_of_question("point_of_subjective_equality", results);
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
  const std::string name = name_of_question("conditions", results);
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

void ask_order(const DiscriminationResults& results, const StudyTests& tests,
               AnalysisOutcome& outcome) {
  const bool is_sequential = results.study.task.is_sequential;
  const Phrase question = is_sequential
                              ? phrase("Analysis", "Does the order of presentation matter?")
                              : phrase("Analysis", "Does the position of the surfaces matter?");
  const Phrase method =
      is_sequential
          ? phrase("Analysis",
                   "Wilcoxon signed-rank test of each participant's proportions of choices of the "
                   "comparison presented first and second.")
          : phrase("Analysis",
                   "Wilcoxon signed-rank test of each participant's proportions of choices of the "
                   "comparison as surface A and as surface B.");
  const std::string name = name_of_question(kOrderEffect, results);
  const FoundNumbers found(results.order);
  const Finding* const mean = found.find("order.difference", results.name);
  const StudyTest* const test = tests.find("order", results.name);
  if (mean == nullptr || !mean->value) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis",
                        "This cannot be estimated: no participant felt the comparison in both "
                        "positions."),
                 method, kOrderEffect, nullptr);
    return;
  }
  Phrase difference = phrase("Analysis", "%1 percentage points").with(reading_points(*mean->value));
  if (mean->low && mean->high) {
    difference = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                     .with(difference, reading_points(*mean->low), reading_points(*mean->high));
  }
  const Phrase estimate =
      (is_sequential
           ? phrase(
                 "Analysis",
                 "the difference between the proportions of choices of the comparison, presented "
                 "first minus presented second, was %1")
           : phrase(
                 "Analysis",
                 "the difference between the proportions of choices of the comparison, as surface "
                 "A minus as surface B, was %1"))
          .with(difference);
  if (test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis", "Not tested: %1.").with(estimate), method, kOrderEffect, mean);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(estimate, p_text(*test));
  };
  const Sayings sayings{with_numbers(phrase("Analysis", "Yes: %1 (%2).")),
                        with_numbers(phrase("Analysis", "Not significantly: %1 (%2).")),
                        with_numbers(phrase("Analysis", "On average, %1 (%2)."))};
  add_question(outcome, name.c_str(), question, said_of(*test, sayings), method, kOrderEffect,
               mean);
}

/// "A 36 % (95 % CI [30 %, 42 %]), B …"
Phrase proportions_by_place(const DiscriminationResults& results, const FoundNumbers& found) {
  Phrase all{};
  for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
    const Finding* const mean = found.find("place.proportion", key_of_place(results.name, place));
    if (mean == nullptr || !mean->value) return {};
    Phrase one =
        phrase("Analysis", "%1 %2").with(kCodesOfPlaces[place], reading_percent(*mean->value));
    if (mean->low && mean->high) {
      one = phrase("Analysis", "%1 (95 % CI [%2, %3])")
                .with(one, reading_percent(*mean->low), reading_percent(*mean->high));
    }
    all = all.empty() ? one : phrase("Analysis", "%1; %2").with(all, one);
  }
  return all;
}

void ask_places(const DiscriminationResults& results, const StudyTests& tests,
                AnalysisOutcome& outcome) {
  const Phrase question = results.study.task.is_sequential
                              ? phrase("Analysis", "Does the order of presentation matter?")
                              : phrase("Analysis", "Does the position of the surfaces matter?");
  const Phrase method = phrase("Analysis",
                               "Friedman test of each participant's proportions of choices of the "
                               "surfaces A, B and C, averaged over the positions of the correct "
                               "one.");
  const std::string name = name_of_question(kOrderEffect, results);
  const FoundNumbers found(results.order);
  const Phrase proportions = proportions_by_place(results, found);
  if (proportions.empty()) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis",
                        "This cannot be estimated: no participant felt the surface that is to be "
                        "chosen in every position."),
                 method, kChoicesByPlace, nullptr);
    return;
  }
  const Phrase estimate = phrase("Analysis", "mean proportions of choices: %1").with(proportions);
  const Finding* const first = found.find("place.proportion", key_of_place(results.name, 0));
  const StudyTest* const test = tests.find("order", results.name);
  if (test == nullptr || !test->p) {
    add_question(outcome, name.c_str(), question,
                 phrase("Analysis", "Not tested: %1.").with(estimate), method, kChoicesByPlace,
                 first);
    return;
  }
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(estimate, p_text(*test));
  };
  const Sayings sayings{with_numbers(phrase("Analysis", "Yes: %1 (%2).")),
                        with_numbers(phrase("Analysis", "Not significantly: %1 (%2).")),
                        with_numbers(phrase("Analysis", "On average, %1 (%2)."))};
  add_question(outcome, name.c_str(), question, said_of(*test, sayings), method, kChoicesByPlace,
               first);
}

/// "JND 12.3 µm (95 % CI …)" of a mean.
std::string mean_of_paper(const char* measure, const Finding& mean) {
  return std::string(measure) + ' ' + mean_threshold_text(mean).english();
}

/// The conditions in which the standard is 0 and responses are correct or incorrect (`DiscriminationTask::is_detection`):
/// then there is a difference at d′ = 1, or the reason why there is none.
std::set<std::string> conditions_of_detections(const std::vector<Finding>& findings) {
  std::set<std::string> of_performance{};
  std::set<std::string> of_zero{};
  for (const Finding& finding : findings) {
    if (finding.analysis != kThresholds) continue;
    if (finding.quantity == "jnd.dprime1") of_performance.insert(finding.key);
    if (finding.quantity == "standard" && finding.value == 0.0) of_zero.insert(finding.key);
  }
  std::set<std::string> conditions{};
  for (const std::string& key : of_zero) {
    if (of_performance.contains(key)) conditions.insert(key.substr(key.find('|') + 1));
  }
  return conditions;
}

/// The means of the designs in which the threshold is the difference at d′ = 1: there is none at 75 % correct.
std::set<std::string> conditions_at_unit_sensitivity(const FoundNumbers& means) {
  std::set<std::string> conditions{};
  for (const Finding* const mean : means.all("geomean.jnd.dprime1")) {
    if (means.find("geomean.jnd", mean->key) == nullptr) conditions.insert(mean->key);
  }
  return conditions;
}

/// The thresholds of these designs.
std::vector<Finding> thresholds_at_unit_sensitivity(const std::vector<Finding>& findings) {
  std::set<std::string> with_proportion{};
  for (const Finding& finding : findings) {
    if (finding.analysis == kThresholds && finding.quantity == "jnd") {
      with_proportion.insert(finding.key);
    }
  }
  std::vector<Finding> thresholds{};
  for (const Finding& finding : findings) {
    if (finding.analysis == kThresholds && finding.quantity == "jnd.dprime1" &&
        !with_proportion.contains(finding.key)) {
      thresholds.push_back(finding);
    }
  }
  return thresholds;
}

/// " No JND was estimated for one of 6 participants (responses do not depend on the level as expected)."
std::string missing_sentences(const std::vector<Finding>& findings, const std::string& quantity,
                              const std::string& measure) {
  struct Missing {
    std::size_t participants = 0;
    std::size_t of = 0;
    std::map<std::string, std::size_t> reasons{};
  };
  std::map<std::string, Missing> conditions{};
  for (const Finding& finding : findings) {
    if (finding.analysis != kThresholds || finding.quantity != quantity) continue;
    const std::size_t bar = finding.key.find('|');
    Missing& missing = conditions[bar == std::string::npos ? "all" : finding.key.substr(bar + 1)];
    ++missing.of;
    if (finding.value) continue;
    ++missing.participants;
    ++missing.reasons[words_of_cell("status", finding.word).english()];
  }
  std::string text{};
  for (const auto& [condition, missing] : conditions) {
    if (missing.participants == 0) continue;
    std::string reasons{};
    for (const auto& [reason, count] : missing.reasons) {
      reasons += (reasons.empty() ? "" : "; ") +
                 (missing.reasons.size() == 1 ? reason : count_in_words(count) + ": " + reason);
    }
    text += " No " + measure + " was estimated for " +
            (missing.of == 1 ? "the only participant"
                             : count_in_words(missing.participants) + " of " +
                                   reading_count(missing.of) + " participants") +
            (condition == "all" ? "" : " in the condition " + words_of_condition(condition)) +
            " (" + reasons + ").";
  }
  return text;
}

/// "the JND was estimated from the presented trials and is included in the means"
std::string included_text(const UnfinishedTracks& unfinished, const std::string& measure) {
  if (unfinished.included == 0) {
    return "no " + measure + " could be estimated from the presented trials";
  }
  if (unfinished.included < unfinished.estimates) {
    return "the means include " + count_in_words(unfinished.included) + " of " +
           reading_count(unfinished.estimates) + ' ' + measure +
           "s of these tracks, for which the presented trials were sufficient";
  }
  return "the " + measure + (unfinished.estimates == 1 ? " was" : "s were") +
         " estimated from the presented trials and " + (unfinished.estimates == 1 ? "is" : "are") +
         " included in the means";
}

/// " Tracks of one of 3 participants were unfinished; the threshold was estimated from the presented trials and is included in
/// the means." Of a task with PSE and JND, both are stated.
std::string unfinished_sentence(const std::vector<Finding>& findings) {
  const UnfinishedTracks of_jnd = unfinished_tracks(findings, "jnd");
  if (of_jnd.participants.empty()) return {};
  const UnfinishedTracks of_pse = unfinished_tracks(findings, "pse");
  const std::string how = of_pse.is_measured
                              ? included_text(of_pse, "PSE") + "; " + included_text(of_jnd, "JND")
                              : included_text(of_jnd, "threshold");
  const std::string participants = of_jnd.of.size() == 1
                                       ? "the only participant"
                                       : count_in_words(of_jnd.participants.size()) + " of " +
                                             reading_count(of_jnd.of.size()) + " participants";
  return " Tracks of " + participants + " were unfinished; " + how + '.';
}

/// The responses in catch trials of one type.
struct CaughtResponses {
  double correct = 0.0;
  double all = 0.0;
};

std::string text_or_empty(const Cell& cell) {
  const auto* const text = std::get_if<std::string>(&cell);
  return text == nullptr ? std::string() : *text;
}

/// By participant, over the blocks.
std::map<std::string, CaughtResponses> caught_responses(const Table& table,
                                                        const std::string& type) {
  std::map<std::string, CaughtResponses> caught{};
  const auto participant = column_of(table, "participant");
  const auto type_of = column_of(table, "type");  // absent where all are easy
  const auto right = column_of(table, "right");
  const auto of = column_of(table, "of");
  if (!participant || !right || !of) return caught;
  for (const std::vector<Cell>& row : table.rows) {
    const std::string own =
        type_of ? text_or_empty(row[*type_of]) : std::string(text_of(CatchType::easy));
    if (own != type) continue;
    CaughtResponses& one = caught[text_or_empty(row[*participant])];
    one.correct += number_of(row[*right]).value_or(0.0);
    one.all += number_of(row[*of]).value_or(0.0);
  }
  return caught;
}

/// " (75 % to 100 % for single participants)"; empty where they have the same percentage.
std::string range_over_participants(const std::map<std::string, CaughtResponses>& caught,
                                    bool of_errors) {
  double least = 1.0;
  double most = 0.0;
  for (const auto& [participant, one] : caught) {
    const double correct = one.correct / std::max(one.all, 1.0);
    least = std::min(least, of_errors ? 1.0 - correct : correct);
    most = std::max(most, of_errors ? 1.0 - correct : correct);
  }
  return least >= most ? std::string()
                       : " (" + reading_percent(least) + " to " + reading_percent(most) +
                             " for single participants)";
}

std::string catch_sentence_of(CatchType type, const Table& table) {
  const std::map<std::string, CaughtResponses> caught = caught_responses(table, text_of(type));
  CaughtResponses sum{};
  for (const auto& [participant, one] : caught) {
    sum.correct += one.correct;
    sum.all += one.all;
  }
  if (sum.all == 0.0) return {};
  const auto whole = [](double number) { return reading_count(static_cast<std::size_t>(number)); };
  if (type == CatchType::easy) {
    const std::string where =
        column_of(table, "type") ? " in easy catch trials" : " in catch trials";
    if (sum.correct == sum.all && sum.all > 1.0) {
      return " All " + whole(sum.all) + " responses" + where + " were correct.";
    }
    return " Of " + whole(sum.all) + (sum.all == 1.0 ? " response" : " responses") + where + ", " +
           whole(sum.correct) + (sum.correct == 1.0 ? " was correct" : " were correct") +
           range_over_participants(caught, false) + '.';
  }
  const std::string trials =
      " In " + whole(sum.all) + (sum.all == 1.0 ? " catch trial " : " catch trials ") +
      (type == CatchType::no_signal ? "without a signal, " : "with an identical pair, ");
  const double others = sum.all - sum.correct;
  if (others == 0.0) return trials + "every response was “cannot tell”.";
  return trials + (others == 1.0 ? "there was " : "there were ") + whole(others) +
         (others == 1.0 ? " response" : " responses") +
         " other than “cannot tell” (a missed deadline would count as one)" +
         range_over_participants(caught, true) + '.';
}

/// " Of 24 responses in catch trials, 23 were correct (75 % to 100 % for single participants)."; a sentence per type.
std::string catch_trials_sentence(const AnalysisOutcome& outcome) {
  std::string text{};
  for (const NamedTable& table : outcome.tables) {
    if (table.name != kCatchTrials) continue;
    for (const CatchType type :
         {CatchType::easy, CatchType::no_signal, CatchType::identical_pair}) {
      text += catch_sentence_of(type, table.table);
    }
  }
  return text;
}

}  // namespace

void ask_discrimination(const DiscriminationResults& results, const StudyTests& tests,
                        AnalysisOutcome& outcome) {
  ask_thresholds(results, outcome);
  ask_equality(results, tests, outcome);
  ask_conditions(results, tests, outcome);
  const DiscriminationDesign& design = *results.study.task.design;
  if (design.is_choice_of_three()) {
    ask_places(results, tests, outcome);
  } else if (!design.has_noise()) {
    ask_order(results, tests, outcome);
  }
}

EstimateSentence thresholds_sentence(const AnalysisOutcome& outcome) {
  std::vector<Finding> means{};
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis == kMeanThresholds && finding.value) means.push_back(finding);
  }
  const std::set<std::string> detections = conditions_of_detections(outcome.findings);
  std::string text{};
  const FoundNumbers found(means);
  std::vector<std::string> conditions{};
  const std::set<std::string> at_unit = conditions_at_unit_sensitivity(found);
  for (const char* const quantity :
       {"mean.pse", "geomean.jnd", "geomean.jnd.dprime1", "geomean.jnd.posterior"}) {
    for (const Finding* const mean : found.all(quantity)) {
      if (std::find(conditions.begin(), conditions.end(), mean->key) == conditions.end()) {
        conditions.push_back(mean->key);
      }
    }
  }
  for (const std::string& condition : conditions) {
    std::vector<const Finding*> shown{};
    std::vector<std::string> parts{};
    const auto add = [&](const char* quantity, const char* measure) {
      const Finding* const mean = found.find(quantity, condition);
      if (mean == nullptr) return;
      shown.push_back(mean);
      parts.push_back(mean_of_paper(measure, *mean));
    };
    add("mean.pse", "PSE");
    const char* const measure = detections.contains(condition) ? "detection threshold" : "JND";
    if (at_unit.contains(condition)) {
      add("geomean.jnd.dprime1",
          detections.contains(condition) ? "detection threshold at d′ = 1" : "JND at d′ = 1");
    } else {
      add("geomean.jnd", measure);
    }
    add("geomean.jnd.posterior",
        detections.contains(condition) ? "posterior detection threshold" : "posterior JND");
    add("geomean.weber", "Weber fraction");
    const bool is_same_n = std::all_of(shown.begin(), shown.end(), [&shown](const Finding* mean) {
      return mean->n == shown.front()->n;
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!is_same_n) parts[i] += " for " + reading_count(shown[i]->n) + " participants";
    }
    text += text.empty() ? "Mean thresholds were: " : "; ";
    if (condition != "all") text += words_of_condition(condition) + ", ";
    text += comma_separated(parts);
    if (is_same_n) text += ", N = " + reading_count(shown.front()->n);
  }
  if (!text.empty()) text += '.';
  const std::string of_difference = detections.empty() ? "JND" : "threshold";
  const std::vector<Finding> at_unit_sensitivity = thresholds_at_unit_sensitivity(outcome.findings);
  text += missing_sentences(outcome.findings, "pse", "PSE") +
          missing_sentences(outcome.findings, "jnd", of_difference) +
          missing_sentences(at_unit_sensitivity, "jnd.dprime1", of_difference) +
          bias_sentence(outcome.findings, "jnd", of_difference) +
          bias_sentence(at_unit_sensitivity, "jnd.dprime1", of_difference) +
          unfinished_sentence(outcome.findings) + sensitivity_sentences(outcome) +
          catch_trials_sentence(outcome) + exclusions_sentence(outcome);
  if (text.starts_with(' ')) text.erase(0, 1);
  return {.text = text};
}

}  // namespace asperity
