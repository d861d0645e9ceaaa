// Represents the responses of a magnitude estimation as estimates by condition and spacing.

#include "app/findings/study/estimates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/number_text.h"
#include "app/findings/study/answer_columns.h"

namespace asperity {

namespace {

// The condition of all estimates where a protocol has none.
constexpr const char* kOneCondition = "all";

/// The names of two of the columns: that of the conditions and that of the values.
struct EstimateColumns {
  const char* condition = "";
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
                                         {"spacing", std::move(spacings).take()},
                                         {names.value, std::move(values)}},
          "the estimates"};
}

}  // namespace

std::vector<Estimated> estimates_in(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Estimated> estimates{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const std::optional<double> spacing_m = gathered.spacing_m(answer);
    const std::optional<double> estimate =
        number_in(gathered.word(gathered.reply_of(answer).answer));
    if (!spacing_m || !estimate || *spacing_m <= 0.0 || *estimate <= 0.0) continue;
    const std::string& condition =
        gathered.word(gathered.level(answer, gathered.estimation.condition));
    estimates.push_back({.person = answer.person,
                         .condition = condition.empty() ? kOneCondition : condition,
                         .spacing = number_text(*spacing_m),
                         .repetition = answer.repetition,
                         .estimate = *estimate});
  }
  const std::size_t left_out = gathered.answers.size() - estimates.size();
  if (left_out > 0) {
    outcome.remarks.push_back(phrase("Analysis",
                                     "Responses left out because they are not numbers above 0, or "
                                     "because the protocol does not state their spacing: %1.")
                                  .with(std::to_string(left_out)));
  }
  if (gathered.count.anchors > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Estimates of anchors, which are not analysed: %1.")
            .with(std::to_string(gathered.count.anchors)));
  }
  return estimates;
}

std::vector<std::string> levels_of(const std::vector<Estimated>& estimates,
                                   std::string Estimated::*name) {
  std::vector<std::string> levels{};
  for (const Estimated& one : estimates) levels.push_back(one.*name);
  std::sort(levels.begin(), levels.end(), [](const std::string& a, const std::string& b) {
    const auto first = number_in(a);
    const auto second = number_in(b);
    if (first.has_value() != second.has_value()) return first.has_value();
    return first && second ? *first < *second : a < b;
  });
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

std::vector<std::string> conditions_of(const std::vector<Estimated>& estimates,
                                       const std::vector<std::string>& declared) {
  std::vector<std::string> conditions = levels_of(estimates, &Estimated::condition);
  std::stable_sort(conditions.begin(), conditions.end(),
                   [&declared](const std::string& one, const std::string& other) {
                     return std::find(declared.begin(), declared.end(), one) <
                            std::find(declared.begin(), declared.end(), other);
                   });
  return conditions;
}

TidyInput curves_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates) {
  TidyInput input{};
  input.tables.push_back(estimates_table(gathered, estimates, {"probe", "estimate"},
                                         [](double estimate) { return estimate; }));
  input.options.set("zero_rule", std::string("exclude"));
  input.options.set("normalisation", std::string("geomean"));
  return input;
}

TidyInput anova_table(const GatheredAnswers& gathered, const std::vector<Estimated>& estimates,
                      const std::vector<std::string>& conditions,
                      const std::vector<std::string>& spacings) {
  TidyInput input{};
  input.tables.push_back(estimates_table(gathered, estimates, {"condition", "y"},
                                         [](double estimate) { return std::log10(estimate); }));
  std::vector<std::pair<std::string, std::vector<std::string>>> within{};
  if (conditions.size() > 1) within.emplace_back("condition", conditions);
  within.emplace_back("spacing", spacings);
  input.options.set("within", within);
  return input;
}

std::string cell_key(const std::string& condition, const std::string& spacing) {
  return condition + '|' + spacing;
}

}  // namespace asperity
