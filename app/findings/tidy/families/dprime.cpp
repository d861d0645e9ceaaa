// Sensitivity and bias from counts, by the design of the task.

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/choices/signal_detection.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/participant_bootstrap.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// One row of the table.
struct CountedTask {
  FindingKey key{};
  DetectionCounts counts{};
  std::size_t alternatives = 0;  ///< of the design mafc
  double confidence = 0.95;
};

constexpr const char* kNoFiniteSensitivity =
    "a proportion is 0 or 1, so that d′ is infinite: see the log-linear correction";

Basis basis_of(const CountedTask& task, std::string method) {
  return {.n = static_cast<std::size_t>(task.counts.signal.trials + task.counts.noise.trials),
          .method = std::move(method),
          .undefined = kNoFiniteSensitivity};
}

/// The two ways of estimating the proportions, with the ends of their quantities' names.
struct RateEstimate {
  DetectionRates (*rates)(const DetectionCounts&) = nullptr;
  const char* ending = "";
  const char* method = "";
};
constexpr std::array kRateEstimates{
    RateEstimate{observed_rates, "", ""},
    RateEstimate{loglinear_rates, ".loglinear", ", log-linear correction"}};

bool has_infinite_sensitivity(const DetectionRates& rates) {
  const auto is_extreme = [](double p) { return p <= 0.0 || p >= 1.0; };
  return is_extreme(rates.hit) || is_extreme(rates.false_alarm);
}

void add_with_interval(const CountedTask& task, const std::string& quantity, double value,
                       std::optional<double> error, const RateEstimate& estimate,
                       const std::string& method, FindingList& findings) {
  Basis basis = basis_of(task, method + estimate.method);
  if (!error) return findings.number(quantity + estimate.ending, task.key, value, basis);
  const double reach = normal_limit(task.confidence) * *error;
  const ConfidenceInterval ends{.low = value - reach, .high = value + reach};
  basis.interval = ends;
  basis.confidence = task.confidence;
  findings.number(quantity + estimate.ending, task.key, value, basis);
  const auto number = [&](const char* part, double shown) {
    findings.number(quantity + part + estimate.ending, task.key, shown,
                    basis_of(task, method + ", delta method" + estimate.method));
  };
  number(".se", *error);
  number(".lower", ends.low);
  number(".upper", ends.high);
}

void add_yes_no(const CountedTask& task, const RateEstimate& estimate, FindingList& findings) {
  const std::optional<Sensitivity> found = yes_no_sensitivity(estimate.rates(task.counts));
  if (!found) return;
  add_with_interval(task, "dprime", found->dprime, found->standard_error, estimate, "z(H) − z(F)",
                    findings);
  findings.number(std::string("criterion") + estimate.ending, task.key, found->criterion,
                  basis_of(task, "−½·(z(H) + z(F))"));
  findings.number(std::string("lnbeta") + estimate.ending, task.key, found->log_beta(),
                  basis_of(task, "logarithm of the likelihood ratio at the criterion, c·d′"));
}

void add_two_alternatives(const CountedTask& task, const RateEstimate& estimate,
                          FindingList& findings) {
  const std::optional<Sensitivity> found = two_alternative_sensitivity(estimate.rates(task.counts));
  if (!found) return;
  add_with_interval(task, "dprime", found->dprime, found->standard_error, estimate,
                    "(z(H) − z(F))/√2", findings);
  findings.number(std::string("criterion") + estimate.ending, task.key, found->criterion,
                  basis_of(task, "−½·(z(H) + z(F)): positive is a bias against the first"));
}

using SensitivityOfRule = std::optional<RuleSensitivity> (*)(const DetectionRates&, DecisionRule);

void add_both_rules(const CountedTask& task, const RateEstimate& estimate, SensitivityOfRule of,
                    FindingList& findings) {
  const DetectionRates rates = estimate.rates(task.counts);
  if (const auto found = of(rates, DecisionRule::differencing)) {
    add_with_interval(task, "dprime.diff", found->dprime, found->standard_error, estimate,
                      "d′ by the differencing rule", findings);
  }
  if (const auto found = of(rates, DecisionRule::independent)) {
    add_with_interval(task, "dprime.io", found->dprime, found->standard_error, estimate,
                      "d′ by the rule of independent observations", findings);
  }
}

void add_same_different(const CountedTask& task, const RateEstimate& estimate,
                        FindingList& findings) {
  add_both_rules(task, estimate, same_different_sensitivity, findings);
  const DetectionRates rates = estimate.rates(task.counts);
  if (has_infinite_sensitivity(rates)) return;
  findings.number(std::string("k.diff") + estimate.ending, task.key,
                  same_different_criterion(rates.false_alarm),
                  basis_of(task, "criterion of the differencing rule, from the false alarms"));
}

void add_abx(const CountedTask& task, const RateEstimate& estimate, FindingList& findings) {
  add_both_rules(task, estimate, abx_sensitivity, findings);
}

/// Hits and false alarms, and what a design derives from them.
template <void (*add)(const CountedTask&, const RateEstimate&, FindingList&)>
void add_rates(const CountedTask& task, FindingList& findings) {
  const DetectionRates observed = observed_rates(task.counts);
  const DetectionRates corrected = loglinear_rates(task.counts);
  findings.number("hit", task.key, observed.hit, basis_of(task, "proportion of hits"));
  findings.number("fa", task.key, observed.false_alarm,
                  basis_of(task, "proportion of false alarms"));
  const std::string correction = "(hits + ½)/(trials + 1), log-linear correction";
  findings.number("hit.loglinear", task.key, corrected.hit, basis_of(task, correction));
  findings.number("fa.loglinear", task.key, corrected.false_alarm, basis_of(task, correction));
  if (has_infinite_sensitivity(observed)) {
    findings.number("dprime", task.key, kUndefined, basis_of(task, "d′"));
  }
  for (const RateEstimate& estimate : kRateEstimates) add(task, estimate, findings);
}

/// d′ of a proportion correct, with Wilson's limits on the scale of d′.
template <class Rule>
void add_choice(const CountedTask& task, const std::string& quantity, const Rule& rule,
                double (Rule::*proportion_to_dprime)(double) const, const std::string& method,
                FindingList& findings) {
  const HitCount& correct = task.counts.signal;
  const double pc = proportion(correct);
  const double dprime = (rule.*proportion_to_dprime)(pc);
  const ConfidenceInterval wilson = wilson_interval(correct, task.confidence);
  const ConfidenceInterval ends{.low = (rule.*proportion_to_dprime)(wilson.low),
                                .high = (rule.*proportion_to_dprime)(wilson.high)};
  Basis basis = basis_of(task, method + "; interval from the Wilson limits");
  if (std::isfinite(ends.low) && std::isfinite(ends.high)) {
    basis.interval = ends;
    basis.confidence = task.confidence;
  }
  findings.number(quantity, task.key, dprime, basis);
  findings.number(quantity + ".lower", task.key, ends.low, basis_of(task, "at the Wilson limit"));
  findings.number(quantity + ".upper", task.key, ends.high, basis_of(task, "at the Wilson limit"));
  if (!std::isfinite(dprime) || dprime <= 0.0) return;
  const double error = std::sqrt(pc * (1.0 - pc) / static_cast<double>(correct.trials));
  findings.number(quantity + ".se", task.key, error / rule.slope(dprime),
                  basis_of(task, method + ", delta method"));
}

void add_proportion(const CountedTask& task, FindingList& findings) {
  findings.number("pc", task.key, proportion(task.counts.signal),
                  basis_of(task, "proportion correct"));
}

using FiniteSensitivity = double (*)(const CountedTask&);

double loglinear_yes_no(const CountedTask& task) {
  return yes_no_sensitivity(loglinear_rates(task.counts))->dprime;
}
double loglinear_two_alternatives(const CountedTask& task) {
  return two_alternative_sensitivity(loglinear_rates(task.counts))->dprime;
}
double loglinear_same_different(const CountedTask& task) {
  return same_different_sensitivity(loglinear_rates(task.counts), DecisionRule::differencing)
      ->dprime;
}
double loglinear_abx(const CountedTask& task) {
  return abx_sensitivity(loglinear_rates(task.counts), DecisionRule::differencing)->dprime;
}

/// With the mean of a guess as a further trial. Like the log-linear correction, to which it is equal with two alternatives,
/// it moves d′ towards 0; an added ½ would move small d′ of more alternatives away from it.
double proportion_with_guess(const HitCount& correct, std::size_t alternatives) {
  return (static_cast<double>(correct.hits) + 1.0 / static_cast<double>(alternatives)) /
         (static_cast<double>(correct.trials) + 1.0);
}
double forced_choice_with_guess(const CountedTask& task) {
  return ForcedChoice{.alternatives = task.alternatives}.dprime(
      proportion_with_guess(task.counts.signal, task.alternatives));
}
double oddity_with_guess(const CountedTask& task) {
  return Oddity{.rule = DecisionRule::differencing}.dprime(
      proportion_with_guess(task.counts.signal, 3));
}

void add_forced_choice(const CountedTask& task, FindingList& findings) {
  add_proportion(task, findings);
  const std::string method =
      "d′ of a choice among " + std::to_string(task.alternatives) + " without bias";
  add_choice(task, "dprime", ForcedChoice{.alternatives = task.alternatives}, &ForcedChoice::dprime,
             method, findings);
  findings.number("dprime.with.guess", task.key, forced_choice_with_guess(task),
                  basis_of(task, method + ", of (correct responses + 1/m)/(trials + 1)"));
}

void add_oddity(const CountedTask& task, FindingList& findings) {
  add_proportion(task, findings);
  add_choice(task, "dprime", Oddity{.rule = DecisionRule::differencing}, &Oddity::dprime,
             "d′ by the differencing rule", findings);
  findings.number(
      "dprime.with.guess", task.key, oddity_with_guess(task),
      basis_of(task, "d′ by the differencing rule, of (correct responses + 1/3)/(trials + 1)"));
  add_choice(task, "dprime.io", Oddity{.rule = DecisionRule::independent}, &Oddity::dprime,
             "d′ by the rule of independent observations", findings);
}

constexpr const char* kLoglinearMean =
    "mean over the participants of d′ with the log-linear correction "
    "(same–different and ABX: differencing rule)";
constexpr const char* kMeanWithGuess =
    "mean over the participants of d′ of (correct responses + 1/m)/(trials + 1), with m "
    "alternatives (oddity: m = 3, differencing rule)";

struct CountedDesign {
  std::string_view name{};
  void (*add)(const CountedTask&, FindingList&) = nullptr;
  bool has_noise = true;  ///< the table states false alarms
  bool states_alternatives = false;
  /// d′ of one participant for the mean over participants, which is finite for every count.
  FiniteSensitivity of_participant = nullptr;
  const char* mean = kLoglinearMean;
};
constexpr std::array kCountedDesigns{
    CountedDesign{"yesno", add_rates<add_yes_no>, true, false, loglinear_yes_no},
    CountedDesign{"2afc", add_rates<add_two_alternatives>, true, false, loglinear_two_alternatives},
    CountedDesign{"mafc", add_forced_choice, false, true, forced_choice_with_guess, kMeanWithGuess},
    CountedDesign{"samediff", add_rates<add_same_different>, true, false, loglinear_same_different},
    CountedDesign{"abx", add_rates<add_abx>, true, false, loglinear_abx},
    CountedDesign{"oddity", add_oddity, false, false, oddity_with_guess, kMeanWithGuess}};

const CountedDesign& counted_design(const TidyTable& table, std::size_t row,
                                    std::string_view name) {
  std::string names{};
  for (const CountedDesign& design : kCountedDesigns) {
    if (design.name == name) return design;
    names += (names.empty() ? "" : ", ") + std::string(design.name);
  }
  table.refuse(row, "design", '"' + std::string(name) + "\" is not a design; use one of " + names);
}

/// Whole numbers, some of which may be missing.
std::optional<std::uint64_t> count_in(const TidyTable& table, std::string_view column,
                                      std::size_t row,
                                      const std::vector<std::optional<double>>& numbers) {
  if (!numbers[row]) return std::nullopt;
  const double number = *numbers[row];
  if (number < 0.0 || number != std::floor(number) ||
      number > static_cast<double>(TidyTable::kMostCounted)) {
    table.refuse(row, column, number_text(number) + " is not a count; write a whole number");
  }
  return static_cast<std::uint64_t>(number);
}

HitCount hits_in(const TidyTable& table, const char* yes_column, std::size_t row,
                 std::optional<std::uint64_t> yes, std::optional<std::uint64_t> trials) {
  if (!yes || !trials || *trials == 0 || *yes > *trials) {
    table.refuse(row, yes_column,
                 "this design needs a number of trials above 0, and at most as many responses; "
                 "state both");
  }
  return {.hits = *yes, .trials = *trials};
}

/// The sensitivities of the participants in one task.
struct SensitivitiesOfTask {
  const char* mean = "";  ///< how their mean is computed
  std::vector<double> of_participants{};
};

void add_mean_sensitivity(const std::string& id, const SensitivitiesOfTask& sensitivities,
                          double confidence, FindingList& findings) {
  const std::vector<double>& of_participants = sensitivities.of_participants;
  const auto mean_of = [&](std::span<const std::size_t> places) -> std::optional<double> {
    double sum = 0.0;
    for (const std::size_t place : places) sum += of_participants[place];
    return sum / static_cast<double>(places.size());
  };
  std::vector<std::size_t> all(of_participants.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const ParticipantBootstrap bootstrap =
      bootstrap_participants({.participants = all.size(), .confidence = confidence}, mean_of);
  Basis basis{.n = all.size(), .method = sensitivities.mean};
  if (bootstrap.interval) {
    basis.method += "; expanded percentiles, bootstrap over participants, " +
                    way_of_counting(bootstrap.draws) + simulated_coverage({91, 95});
    basis.interval = bootstrap.interval;
    basis.confidence = confidence;
  }
  findings.number("dprime.mean", id, *mean_of(all), basis);
}

}  // namespace

std::vector<Finding> dprime_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  const bool has_participants = table.has("subject");
  if (!has_participants) refuse_repeated(table, "id", "one row per count");
  const LabelColumn ids = table.all_labels("id");
  const LabelColumn participants = has_participants ? table.all_labels("subject") : LabelColumn{};
  const std::vector<std::string_view> designs = table.texts("design");
  const std::vector<std::optional<double>> none(table.rows());
  const auto numbers = [&](const char* column) {
    return table.has(column) ? table.numbers(column) : none;
  };
  const auto signal_yes = table.numbers("signal_yes");
  const auto signal_n = table.numbers("signal_n");
  const auto noise_yes = numbers("noise_yes");
  const auto noise_n = numbers("noise_n");
  const auto alternatives = numbers("m");
  const double confidence = input.options.confidence();
  FindingList findings{};
  std::map<std::size_t, SensitivitiesOfTask> by_id{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const CountedDesign& design = counted_design(table, row, designs[row]);
    const std::string& id = ids.names[ids.codes[row]];
    CountedTask task{
        .key = has_participants ? FindingKey{id, participants.names[participants.codes[row]]} : id,
        .confidence = confidence};
    task.counts.signal =
        hits_in(table, "signal_yes", row, count_in(table, "signal_yes", row, signal_yes),
                count_in(table, "signal_n", row, signal_n));
    if (design.has_noise) {
      task.counts.noise = hits_in(table, table.has("noise_yes") ? "noise_yes" : "design", row,
                                  count_in(table, "noise_yes", row, noise_yes),
                                  count_in(table, "noise_n", row, noise_n));
    }
    if (design.states_alternatives) {
      task.alternatives =
          static_cast<std::size_t>(count_in(table, "m", row, alternatives).value_or(0));
      if (task.alternatives < 2) {
        table.refuse(row, table.has("m") ? "m" : "design",
                     "the design mafc needs the number m of alternatives, at least 2");
      }
    }
    design.add(task, findings);
    if (!has_participants) continue;
    SensitivitiesOfTask& sensitivities = by_id[ids.codes[row]];
    sensitivities.mean = design.mean;
    sensitivities.of_participants.push_back(design.of_participant(task));
  }
  for (const auto& [id, sensitivities] : by_id) {
    add_mean_sensitivity(ids.names[id], sensitivities, confidence, findings);
  }
  return findings.take();
}

}  // namespace asperity
