#include "app/findings/study/shown_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/summary.h"
#include "analysis/tail_probabilities.h"
#include "analysis/variance_components.h"
#include "app/findings/found_numbers.h"
#include "app/findings/study/discrimination_results.h"

namespace asperity {

namespace {

/// The cell of a response: the item of its surface where the block has several, and the levels of the factors.
std::string cell_of_response(const GatheredAnswers& gathered, const GatheredAnswer& answer,
                             const TabulatedQuestion& asked) {
  if (asked.items.size() > 1) {
    return gathered.word(gathered.surfaces_of(answer).front().item);
  }
  std::string cell{};
  for (const auto& [factor, levels] : asked.factors) {
    cell += gathered.word(gathered.level(answer, factor)) + '|';
  }
  if (asked.block.vary) cell += gathered.word(gathered.level(answer, asked.block.vary->factor));
  return cell;
}

/// The responses to the question as numbers, in cells.
std::vector<CellNumber> cell_numbers(
    const GatheredAnswers& gathered, const TabulatedQuestion& asked,
    const std::function<std::string(const GatheredAnswer&)>& cell_of,
    const std::function<std::optional<double>(double)>& value_of) {
  std::map<std::string, std::size_t> cells{};
  std::vector<CellNumber> numbers{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const bool is_asked = gathered.word(answer.block) == asked.block.name &&
                          gathered.word(answer.question) == asked.question.name;
    const std::optional<double> number = gathered.reply_of(answer).number;
    if (!is_asked || !number || answer.surface_count == 0) continue;
    const std::optional<double> value = value_of(*number);
    if (!value) continue;
    const std::size_t cell = cells.try_emplace(cell_of(answer), cells.size()).first->second;
    numbers.push_back({.participant = answer.person, .cell = cell, .value = *value});
  }
  return numbers;
}

void add_components(const VarianceComponents& components, ShownParameters& shown) {
  shown["level"] = components.mean;
  shown["level_sd"] = components.participant_sd;
  shown["noise_sd"] = components.within_sd;
}

/// The effect of the order on a participant, and the sampling variance of the effect.
struct OwnOrder {
  double effect = 0.0;
  double variance = 0.0;
};

OwnOrder own_order(const OrderOfPerson& counts) {
  OwnOrder own{};
  for (const auto& [count, sign] :
       {std::pair(&counts.first, 1.0), std::pair(&counts.second, -1.0)}) {
    const auto trials = static_cast<double>(count->trials);
    const double p = (split_hits(*count, counts.alternatives) + 0.5) / (trials + 1.0);
    const double z = normal_quantile(p);
    const double density = normal_density(z);
    own.effect += sign * z / std::numbers::sqrt2;
    own.variance += 0.5 * p * (1.0 - p) / (trials * density * density);
  }
  return own;
}

void add_order(const std::vector<OrderOfPerson>& orders, ShownParameters& shown) {
  std::vector<double> effects{};
  double sampling = 0.0;
  for (const OrderOfPerson& counts : orders) {
    if (!counts.has_both()) continue;
    const OwnOrder own = own_order(counts);
    effects.push_back(own.effect);
    sampling += own.variance;
  }
  if (effects.size() < 2) return;
  const Summary summary = summary_of(effects).value();
  const double variance = summary.sd * summary.sd - sampling / static_cast<double>(effects.size());
  shown["order"] = summary.mean;
  shown["order_sd"] = std::sqrt(std::max(variance, 0.0));
}

/// The difference with d′ = 1 over the JND of a comparison, ½(x75 − x25) of a cumulative normal function with the standard
/// deviation √2·θ: 1/(√2·z(.75)).
constexpr double kThresholdOfJnd = 1.0483580825;

void add_thresholds_shown(const DiscriminationResults& results, ShownParameters& shown) {
  const FoundNumbers found(results.fit.thresholds);
  const bool is_performance = results.study.task.is_performance;
  struct OfPerson {
    double sum = 0.0;
    std::size_t conditions = 0;
  };
  std::map<std::uint32_t, OfPerson> by_person{};  // of the logarithms
  for (const auto& function : results.functions) {
    const auto value = found.value(is_performance ? "jnd.dprime1" : "jnd", function.data.key);
    if (!value || *value <= 0.0) continue;
    OfPerson& own = by_person[function.person];
    own.sum += std::log(*value * (is_performance ? 1.0 : kThresholdOfJnd));
    ++own.conditions;
  }
  // What differs between conditions is the ratio of their thresholds, not a difference between participants.
  std::vector<double> logarithms{};
  for (const auto& [person, own] : by_person) {
    if (own.conditions != results.conditions.size()) continue;
    logarithms.push_back(own.sum / static_cast<double>(own.conditions));
  }
  if (logarithms.size() < 2) return;
  const Summary summary = summary_of(logarithms).value();
  shown["threshold"] = std::exp(summary.mean);
  shown["threshold_sd"] = summary.sd;
}

void add_lapse(const GatheredAnswers& gathered, const TabulatedQuestion& asked,
               ShownParameters& shown) {
  std::size_t trials = 0;
  std::size_t errors = 0;
  for (const CatchResponses& each : gathered.catch_responses) {
    if (each.block != asked.block.name || each.type != CatchType::easy) continue;
    trials += each.trials;
    errors += each.trials - each.correct;
  }
  constexpr std::size_t kFewest = 20;
  if (trials < kFewest) return;
  shown["lapse"] = std::min(1.0, 2.0 * static_cast<double>(errors) / static_cast<double>(trials));
}

}  // namespace

ShownParameters shown_rating_parameters(const GatheredAnswers& gathered,
                                        const TabulatedQuestion& asked) {
  ShownParameters shown{};
  const auto components = variance_components(cell_numbers(
      gathered, asked,
      [&](const GatheredAnswer& answer) { return cell_of_response(gathered, answer, asked); },
      [](double number) { return std::optional(number); }));
  if (!components) return shown;
  add_components(*components, shown);
  shown["difference_sd"] = std::numbers::sqrt2 * components->interaction_sd;
  return shown;
}

ShownParameters shown_magnitude_parameters(const GatheredAnswers& gathered,
                                           const TabulatedQuestion& asked) {
  const auto* const line = std::get_if<LineForm>(&asked.question.form);
  const double longest = line == nullptr ? 1.0 : line->longest;
  const auto components = variance_components(cell_numbers(
      gathered, asked,
      [&](const GatheredAnswer& answer) {
        return gathered.word(gathered.level(answer, gathered.estimation.factor())) + '|' +
               gathered.word(gathered.level(answer, gathered.estimation.condition));
      },
      [longest](double number) {
        return number > 0.0 ? std::optional(std::log10(number / longest)) : std::nullopt;
      }));
  ShownParameters shown{};
  if (components) add_components(*components, shown);
  return shown;
}

ShownParameters shown_discrimination_parameters(const GatheredAnswers& gathered,
                                                const TabulatedQuestion& asked) {
  ShownParameters shown{};
  if (asked.block.design != &two_alternatives()) return shown;
  for (DiscriminationStudy& study : discrimination_studies(gathered)) {
    std::erase_if(study.trials, [&](const DiscriminationTrial& trial) {
      return gathered.word(trial.block) != asked.block.name;
    });
    if (study.trials.empty() || study.task.question != asked.question.name) continue;
    const DiscriminationResults results(gathered, study, false, ThresholdDetail::estimates);
    add_thresholds_shown(results, shown);
    add_order(results.orders, shown);
  }
  add_lapse(gathered, asked, shown);
  return shown;
}

}  // namespace asperity
