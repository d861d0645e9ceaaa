// The tests of a discrimination: order, conditions, and the point of subjective equality.

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/catch/catch_exclusions.h"
#include "app/findings/methods/discrimination/choice_model.h"
#include "app/findings/methods/discrimination/discrimination_analysis.h"
#include "app/findings/methods/discrimination/discrimination_questions.h"
#include "app/findings/methods/discrimination/discrimination_tables.h"
#include "app/findings/methods/discrimination/sensitivity/choice_sensitivity.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kFirst = "comparison_first";
constexpr const char* kSecond = "comparison_second";
constexpr QuantityName kWilcoxonP = "wilcoxon.exact.p.two";

/// The keys of findings of a task begin with its name where there are several.
std::vector<Finding> scores_compared(const std::string& analysis, ScoreRows scores,
                                     const std::vector<std::string>& items) {
  TidyInput input = std::move(scores).take("subject", "item", "the thresholds");
  input.options.set("items", items);
  return analysis_of(analysis.c_str(), "rating", std::move(input));
}

/// The same findings without the means of the items, which other tables have. Of a pair only the signed-rank test:
/// one test of a pair is reported, and with two items Friedman's test is equivalent to a sign test.
void keep_tests(const std::vector<Finding>& findings, bool is_of_pair, AnalysisOutcome& outcome) {
  keep_findings(findings, outcome, [is_of_pair](const Finding& finding) {
    return finding.quantity.starts_with("wilcoxon.") ||
           (!is_of_pair && (finding.quantity.starts_with("friedman.") ||
                            finding.quantity.starts_with("kendall.")));
  });
}

std::string with_task(const std::string& what, const std::string& task) {
  return task.empty() ? what : what + " (" + task + ')';
}

/// The signed-rank test drops participants whose two values are equal. `compared`: those with both.
void drop_ties(std::size_t compared, const FindingKey& key, const FoundNumbers& found,
               StudyTests& tests) {
  const double tested = found.value("wilcoxon.n", key).value_or(static_cast<double>(compared));
  tests.drop_ties(compared - std::min(compared, static_cast<std::size_t>(tested)));
}

/// The scores of the positions; empty where fewer than two participants can be compared, which the tests state.
std::vector<Finding> orders_compared(const GatheredAnswers& gathered,
                                     const DiscriminationResults& results, ScoreRows scores,
                                     std::size_t compared, const std::vector<std::string>& items,
                                     StudyTests& tests, AnalysisOutcome& outcome) {
  keep_findings(results.order, outcome);
  if (compared < 2) {
    tests.add_untested(
        "order", results.name,
        gathered.people.size() == 1 ? StudyTests::kOneParticipantAlone : "one_order");
    return {};
  }
  const std::string analysis = results.name.empty() ? "order_test" : "order_test:" + results.name;
  std::vector<Finding> findings = scores_compared(analysis, std::move(scores), items);
  keep_tests(findings, items.size() == 2, outcome);
  return findings;
}

/// The counterpart of `test_order` for a choice of three surfaces.
void test_places(const GatheredAnswers& gathered, const DiscriminationResults& results,
                 StudyTests& tests, AnalysisOutcome& outcome) {
  ScoreRows scores(gathered);
  std::size_t complete = 0;
  for (const PlacesOfPerson& own : results.places) {
    if (!own.has_all()) continue;
    ++complete;
    for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
      scores.add(own.person, kCodesOfPlaces[place], own.proportion_of(place));
    }
  }
  const std::vector<Finding> findings =
      orders_compared(gathered, results, std::move(scores), complete,
                      {kCodesOfPlaces.begin(), kCodesOfPlaces.end()}, tests, outcome);
  if (findings.empty()) return;
  tests.add("order", results.name, FoundNumbers(findings), "friedman.p");
}

void test_order_of_two(const GatheredAnswers& gathered, const DiscriminationResults& results,
                       StudyTests& tests, AnalysisOutcome& outcome) {
  ScoreRows scores(gathered);
  std::size_t with_both = 0;
  for (const OrderOfPerson& own : results.orders) {
    if (!own.has_both()) continue;
    ++with_both;
    scores.add(own.person, kFirst, own.proportion_of(own.first));
    scores.add(own.person, kSecond, own.proportion_of(own.second));
  }
  const std::vector<Finding> findings = orders_compared(
      gathered, results, std::move(scores), with_both, {kFirst, kSecond}, tests, outcome);
  if (findings.empty()) return;
  const FoundNumbers found(findings);
  tests.add("order", results.name, found, kWilcoxonP, {kFirst, kSecond});
  const FoundNumbers order(results.order);
  const Finding* const difference = order.find("order.difference", results.name);
  tests.state_effect(difference, "difference of proportions");
  tests.state_difference(difference);
  drop_ties(with_both, {kFirst, kSecond}, found, tests);
}

/// Of a design in which a surface is chosen.
void test_order(const GatheredAnswers& gathered, const DiscriminationResults& results,
                StudyTests& tests, AnalysisOutcome& outcome) {
  const DiscriminationDesign& design = *results.study.task.design;
  if (design.is_choice_of_three()) {
    test_places(gathered, results, tests, outcome);
  } else if (!design.has_noise()) {
    test_order_of_two(gathered, results, tests, outcome);
  }
}

/// The participants' numbers of one threshold by condition, as scores.
struct ConditionScores {
  ScoreRows rows;
  std::size_t complete = 0;  ///< participants with a number in every condition
};

ConditionScores scores_of_conditions(const GatheredAnswers& gathered,
                                     const DiscriminationResults& results, QuantityName quantity) {
  const FoundNumbers found(results.fit.thresholds);
  ConditionScores scores{.rows = ScoreRows(gathered)};
  std::vector<std::size_t> numbers(gathered.people.size());
  for (const auto& function : results.functions) {
    const auto value = found.value(quantity, function.data.key);
    if (!value) continue;
    scores.rows.add(function.person, results.conditions[function.condition], *value);
    ++numbers[function.person];
  }
  scores.complete = static_cast<std::size_t>(
      std::count(numbers.begin(), numbers.end(), results.conditions.size()));
  return scores;
}

void test_conditions(const GatheredAnswers& gathered, const DiscriminationResults& results,
                     StudyTests& tests, AnalysisOutcome& outcome) {
  if (results.conditions.size() < 2) return;
  std::vector<std::pair<QuantityName, std::string>> measures{
      {results.quantity_of_threshold(), results.name_of_threshold()}};
  if (!results.study.task.is_performance) measures.emplace_back(QuantityName("pse"), "PSE");
  for (const auto& [quantity, shown] : measures) {
    const std::string about = with_task(shown, results.name);
    ConditionScores scores = scores_of_conditions(gathered, results, quantity);
    if (scores.complete < 2) {
      tests.add_untested("conditions", about,
                         gathered.people.size() == 1 ? StudyTests::kOneParticipantAlone
                         : results.participants_in_all_conditions() > 0
                             ? "no_thresholds"
                             : "conditions_between_participants");
      continue;
    }
    std::string analysis = "conditions_" + std::string(quantity);
    if (!results.name.empty()) analysis += ':' + results.name;
    const std::vector<Finding> findings =
        scores_compared(analysis, std::move(scores.rows), results.conditions);
    const bool is_pair = results.conditions.size() == 2;
    keep_tests(findings, is_pair, outcome);
    const FoundNumbers found(findings);
    if (is_pair) {
      tests.add("conditions", about, found, kWilcoxonP,
                {results.conditions[0], results.conditions[1]});
      if (quantity == results.quantity_of_threshold()) {
        const FoundNumbers compared(results.compared);
        const Finding* const ratio = compared.find(results.ratio_of_threshold(),
                                                   {results.conditions[1], results.conditions[0]});
        tests.state_effect(ratio, "ratio");
        tests.state_ratio(ratio);
      }
    } else {
      tests.add("conditions", about, found, "friedman.p");
    }
    tests.leave_out(gathered.people.size() - scores.complete,
                    phrase("Analysis",
                           "Participants without an estimate of the %1 in every condition are "
                           "left out of the test of the conditions")
                        .with(shown));
    if (is_pair) {
      drop_ties(scores.complete, {results.conditions[0], results.conditions[1]}, found, tests);
    }
  }
}

void test_equality(const GatheredAnswers& gathered, const DiscriminationResults& results,
                   StudyTests& tests, AnalysisOutcome& outcome) {
  const FoundNumbers found(results.fit.thresholds);
  const FoundNumbers means(results.means);
  for (std::size_t condition = 0; condition < results.conditions.size(); ++condition) {
    const std::string about = results.about_equality(condition);
    ScoreRows scores(gathered);
    std::size_t of_condition = 0;
    std::size_t estimated = 0;
    for (const auto& function : results.functions) {
      if (function.condition != condition) continue;
      ++of_condition;
      const auto pse = found.value("pse", function.data.key);
      if (!pse) continue;
      ++estimated;
      scores.add(function.person, "pse", *pse);
      scores.add(function.person, "standard", results.study.task.standard());
    }
    if (estimated < 2) {
      tests.add_untested(
          "point_of_subjective_equality", about,
          gathered.people.size() == 1 ? StudyTests::kOneParticipantAlone : "no_thresholds");
      continue;
    }
    const std::vector<Finding> findings = scores_compared(
        "equality:" + results.conditions[condition], std::move(scores), {"pse", "standard"});
    keep_tests(findings, true, outcome);
    const FoundNumbers tested(findings);
    tests.add("point_of_subjective_equality", about, tested, kWilcoxonP, {"pse", "standard"});
    const Finding* const mean = means.find("mean.pse", results.conditions[condition]);
    if (mean != nullptr && mean->value) {
      const double standard = results.study.task.standard();
      tests.state_direction(*mean->value - standard);
      tests.state_compared(mean, standard,
                           phrase("Analysis", "the 95 % CI of the mean contains the standard"));
    }
    tests.leave_out(
        of_condition - estimated,
        phrase("Analysis",
               "Participants without a point of subjective equality within the presented "
               "levels are left out of its test"));
    drop_ties(estimated, {"pse", "standard"}, tested, tests);
  }
}

/// The thresholds, or of a task with a single level d′, of each condition that the groups share: a participant is in one group,
/// and its level is no condition.
void add_to_groups(const GatheredAnswers& gathered, const DiscriminationResults& results,
                   GroupComparisons& groups) {
  if (!groups.has_pairs()) return;
  const auto sensitivities = sensitivities_at_only_level(gathered, results);
  const bool has_thresholds = sensitivities.empty();
  std::map<std::string, GroupMeasure> measures{};
  const auto values_in = [&](std::size_t condition) -> auto& {
    return measures[results.study.conditions_in_group[condition]].values;
  };
  for (const auto& [of, sensitivity] : sensitivities) values_in(of.first)[of.second] = sensitivity;
  if (has_thresholds) {
    const FoundNumbers found(results.fit.thresholds);
    for (const auto& function : results.functions) {
      values_in(function.condition)[function.person] =
          found.value(results.quantity_of_threshold(), function.data.key);
    }
  }
  for (auto& [condition, measure] : measures) {
    measure.name = results.name;
    if (!condition.empty()) measure.name += (measure.name.empty() ? "" : ", ") + condition;
    measure.words = has_thresholds ? phrase("Analysis", "the geometric mean of the thresholds")
                                   : phrase("Analysis", "the mean d′");
    if (!measure.name.empty()) {
      measure.words =
          phrase("Analysis", "%1 (%2)").with(measure.words, words_of_condition(measure.name));
    }
    measure.is_ratio = has_thresholds;
    if (has_thresholds && !results.study.task.varied.unit.empty()) {
      measure.unit = results.study.task.varied.unit;
    }
    groups.add(measure);
  }
}

void remark_on_left_out(const std::vector<DiscriminationStudy>& studies, AnalysisOutcome& outcome) {
  std::size_t left_out = 0;
  for (const DiscriminationStudy& study : studies) left_out += study.left_out;
  if (left_out == 0) return;
  outcome.remarks.push_back(phrase("Analysis",
                                   "Responses to trials without the surfaces of the design or "
                                   "without a level, which are left "
                                   "out: %1.")
                                .with(std::to_string(left_out)));
}

void remark_on_unsure(const DiscriminationResults& results, AnalysisOutcome& outcome) {
  const auto& trials = results.study.trials;
  const auto unsure = std::count_if(trials.begin(), trials.end(),
                                    [](const auto& trial) { return trial.is_unsure; });
  if (unsure == 0) return;
  const Phrase remark =
      phrase("Analysis",
             "%1 of %2 responses are “cannot tell”. Each counts as the mean of a guess in "
             "psychometric functions and in the order effect. The logistic mixed model of choices "
             "does not contain them, and d′ is not computed, because its counts need a choice in "
             "every trial.")
          .with(std::to_string(unsure), std::to_string(trials.size()));
  outcome.remarks.push_back(
      results.name.empty() ? remark : phrase("Analysis", "%1: %2").with(results.name, remark));
}

void remark_on_direction(const DiscriminationResults& results, AnalysisOutcome& outcome) {
  if (!results.study.is_direction_uncertain) return;
  const Phrase remark = phrase(
      "Analysis",
      "It is uncertain whether choices of the comparison increase or decrease with the level: "
      "their covariance with the level is not significantly different from 0 (α = .05). The "
      "psychometric functions may count the choices of the other surface; collect more responses.");
  outcome.remarks.push_back(
      results.name.empty() ? remark : phrase("Analysis", "%1: %2").with(results.name, remark));
}

/// Whether no response is a choice between surfaces, whose order could matter.
bool are_of_detection(const std::vector<DiscriminationStudy>& studies) {
  return std::all_of(studies.begin(), studies.end(),
                     [](const auto& each) { return each.task.design->has_noise(); });
}

bool have_conditions(const std::vector<DiscriminationStudy>& studies) {
  return std::any_of(studies.begin(), studies.end(),
                     [](const auto& each) { return each.conditions.size() > 1; });
}

void set_default_of_designs(const std::vector<DiscriminationStudy>& studies, StudyTests& tests) {
  if (!are_of_detection(studies)) return;
  tests.set_default_family(have_conditions(studies) ? std::vector<std::string>{"conditions"}
                                                    : std::vector<std::string>{});
}

/// Tests of the family that these designs do not have.
void add_tests_without_design(const std::vector<DiscriminationStudy>& studies, StudyTests& tests) {
  if (are_of_detection(studies) && tests.is_in_family("order") && tests.find("order") == nullptr) {
    tests.add_untested("order", "", "no_choice_of_surface");
  }
  const bool has_comparison = std::any_of(
      studies.begin(), studies.end(), [](const auto& each) { return !each.task.is_performance; });
  if (!has_comparison && tests.is_in_family("point_of_subjective_equality")) {
    tests.add_untested("point_of_subjective_equality", "", "no_point_of_equality");
  }
  if (tests.is_in_family("conditions") && tests.find("conditions") == nullptr &&
      !have_conditions(studies)) {
    tests.add_untested("conditions", "", "one_condition");
  }
}

std::vector<StudyTest> test_responses(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  const std::vector<DiscriminationStudy> studies = discrimination_studies(gathered);
  if (studies.empty()) return std::move(tests).take_family();
  set_default_of_designs(studies, tests);
  const bool needs_thresholds = tests.is_in_family("conditions") ||
                                tests.is_in_family("point_of_subjective_equality") ||
                                tests.is_in_family(kGroupsTest);
  AnalysisOutcome unused{};
  GroupComparisons groups(gathered);
  for (const DiscriminationStudy& study : studies) {
    const DiscriminationResults results(
        gathered, study, studies.size() > 1,
        needs_thresholds ? ThresholdDetail::estimates : ThresholdDetail::none);
    if (tests.is_in_family("order")) test_order(gathered, results, tests, unused);
    if (!needs_thresholds) continue;
    test_conditions(gathered, results, tests, unused);
    if (!study.task.is_performance) test_equality(gathered, results, tests, unused);
    if (tests.is_in_family(kGroupsTest)) add_to_groups(gathered, results, groups);
  }
  groups.add_tests(tests, unused);
  add_tests_without_design(studies, tests);
  return std::move(tests).take_family();
}

void analyze_responses(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<DiscriminationStudy> studies = discrimination_studies(gathered);
  remark_on_left_out(studies, outcome);
  if (studies.empty()) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The protocol does not state the judgement and the parameter that is varied with "
               "its value in the standard, so that thresholds cannot be estimated; state them in a "
               "new version of the protocol."));
    return;
  }
  std::vector<DiscriminationResults> all{};
  for (const DiscriminationStudy& study : studies) {
    all.emplace_back(gathered, study, studies.size() > 1);
  }
  StudyTests tests(gathered);
  set_default_of_designs(studies, tests);
  GroupComparisons groups(gathered);
  for (const DiscriminationResults& results : all) {
    add_to_groups(gathered, results, groups);
    keep_findings(results.fit.thresholds, outcome);
    // A reason why a function could not be fitted is the status of its thresholds.
    keep_findings(results.fit.functions, outcome, [](const Finding& finding) {
      const std::string& quantity = finding.quantity;
      return finding.status == "ok" &&
             (quantity.starts_with("fit.") || quantity.starts_with("deviance") ||
              is(finding, "bound.beta") || is(finding, "loglik"));
    });
    keep_findings(results.means, outcome);
    keep_findings(results.compared, outcome);
    keep_findings(results.unsure, outcome);
    remark_on_unsure(results, outcome);
    test_order(gathered, results, tests, outcome);
    test_conditions(gathered, results, tests, outcome);
    if (results.study.task.is_performance) continue;
    remark_on_direction(results, outcome);
    test_equality(gathered, results, tests, outcome);
  }
  add_tests_without_design(studies, tests);
  groups.add_tests(tests, outcome);
  add_discrimination_tables(gathered, all, outcome);
  add_choice_model(gathered, studies, outcome);
  add_sensitivity(gathered, all, outcome);
  add_choice_sensitivity(gathered, all, outcome);
  add_confidence_roc(gathered, all, outcome);
  tests.finish(outcome);
  for (const DiscriminationResults& results : all) ask_discrimination(results, tests, outcome);
  groups.report(tests, outcome);
}

}  // namespace

std::vector<StudyTest> test_discrimination(const GatheredAnswers& gathered) {
  return test_responses(without_excluded(gathered));
}

void analyze_discrimination(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  analyze_with_exclusions(gathered, outcome, analyze_responses);
}

}  // namespace asperity
