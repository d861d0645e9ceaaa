// Represents the responses of a magnitude estimation as estimates by condition and spacing.

#include "app/findings/shared/estimates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/shared/repetition_reliability.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

// The condition of all estimates where a protocol has none.
constexpr const char* kOneCondition = "all";

/// The names of the columns of the conditions, of the spacings or stimuli, and of the values.
struct EstimateColumns {
  const char* condition = "";
  const char* spacing = "";
  const char* value = "";
};

TidyTable estimates_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                          const EstimateColumns& names, double (*value_of)(double)) {
  LabelRows subjects{};
  LabelRows conditions{};
  LabelRows spacings{};
  NumberColumn values{};
  for (const Estimated& one : estimates) {
    subjects.add(gathered.people[one.person].label);
    conditions.add(one.condition);
    spacings.add(one.spacing);
    values.push_back(value_of(one.estimate));
  }
  return {std::vector<TidyTable::Column>{{"subject", std::move(subjects).take()},
                                         {names.condition, std::move(conditions).take()},
                                         {names.spacing, std::move(spacings).take()},
                                         {names.value, std::move(values)}},
          "the estimates"};
}

/// The spacing in metres, or the level of the factor that names the stimuli.
std::optional<std::string> stimulus_of(const GatheredAnswers& gathered,
                                       const GatheredAnswer& answer) {
  if (!gathered.estimation.items.empty()) {
    const std::string& item = gathered.word(gathered.level(answer, gathered.estimation.items));
    return item.empty() ? std::nullopt : std::optional(item);
  }
  const std::optional<double> spacing_m = gathered.spacing_m(answer);
  if (!spacing_m || *spacing_m <= 0.0) return {};
  return number_text(*spacing_m);
}

/// The standard as estimates name their stimulus.
std::string stimulus_of_standard(const EstimationDeclaration& estimation) {
  const std::string& level = estimation.modulus->standard;
  const auto spacing_m = estimation.spacing_m.find(level);
  return spacing_m == estimation.spacing_m.end() ? level : number_text(spacing_m->second);
}

/// Whether the protocol states a normalisation by the standard for which there are no estimates.
bool lacks_standard(const EstimationDeclaration& estimation,
                    const std::vector<Estimated>& estimates) {
  return estimation.normalisation() == EstimateNormalisation::standard &&
         used_normalisation(estimation, estimates) == EstimateNormalisation::none;
}

/// Sets the options of the family `magnitude`.
void set_normalisation(const EstimationDeclaration& estimation,
                       const std::vector<Estimated>& estimates, TidyInput& input) {
  input.options.set("zero_rule", std::string("exclude"));
  switch (used_normalisation(estimation, estimates)) {
    case EstimateNormalisation::geometric_mean:
      input.options.set("normalisation", std::string("geomean"));
      return;
    case EstimateNormalisation::none:
      input.options.set("normalisation", std::string("none"));
      return;
    case EstimateNormalisation::standard:
      break;
  }
  const std::string standard = stimulus_of_standard(estimation);
  input.options.set("normalisation", std::string("standard"));
  input.options.set("modulus", estimation.modulus->value);
  if (estimation.items.empty()) {
    input.options.set("standard_spacing", *number_in(standard));
  } else {
    input.options.set("standard_item", standard);
  }
}

std::vector<Estimated> estimates_in(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Estimated> estimates{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<std::string> stimulus = stimulus_of(gathered, answer);
    const std::optional<double> estimate =
        number_in(gathered.word(gathered.reply_of(answer).answer));
    if (!stimulus || !estimate || *estimate <= 0.0) continue;
    const std::string& condition =
        gathered.word(gathered.level(answer, gathered.estimation.condition));
    estimates.push_back({.person = answer.person,
                         .condition = condition.empty() ? kOneCondition : condition,
                         .spacing = *stimulus,
                         .repetition = answer.repetition,
                         .estimate = *estimate});
  }
  const std::size_t left_out = gathered.answers.size() - estimates.size();
  if (left_out > 0) {
    outcome.remarks.push_back(
        (gathered.estimation.items.empty()
             ? phrase("Analysis",
                      "Responses left out because they are not numbers above 0, or "
                      "because the protocol does not state their spacing: %1.")
             : phrase("Analysis", "Responses left out because they are not numbers above 0: %1."))
            .with(std::to_string(left_out)));
  }
  if (gathered.count.anchors > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Estimates of anchors, which are not analysed: %1.")
            .with(std::to_string(gathered.count.anchors)));
  }
  if (!estimates.empty() && lacks_standard(gathered.estimation, estimates)) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The estimates are not normalised by the standard (%1), because there is no "
               "estimate of it.")
            .with(gathered.estimation.modulus->standard));
    outcome.transformation =
        "Estimates were analysed as logarithms. They were not normalised, because no participant "
        "estimated the standard.";
  }
  return estimates;
}

/// Those declared in their order, then the others by value.
std::vector<std::string> levels_of(const std::vector<Estimated>& estimates,
                                   std::string Estimated::*name,
                                   const std::vector<std::string>& declared) {
  std::vector<std::string> levels{};
  for (const Estimated& one : estimates) levels.push_back(one.*name);
  std::sort(levels.begin(), levels.end(), precedes_by_value);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::stable_sort(levels.begin(), levels.end(),
                   [&declared](const std::string& one, const std::string& other) {
                     return std::find(declared.begin(), declared.end(), one) <
                            std::find(declared.begin(), declared.end(), other);
                   });
  return levels;
}

}  // namespace

EstimateNormalisation used_normalisation(const EstimationDeclaration& estimation,
                                         const std::vector<Estimated>& estimates) {
  if (estimation.normalisation() != EstimateNormalisation::standard) {
    return estimation.normalisation();
  }
  const std::string standard = stimulus_of_standard(estimation);
  const bool is_estimated =
      std::any_of(estimates.begin(), estimates.end(),
                  [&standard](const Estimated& one) { return one.spacing == standard; });
  // Responses to the standard may be missing; then there is nothing to divide by.
  return is_estimated ? EstimateNormalisation::standard : EstimateNormalisation::none;
}

ComparedEstimates compared_estimates(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  ComparedEstimates compared{.gathered = gathered, .estimates = estimates_in(gathered, outcome)};
  const EstimationDeclaration& declared = gathered.estimation;
  compared.conditions = levels_of(compared.estimates, &Estimated::condition, declared.conditions);
  compared.stimuli = levels_of(compared.estimates, &Estimated::spacing, declared.item_levels);
  std::stable_sort(
      compared.estimates.begin(), compared.estimates.end(),
      [&compared](const Estimated& one, const Estimated& other) {
        const auto place = [&compared](const Estimated& estimate) {
          return std::pair(
              std::find(compared.conditions.begin(), compared.conditions.end(), estimate.condition),
              std::find(compared.stimuli.begin(), compared.stimuli.end(), estimate.spacing));
        };
        return place(one) < place(other);
      });
  return compared;
}

EstimateCells cells_of(const std::vector<Estimated>& estimates) {
  EstimateCells cells{};
  for (const Estimated& one : estimates) {
    cells[{one.person, one.condition, one.spacing}].push_back(std::log10(one.estimate));
  }
  return cells;
}

GroupProfile profile_of_estimates(const ComparedEstimates& compared) {
  const bool are_groups = compared.gathered.estimation.condition == compared.gathered.group_factor;
  GroupProfile profile{.words = phrase("Analysis", "how the estimates depend on the stimuli")};
  std::set<std::string> cells{};
  const EstimateCells all = cells_of(compared.estimates);
  // How a participant's estimates differ between conditions is not how they depend on the stimuli.
  std::map<std::pair<std::uint32_t, std::string>, std::vector<double>> of_condition{};
  for (const auto& [of, logarithms] : all) {
    of_condition[{std::get<0>(of), std::get<1>(of)}].push_back(mean_logarithm(logarithms));
  }
  for (const auto& [of, logarithms] : all) {
    const auto& [person, condition, stimulus] = of;
    const std::string cell =
        are_groups || compared.conditions.size() < 2 ? stimulus : condition + " / " + stimulus;
    profile.values[{person, cell}] =
        mean_logarithm(logarithms) - mean_logarithm(of_condition.at({person, condition}));
    cells.insert(cell);
  }
  profile.items.assign(cells.begin(), cells.end());
  return profile;
}

double mean_logarithm(const std::vector<double>& logarithms) {
  return summary_of(logarithms)->mean;
}

void ask_reliability_of_estimates(const ComparedEstimates& compared, AnalysisOutcome& outcome) {
  std::vector<RepeatedEstimate> repeated{};
  for (const Estimated& one : compared.estimates) {
    repeated.push_back({.person = one.person,
                        .surface = one.condition + " / " + one.spacing,
                        .repetition = one.repetition,
                        .value = std::log10(one.estimate)});
  }
  ask_reliability_of_estimates(compared.gathered, repeated, outcome);
}

TidyInput curves_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates) {
  TidyInput input{};
  input.tables.push_back(estimates_table(gathered, estimates, {"probe", "spacing", "estimate"},
                                         [](double estimate) { return estimate; }));
  set_normalisation(gathered.estimation, estimates, input);
  return input;
}

TidyInput items_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                      const std::map<std::string, double>& predictor) {
  LabelRows subjects{};
  LabelRows conditions{};
  LabelRows items{};
  NumberColumn values{};
  NumberColumn predictors{};
  for (const Estimated& one : estimates) {
    subjects.add(gathered.people[one.person].label);
    conditions.add(one.condition);
    items.add(one.spacing);
    values.push_back(one.estimate);
    if (!predictor.empty()) predictors.push_back(predictor.at(one.spacing));
  }
  std::vector<TidyTable::Column> columns{{"subject", std::move(subjects).take()},
                                         {"probe", std::move(conditions).take()},
                                         {"item", std::move(items).take()},
                                         {"estimate", std::move(values)}};
  if (!predictor.empty()) columns.push_back({"spacing", std::move(predictors)});
  TidyInput input{};
  input.tables.emplace_back(std::move(columns), "the estimates");
  set_normalisation(gathered.estimation, estimates, input);
  return input;
}

Phrase normalisation_note(const EstimationDeclaration& estimation,
                          const std::vector<Estimated>& estimates) {
  if (lacks_standard(estimation, estimates)) {
    return phrase("Analysis",
                  "Standard with modulus %1 (%2): the estimates are not normalised, because there "
                  "is no estimate of the standard.")
        .with(number_text(estimation.modulus->value), estimation.modulus->standard);
  }
  switch (estimation.normalisation()) {
    case EstimateNormalisation::geometric_mean:
      return phrase("Analysis",
                    "Free modulus: each participant's scale is removed (the mean of the logarithms "
                    "of all cells is subtracted, and the grand mean added).");
    case EstimateNormalisation::standard:
      return phrase("Analysis",
                    "Standard with modulus %1 (%2): each participant's estimates are divided by "
                    "the geometric mean of that participant's estimates of the standard, and "
                    "multiplied by the modulus.")
          .with(number_text(estimation.modulus->value), estimation.modulus->standard);
    case EstimateNormalisation::none:
      break;
  }
  return phrase("Analysis",
                "Standard with modulus %1 (%2): the estimates are not normalised, because the "
                "standard determines the modulus of all participants.")
      .with(number_text(estimation.modulus->value), estimation.modulus->standard);
}

namespace {

/// Each participant's constant on the logarithmic scale, which the normalisation removes: the mean over the participant's cells
/// with free modulus, and over the estimates of the standard where the estimates are divided by these.
std::map<std::uint32_t, double> log_scales(const EstimationDeclaration& estimation,
                                           const std::vector<Estimated>& estimates) {
  struct Sum {
    double total = 0.0;
    double n = 0.0;
    void add(double value) {
      total += value;
      n += 1.0;
    }
  };
  const EstimateNormalisation normalisation = used_normalisation(estimation, estimates);
  std::map<std::uint32_t, double> scales{};
  if (normalisation == EstimateNormalisation::none) return scales;
  const bool by_standard = normalisation == EstimateNormalisation::standard;
  const std::string standard = by_standard ? stimulus_of_standard(estimation) : std::string();
  std::map<std::uint32_t, std::map<std::pair<std::string, std::string>, Sum>> cells{};
  for (const Estimated& one : estimates) {
    if (by_standard && one.spacing != standard) continue;
    cells[one.person][{one.condition, one.spacing}].add(std::log10(one.estimate));
  }
  for (const auto& [person, of_person] : cells) {
    Sum mean{};
    for (const auto& [cell, sum] : of_person) mean.add(sum.total / sum.n);
    scales[person] = mean.total / mean.n;
  }
  return scales;
}

}  // namespace

TidyInput anova_table(const ComparedEstimates& compared, const std::string& factor) {
  TidyInput input{};
  const std::map<std::uint32_t, double> scales =
      log_scales(compared.gathered.estimation, compared.estimates);
  std::vector<Estimated> logs = compared.estimates;
  for (Estimated& one : logs) {
    const auto scale = scales.find(one.person);
    one.estimate = std::log10(one.estimate) - (scale == scales.end() ? 0.0 : scale->second);
  }
  input.tables.push_back(estimates_table(compared.gathered, logs,
                                         {"condition", factor.c_str(), "y"},
                                         [](double estimate) { return estimate; }));
  std::vector<std::pair<std::string, std::vector<std::string>>> within{};
  if (compared.conditions.size() > 1) within.emplace_back("condition", compared.conditions);
  within.emplace_back(factor, compared.stimuli);
  input.options.set("within", within);
  return input;
}

}  // namespace asperity
