// Groups trials into functions by participant and condition, fits them, and averages over participants.

#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "analysis/tests/geometric_mean.h"
#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"

namespace asperity {

namespace {

std::vector<DiscriminationResults::Function> functions_of(
    const GatheredAnswers& gathered, const DiscriminationStudy& study,
    const std::vector<std::string>& conditions) {
  std::map<std::pair<std::uint32_t, std::size_t>, std::vector<const DiscriminationTrial*>> groups{};
  for (const DiscriminationTrial& trial : study.trials) {
    groups[{trial.person, trial.condition}].push_back(&trial);
  }
  std::vector<DiscriminationResults::Function> functions{};
  for (const auto& [of, trials] : groups) {
    DiscriminationData data{.key = {gathered.people[of.first].label, conditions[of.second]}};
    for (const DiscriminationTrial* const trial : trials) {
      study.count(*trial, data.hits[trial->value]);
      data.by_procedure = data.by_procedure || trial->by_procedure;
    }
    if (data.by_procedure) data.placed = placed_trials(gathered, study, trials);
    functions.push_back({.person = of.first, .condition = of.second, .data = std::move(data)});
  }
  return functions;
}

void add_geometric(QuantityName quantity, const FindingKey& key, const std::vector<double>& numbers,
                   FindingList& list) {
  const bool are_positive =
      std::all_of(numbers.begin(), numbers.end(), [](double number) { return number > 0.0; });
  if (!are_positive) return;
  constexpr double kConfidenceOfMeans = 0.95;
  const GeometricMean mean = geometric_mean(numbers, kConfidenceOfMeans);
  Basis basis{.n = mean.n,
              .method =
                  "geometric mean over the participants with such a threshold; t interval on "
                  "the log scale",
              .interval = mean.interval};
  if (mean.interval) basis.confidence = kConfidenceOfMeans;
  list.number(quantity, key, mean.mean, basis);
}

/// Of the geometric mean of the JNDs of comparisons, which are fitted with lapse rates of 2 %.
std::string coverage_with_fixed_lapses() {
  return simulated_coverage({22, 95}) + " where participants never lapse, and " +
         text_of(CoverageSpan{91, 96}) + " with lapse rates of 2 %";
}

/// A word in place of a mean that would not be a bound.
void add_no_mean(QuantityName quantity, const FindingKey& key, std::size_t n, FindingList& list) {
  list.word(
      quantity, key, code_of(MeanOfThresholds::no_bound),
      "thresholds are missing that do not all lie on the same side of the presented levels, so "
      "that the mean of the others is neither an upper nor a lower bound: present levels on "
      "both sides of every threshold",
      {.n = n});
}

/// Why a mean has no interval; nothing where no threshold is left out.
std::optional<std::string> bound_text(const LeftOutThresholds& left_out) {
  const std::string missing = std::to_string(left_out.missing()) + " of " +
                              std::to_string(left_out.of) + " thresholds are left out";
  switch (left_out.mean()) {
    case MeanOfThresholds::upper_bound:
      return "an upper bound without an interval: " + missing + ", below the presented levels";
    case MeanOfThresholds::lower_bound:
      return "a lower bound without an interval: " + missing + ", above the presented levels";
    case MeanOfThresholds::complete:
    case MeanOfThresholds::no_bound:
      break;
  }
  return std::nullopt;
}

/// The numbers of a threshold by participant, in the order of the conditions, of those with a number in every condition.
std::vector<std::vector<double>> complete_thresholds(const DiscriminationResults& results,
                                                     QuantityName quantity) {
  const FoundNumbers found(results.fit.thresholds);
  std::map<std::uint32_t, std::map<std::size_t, double>> by_person{};
  for (const auto& function : results.functions) {
    if (const auto value = found.value(quantity, function.data.key)) {
      by_person[function.person][function.condition] = *value;
    }
  }
  std::vector<std::vector<double>> complete{};
  for (const auto& [person, numbers] : by_person) {
    if (numbers.size() < results.conditions.size()) continue;
    std::vector<double>& own = complete.emplace_back();
    for (const auto& [condition, number] : numbers) own.push_back(number);
  }
  return complete;
}

/// The geometric mean of the ratios of the second condition to the first. Thresholds that are left out lie mostly in one
/// condition, so that an interval from the other participants describes them only (docs/analysis.md).
void add_ratio(QuantityName quantity, const FindingKey& key,
               const std::vector<std::vector<double>>& complete, std::size_t missing,
               FindingList& list) {
  std::vector<double> ratios{};
  for (const auto& own : complete) ratios.push_back(own[1] / own[0]);
  constexpr double kConfidenceOfRatio = 0.95;
  const GeometricMean ratio = geometric_mean(ratios, kConfidenceOfRatio);
  Basis basis{.n = ratio.n,
              .method =
                  "geometric mean of the ratios of the participants with a threshold in both "
                  "conditions"};
  if (missing > 0) {
    basis.method += "; without an interval: " + std::to_string(missing) +
                    " of those with trials in both have no threshold in one of them";
  } else {
    basis.method += "; t interval on the log scale";
    if (ratio.interval) basis.method += simulated_coverage({89, 96});
    basis.interval = ratio.interval;
    if (ratio.interval) basis.confidence = kConfidenceOfRatio;
  }
  list.number(quantity, key, ratio.mean, basis);
}

std::vector<Finding> compared_thresholds(const DiscriminationResults& results) {
  if (results.conditions.size() < 2) return {};
  const std::vector<std::vector<double>> complete =
      complete_thresholds(results, results.quantity_of_threshold());
  if (complete.empty()) return {};
  FindingList list{};
  const std::string& unit = results.study.task.varied.unit;
  for (std::size_t condition = 0; condition < results.conditions.size(); ++condition) {
    std::vector<double> numbers{};
    for (const auto& own : complete) numbers.push_back(own[condition]);
    list.number(
        results.mean_of_threshold(), results.conditions[condition], geometric_mean(numbers).mean,
        {.n = complete.size(),
         .method = "geometric mean over the participants with a threshold in every condition",
         .unit = unit.empty() ? "1" : unit});
  }
  if (results.conditions.size() == 2) {
    add_ratio(results.ratio_of_threshold(), {results.conditions[1], results.conditions[0]},
              complete, results.participants_in_all_conditions() - complete.size(), list);
  }
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) finding.analysis = kComparedThresholds;
  return findings;
}

std::vector<Finding> means_of(const DiscriminationResults& results) {
  const FoundNumbers found(results.fit.thresholds);
  std::vector<Finding> means{};
  for (const ThresholdColumn& column : kThresholdColumns) {
    for (std::size_t condition = 0; condition < results.conditions.size(); ++condition) {
      std::vector<double> numbers{};
      std::string unit{};
      for (const auto& function : results.functions) {
        if (function.condition != condition) continue;
        const Finding* const own = found.find(column.quantity, function.data.key);
        if (own == nullptr || !own->value) continue;
        numbers.push_back(*own->value);
        unit = own->unit;
      }
      if (numbers.empty()) continue;
      const std::string& name = results.conditions[condition];
      const LeftOutThresholds left_out =
          left_out_thresholds(results.fit.thresholds, column.quantity, name);
      FindingList list{};
      if (left_out.mean() == MeanOfThresholds::no_bound) {
        add_no_mean(column.mean, name, numbers.size(), list);
        if (!column.geometric_mean.empty()) {
          add_no_mean(column.geometric_mean, name, numbers.size(), list);
        }
      } else {
        add_mean_of_group(column.mean, name, numbers,
                          {.of = "mean over the participants with such a threshold"}, list);
        if (!column.geometric_mean.empty()) {
          add_geometric(column.geometric_mean, name, numbers, list);
        }
      }
      std::vector<Finding> of_condition = list.take();
      drop_intervals(of_condition, [&left_out](const Finding&) { return bound_text(left_out); });
      for (Finding& finding : of_condition) {
        if (is(finding, "geomean.jnd") && finding.low && !results.study.task.is_performance) {
          finding.method += coverage_with_fixed_lapses();
        }
        finding.unit = unit;
        finding.analysis = kMeanThresholds;
        means.push_back(std::move(finding));
      }
    }
  }
  return means;
}

std::vector<OrderOfPerson> orders_of(const DiscriminationStudy& study) {
  std::map<std::uint32_t, OrderOfPerson> by_person{};
  for (const DiscriminationTrial& trial : study.trials) {
    OrderOfPerson& own = by_person[trial.person];
    own.person = trial.person;
    own.alternatives = study.task.design->alternatives();
    ChoiceCount& count = trial.comparison_first ? own.first : own.second;
    ++count.trials;
    count.hits += trial.chose_comparison ? 1 : 0;
    count.unsure += trial.is_unsure ? 1 : 0;
  }
  std::vector<OrderOfPerson> orders{};
  for (const auto& [person, own] : by_person) orders.push_back(own);
  return orders;
}

std::vector<Finding> order_findings(const std::vector<OrderOfPerson>& orders,
                                    const std::string& task) {
  std::vector<double> differences{};
  for (const OrderOfPerson& own : orders) {
    if (own.has_both()) differences.push_back(own.difference());
  }
  if (differences.empty()) return {};
  FindingList list{};
  add_mean_of_group("order.difference", task, differences,
                    {.possible = ConfidenceInterval{-1.0, 1.0},
                     .of = "mean of the participants' differences: proportion of choices of the "
                           "comparison as surface A (in a sequence, presented first) minus that of "
                           "the comparison as surface B"},
                    list);
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) finding.analysis = kOrderEffect;
  return findings;
}

/// Rates of all functions where there is a response "cannot tell": a participant without one has the rate 0.
std::vector<Finding> unsure_rates(const DiscriminationResults& results) {
  if (!results.study.has_unsure()) return {};
  constexpr double kConfidenceOfRate = 0.95;
  FindingList list{};
  for (const auto& function : results.functions) {
    const ChoiceCount all = sum_of_choices(function.data.hits);
    const HitCount unsure{.hits = all.unsure, .trials = all.trials};
    list.number("rate", function.data.key, proportion(unsure),
                {.n = static_cast<std::size_t>(all.trials),
                 .method = "proportion of responses \"cannot tell\"; Wilson interval",
                 .interval = wilson_interval(unsure, kConfidenceOfRate),
                 .confidence = kConfidenceOfRate});
  }
  std::vector<Finding> findings = list.take();
  for (Finding& finding : findings) finding.analysis = kUnsure;
  return findings;
}

}  // namespace

DiscriminationResults::DiscriminationResults(const GatheredAnswers& gathered,
                                             const DiscriminationStudy& of, bool is_one_of_several,
                                             ThresholdDetail detail)
    : study(of), name(is_one_of_several ? of.task.name : std::string()) {
  for (const std::string& condition : of.conditions) {
    conditions.push_back(name.empty()         ? condition
                         : condition == "all" ? name
                                              : name + ": " + condition);
  }
  functions = functions_of(gathered, of, conditions);
  if (detail != ThresholdDetail::none) {
    std::vector<DiscriminationData> data{};
    for (const Function& function : functions) {
      DiscriminationData& own = data.emplace_back(function.data);
      if (detail == ThresholdDetail::complete) continue;
      own.placed.reset();
      own.needs_intervals = false;
    }
    fit = fit_discrimination(of.task, data);
    if (detail == ThresholdDetail::complete) means = means_of(*this);
    compared = compared_thresholds(*this);
  }
  if (of.task.design == &two_alternatives()) orders = orders_of(of);
  if (of.task.design->is_choice_of_three()) places = places_of(of);
  order = places.empty() ? order_findings(orders, name) : place_findings(places, name);
  unsure = unsure_rates(*this);
}

std::size_t DiscriminationResults::participants_in_all_conditions() const {
  std::map<std::uint32_t, std::size_t> with_trials{};
  for (const Function& function : functions) ++with_trials[function.person];
  return static_cast<std::size_t>(
      std::count_if(with_trials.begin(), with_trials.end(),
                    [this](const auto& each) { return each.second == conditions.size(); }));
}

std::string DiscriminationResults::about_equality(std::size_t condition) const {
  const std::string parameter = words_of_parameter(study.task.varied.parameter);
  return conditions.size() == 1 && name.empty() ? parameter
                                                : parameter + " (" + conditions[condition] + ')';
}

}  // namespace asperity
