// Averages log thresholds, order effects as differences of z, and errors in catch trials; two alternatives only.

#include "app/findings/methods/discrimination/thresholds/shown_thresholds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/numbers/summary.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

namespace {

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
    const auto value =
        found.value(is_performance ? QuantityName("jnd.dprime1") : "jnd", function.data.key);
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

ShownParameters shown_discrimination_parameters(const GatheredAnswers& gathered,
                                                const TabulatedQuestion& asked) {
  ShownParameters shown{};
  if (asked.block.design() != &two_alternatives()) return shown;
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
