// Chooses the fit by design, procedure and responses “cannot tell”, and reports thresholds within the presented levels.

#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/psychometric/psychometric_fit.h"
#include "analysis/psychometric/psychometric_function.h"
#include "analysis/psychometric/psychometric_maximum.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/detection_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_posterior.h"
#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"
#include "app/findings/methods/discrimination/thresholds/unforced_functions.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kFunctions = "psychometric";
constexpr QuantityName kSlope = "slope";
constexpr QuantityName kJnd = "jnd";
constexpr double kThresholdConfidence = 0.95;
constexpr double kNormalQuantile = 1.959963984540054;  // of 97.5 %
constexpr double kQuartileOfNormal = 0.6744897501960817;

bool is_slope_at_bound(const FoundNumbers& found, const FindingKey& key) {
  const Finding* const at_bound = found.find("bound.beta", key);
  return at_bound != nullptr && at_bound->word == "TRUE";
}

/// The smallest and the greatest x with trials.
std::pair<double, double> presented_range(const DiscriminationTask& task, const HitsByValue& hits) {
  std::optional<std::pair<double, double>> range{};
  for (const auto& [value, count] : hits) {
    if (count.trials == 0) continue;
    const double x = task.is_performance ? std::abs(value - task.standard()) : value;
    if (!range) range.emplace(x, x);
    range->first = std::min(range->first, x);
    range->second = std::max(range->second, x);
  }
  return range.value_or(std::pair{0.0, 0.0});
}

std::size_t trials_in(const HitsByValue& hits) {
  std::size_t trials = 0;
  for (const auto& [value, count] : hits) trials += static_cast<std::size_t>(count.trials);
  return trials;
}

/// Collects the thresholds of one function after another.
class ThresholdList final {
 public:
  explicit ThresholdList(const DiscriminationTask& task) : task_(task) {}

  void begin(const DiscriminationData& data) {
    key_ = data.key;
    n_ = trials_in(data.hits);
    std::tie(lowest_, highest_) = presented_range(task_, data.hits);
  }

  bool is_presented(double x) const { return x >= lowest_ && x <= highest_; }
  WhyNoThreshold outside(double x) const {
    return x > highest_ ? threshold_above_levels() : threshold_below_levels();
  }

  void none(QuantityName quantity, const WhyNoThreshold& why) {
    list_.word(quantity, key_, why.word, why.sentence.english(), basis("", ""));
    const bool is_known =
        std::find(reasons_.begin(), reasons_.end(), why.sentence) != reasons_.end();
    if (!is_known && quantity != kSlope) {
      reasons_.push_back(why.sentence);
    }
  }

  void number(QuantityName quantity, double value, Basis basis) {
    list_.number(quantity, key_, value, std::move(basis));
  }

  /// The just-noticeable difference and, with a standard, the Weber fraction.
  void difference(QuantityName quantity, double value, const Basis& estimate) {
    number(quantity, value, estimate);
    if (quantity != kJnd || task_.standard() == 0.0) return;
    const double standard = std::abs(task_.standard());
    Basis fraction = basis_in_standards(estimate, standard);
    fraction.method = "just-noticeable difference divided by the standard; " + estimate.method;
    number("weber", value / standard, fraction);
  }

  void no_difference(const WhyNoThreshold& why) {
    none("jnd", why);
    if (task_.standard() != 0.0) none("weber", why);
  }

  void repetitions(const std::optional<ProcedureBootstrap>& repeated) {
    if (!repeated) return;
    number("without", static_cast<double>(repeated->without),
           {.n = repeated->repetitions,
            .method = "repetitions of the procedure in which there is no threshold"});
  }

  void unfinished(const std::optional<PlacedTrials>& placed) {
    const std::size_t tracks = placed ? placed->unfinished_tracks() : 0;
    if (tracks == 0) return;
    number(
        "unfinished.tracks", static_cast<double>(tracks),
        {.n = placed->tracks.size(),
         .method = "tracks that were begun and whose session ended before the procedure stopped"});
  }

  Basis basis(std::string method, const std::string& unit) const {
    return {.n = n_, .method = std::move(method), .unit = unit.empty() ? "1" : unit};
  }

  /// With the interval of `bootstrap_unforced`, if there is one.
  static Basis with_resamples(Basis basis, std::optional<double> low, std::optional<double> high);

  const FindingKey& key() const { return key_; }
  std::vector<Finding> take() { return list_.take(); }
  std::vector<Phrase> take_reasons() { return std::move(reasons_); }

 private:
  const DiscriminationTask& task_;
  FindingList list_{};
  std::vector<Phrase> reasons_{};  ///< each once; not those of slopes, which are in no table
  FindingKey key_{};
  std::size_t n_ = 0;
  double lowest_ = 0.0;
  double highest_ = 0.0;
};

Basis with_interval(Basis basis, double low, double high) {
  basis.interval = ConfidenceInterval{.low = low, .high = high};
  basis.confidence = kThresholdConfidence;
  return basis;
}

Basis ThresholdList::with_resamples(Basis basis, std::optional<double> low,
                                    std::optional<double> high) {
  basis.method +=
      "; each response \"cannot tell\" as the mean of a guess; bootstrap percentile "
      "interval, the three outcomes of each level resampled " +
      std::to_string(kUnforcedResamples) + " times (seed 1)";
  return low && high ? with_interval(std::move(basis), *low, *high) : basis;
}

std::string unit_of_slope(const std::string& unit) { return unit.empty() ? "1" : "1/" + unit; }

/// Completes the method by how the interval was found; with the interval, where there is one.
Basis with_repeated_procedure(Basis basis, const std::optional<ProcedureBootstrap>& repeated,
                              std::optional<ConfidenceInterval> ProcedureBootstrap::*of) {
  if (!repeated) {
    basis.method += "; no interval: the procedure cannot be repeated";
    return basis;
  }
  basis.method +=
      "; likelihood-ratio interval, its critical value bootstrapped by running the procedure "
      "again: " +
      std::to_string(repeated->repetitions) + " repetitions (seed 1), in " +
      std::to_string(repeated->without) + " of them no threshold";
  const std::optional<ConfidenceInterval>& interval = (*repeated).*of;
  return interval ? with_interval(std::move(basis), interval->low, interval->high) : basis;
}

/// Repeats the procedure of the data, where there is one.
std::optional<ProcedureBootstrap> repeated_procedure(const DiscriminationTask& task,
                                                     const DiscriminationData& data,
                                                     double proportion_of_hits) {
  if (!data.placed) return std::nullopt;
  return procedure_interval(task, psychometric_blocks(task, data.hits), *data.placed,
                            proportion_of_hits);
}

/// Whether psi or QUEST+ placed the trials.
bool has_prior(const DiscriminationData& data) {
  return data.placed && common_prior(*data.placed).has_value();
}

/// The difference at a proportion correct, from the findings of the fit with this proportion.
void add_performance(const DiscriminationTask& task, const DiscriminationData& data,
                     QuantityName quantity, double proportion_of_hits, const FoundNumbers& found,
                     ThresholdList& list) {
  const Finding* const threshold = found.find("threshold", list.key());
  if (threshold == nullptr || !threshold->value) {
    const WhyNoThreshold why = why_not_fitted(task, found.find("status", list.key()));
    if (quantity == kJnd) return list.no_difference(why);
    return list.none(quantity, why);
  }
  if (!list.is_presented(*threshold->value)) {
    const WhyNoThreshold why = list.outside(*threshold->value);
    if (quantity == kJnd) return list.no_difference(why);
    return list.none(quantity, why);
  }
  Basis estimate = list.basis(
      "Weibull function of the difference from the standard, maximum likelihood", task.varied.unit);
  if (data.by_procedure) {
    estimate.method += ", slope between " + number_text(kSlopesOfProcedures.least) + " and " +
                       number_text(kSlopesOfProcedures.greatest);
    if (has_prior(data)) {
      // Running psi 500 times takes some ten seconds, and its posterior distribution has an interval.
      estimate.method += "; no interval: that of the posterior distribution is reported";
    } else {
      const auto repeated = repeated_procedure(task, data, proportion_of_hits);
      estimate = with_repeated_procedure(estimate, repeated, &ProcedureBootstrap::threshold);
      if (quantity == kJnd) list.repetitions(repeated);
    }
  } else if (has_unsure(data)) {
    estimate = list.with_resamples(std::move(estimate), threshold->low, threshold->high);
  } else {
    estimate.method += "; delta interval, truncated at 0";
    if (threshold->low && threshold->high) {
      estimate = with_interval(estimate, *threshold->low, *threshold->high);
    }
  }
  list.difference(quantity, *threshold->value, estimate);
}

/// The posterior distribution of the difference at the threshold, where psi or QUEST+ placed the trials.
void add_posterior(const DiscriminationTask& task, const DiscriminationData& data,
                   ThresholdList& list) {
  if (!task.is_performance || !data.placed) return;
  const std::optional<ThresholdPrior> prior = common_prior(*data.placed);
  if (!prior) return;
  const CredibleThreshold threshold = posterior_threshold(
      *prior, psychometric_blocks(task, data.hits), proportion_at_threshold(*task.design));
  if (threshold.at_ends > kMostAtEndsOfPrior) {
    return list.none("jnd.posterior", threshold_at_end_of_prior());
  }
  list.number("jnd.posterior", threshold.value,
              with_interval(list.basis("posterior mean on the logarithmic scale, with the prior "
                                       "of the procedure; credible interval of equal tails",
                                       task.varied.unit),
                            threshold.interval.low, threshold.interval.high));
}

/// x at the lower and the upper quartile, and their half distance.
void add_comparison(const DiscriminationTask& task, const DiscriminationData& data,
                    const FoundNumbers& found, ThresholdList& list) {
  const FindingKey& key = list.key();
  const auto alpha = found.value("fit.alpha", key);
  const auto beta = found.value("fit.beta", key);
  if (!alpha || !beta) {
    const WhyNoThreshold why = why_not_fitted(task, found.find("status", key));
    list.none("pse", why);
    return list.no_difference(why);
  }
  const std::string method = "cumulative normal function of the parameter, maximum likelihood";
  const Finding* const threshold = found.find("threshold", key);
  std::optional<ProcedureBootstrap> repeated{};
  if (data.by_procedure) {
    repeated = repeated_procedure(task, data, 0.5);
    list.repetitions(repeated);
  }
  if (!list.is_presented(*alpha)) {
    list.none("pse", equality_outside_levels());
  } else if (data.by_procedure) {
    list.number("pse", *alpha,
                with_repeated_procedure(list.basis(method, task.varied.unit), repeated,
                                        &ProcedureBootstrap::threshold));
  } else if (has_unsure(data)) {
    list.number("pse", *alpha,
                threshold == nullptr ? list.basis(method, task.varied.unit)
                                     : list.with_resamples(list.basis(method, task.varied.unit),
                                                           threshold->low, threshold->high));
  } else {
    Basis estimate = list.basis(method + "; delta interval", task.varied.unit);
    if (threshold != nullptr && threshold->low && threshold->high) {
      estimate = with_interval(estimate, *threshold->low, *threshold->high);
    }
    list.number("pse", *alpha, estimate);
  }
  const double jnd = kQuartileOfNormal / *beta;
  if (is_slope_at_bound(found, key)) return list.no_difference(slope_at_bound());
  if (!list.is_presented(*alpha - jnd) || !list.is_presented(*alpha + jnd)) {
    return list.no_difference(quartiles_outside_levels());
  }
  if (data.by_procedure) {
    Basis estimate =
        with_repeated_procedure(list.basis("½(x75 − x25) of the " + method, task.varied.unit),
                                repeated, &ProcedureBootstrap::slope);
    if (estimate.interval) {
      estimate.interval = ConfidenceInterval{.low = kQuartileOfNormal / estimate.interval->high,
                                             .high = kQuartileOfNormal / estimate.interval->low};
    }
    return list.difference("jnd", jnd, estimate);
  }
  if (has_unsure(data)) {
    const Finding* const slope = found.find("fit.beta", key);
    Basis estimate = list.basis("½(x75 − x25) of the " + method, task.varied.unit);
    if (slope != nullptr && slope->low && slope->high) {
      estimate = list.with_resamples(std::move(estimate), kQuartileOfNormal / *slope->high,
                                     kQuartileOfNormal / *slope->low);
    }
    return list.difference("jnd", jnd, estimate);
  }
  Basis estimate = list.basis("½(x75 − x25) of the " + method + "; delta interval of its logarithm",
                              task.varied.unit);
  if (const auto error = found.value("se.beta", key)) {
    const double factor = std::exp(kNormalQuantile * *error / *beta);
    estimate = with_interval(estimate, jnd / factor, jnd * factor);
  }
  list.difference("jnd", jnd, estimate);
}

/// The slope at the threshold, where the threshold is within the presented levels.
void add_slope(const DiscriminationTask& task, const DiscriminationData& data,
               const FoundNumbers& found, ThresholdList& list) {
  const auto threshold =
      found.value(task.is_performance ? QuantityName("threshold") : "fit.alpha", list.key());
  const WhyNoThreshold not_fitted = why_not_fitted(task, found.find("status", list.key()));
  if (!threshold) return list.none(kSlope, not_fitted);
  if (!list.is_presented(*threshold)) {
    return list.none(kSlope,
                     task.is_performance ? list.outside(*threshold) : equality_outside_levels());
  }
  if (is_slope_at_bound(found, list.key())) {
    return list.none(
        kSlope, task.is_performance && data.by_procedure ? slope_at_limit() : slope_at_bound());
  }
  const auto slope = found.value("slope.at.threshold", list.key());
  if (!slope) return list.none(kSlope, not_fitted);
  list.number(kSlope, *slope,
              list.basis("slope dψ/dx at the threshold", unit_of_slope(task.varied.unit)));
}

/// The functions of data whose levels did not depend on the responses, and of comparisons.
std::vector<Finding> family_functions(const DiscriminationTask& task,
                                      std::span<const DiscriminationData> data,
                                      double performance) {
  TidyInput input = psychometric_input(task, data, performance);
  std::vector<Finding> findings = analysis_of(kFunctions, "psyfit", std::move(input));
  // A comparison of two of these functions is not part of the study's tests.
  std::erase_if(findings, [](const Finding& finding) {
    return finding.quantity.starts_with("lr.same.function");
  });
  return findings;
}

/// A Weibull function with limited slope, under the names of the family `psyfit`.
void add_limited_function(const DiscriminationTask& task, const DiscriminationData& data,
                          double performance, FindingList& list) {
  PsychometricModel model = psychometric_model(task);
  model.slope = kSlopesOfProcedures;
  const std::string method = "maximum likelihood, slope between " +
                             number_text(kSlopesOfProcedures.least) + " and " +
                             number_text(kSlopesOfProcedures.greatest);
  const Basis basis{.n = trials_in(data.hits), .method = method};
  const std::vector<PsychometricBlock> blocks = psychometric_blocks(task, data.hits);
  const auto none = [&](const char* word, const char* sentence) {
    list.word("status", data.key, word, sentence, basis);
  };
  if (!add_fit_status(blocks, model, data.key, basis, list)) return;
  const PsychometricMaximum maximum = maximise_psychometric(blocks, model);
  if (!maximum.increases) {
    return none("not_increasing",
                "the proportion of hits does not rise with the level: check the responses");
  }
  none("ok", "ok");
  const PsychometricFunction& f = maximum.function;
  constexpr double kNearLimit = 1e-4;
  const bool is_at_limit = f.beta < (1.0 + kNearLimit) * kSlopesOfProcedures.least ||
                           f.beta > (1.0 - kNearLimit) * kSlopesOfProcedures.greatest;
  const double free_parameters = is_at_limit ? 2.0 : 3.0;
  const double df = static_cast<double>(blocks.size()) - free_parameters;
  list.number("fit.alpha", data.key, f.alpha, basis);
  list.number("fit.beta", data.key, f.beta, basis);
  list.number("fit.gamma", data.key, f.gamma, {.n = basis.n, .method = "fixed"});
  list.number("fit.lambda", data.key, f.lambda, basis);
  list.truth("bound.beta", data.key, is_at_limit,
             {.n = basis.n, .method = "whether the slope is at one of its limits"});
  list.number("loglik", data.key, maximum.log_likelihood,
              {.n = basis.n, .method = "binomial coefficients included"});
  if (!has_unsure(data)) {  // split counts are not binomial
    list.number("deviance", data.key, maximum.deviance,
                {.n = basis.n, .method = "against one proportion per level"});
    list.number("deviance.df", data.key, df,
                {.n = basis.n, .method = "number of levels minus number of parameters"});
    list.number(
        "deviance.p.chisq", data.key,
        upper_tail(ChiSquaredStatistic{.value = maximum.deviance, .df = df}).value_or(kUndefined),
        {.n = basis.n, .method = "χ² test of the deviance; indicative only"});
  }
  const double threshold = f.inverse(performance);
  list.number("threshold", data.key, threshold, basis);
  list.number("slope.at.threshold", data.key, f.slope(threshold),
              {.n = basis.n, .method = "dψ/dx"});
}

/// By proportion of hits.
std::vector<std::vector<Finding>> functions_at(const DiscriminationTask& task,
                                               std::span<const DiscriminationData> data,
                                               std::span<const double> performances) {
  std::vector<DiscriminationData> of_family{};
  std::vector<FindingList> limited(performances.size());
  for (const DiscriminationData& one : data) {
    if (task.is_performance && one.by_procedure) {
      for (std::size_t i = 0; i < performances.size(); ++i) {
        add_limited_function(task, one, performances[i], limited[i]);
      }
    } else if (has_unsure(one)) {
      add_unforced_function(task, one, performances, limited);
    } else {
      of_family.push_back({.key = one.key, .hits = one.hits});
    }
  }
  const std::string unit = task.varied.unit.empty() ? "1" : task.varied.unit;
  std::vector<std::vector<Finding>> functions(performances.size());
  for (std::size_t i = 0; i < performances.size(); ++i) {
    std::vector<Finding>& findings = functions[i];
    if (!of_family.empty()) findings = family_functions(task, of_family, performances[i]);
    for (Finding& finding : limited[i].take()) {
      finding.analysis = kFunctions;
      findings.push_back(std::move(finding));
    }
    for (Finding& finding : findings) {
      if (is(finding, "fit.alpha") || is(finding, "threshold")) finding.unit = unit;
    }
  }
  return functions;
}

/// Figures draw the function of a design by its id.
void add_design(const DiscriminationTask& task, std::span<const DiscriminationData> data,
                std::vector<Finding>& functions) {
  FindingList list{};
  for (const DiscriminationData& one : data) {
    list.word("fit.design", one.key, std::string(task.design->id), "ok",
              {.n = trials_in(one.hits), .method = "the design of the task", .unit = "1"});
  }
  for (Finding& finding : list.take()) {
    finding.analysis = kFunctions;
    functions.push_back(std::move(finding));
  }
}

}  // namespace

double proportion_at_threshold(const DiscriminationDesign& design) {
  return 0.5 * (1.0 + design.guess_rate());
}

double proportion_at_unit_sensitivity(const DiscriminationDesign& design) {
  if (!design.is_choice_of_three()) return kProportionAtUnitSensitivity;
  return design.asks_for_odd_one ? Oddity{.rule = DecisionRule::differencing}.proportion(1.0)
                                 : ForcedChoice{.alternatives = design.surfaces()}.share(1.0);
}

std::vector<UnforcedBlock> unforced_blocks(const DiscriminationTask& task,
                                           const HitsByValue& hits) {
  std::map<double, UnforcedBlock> by_x{};
  for (const auto& [value, count] : hits) {
    const double x = task.is_performance ? std::abs(value - task.standard()) : value;
    UnforcedBlock& block = by_x[x];
    block.x = x;
    block.hits += count.hits;
    block.unsure += count.unsure;
    block.misses += count.trials - count.hits - count.unsure;
  }
  std::vector<UnforcedBlock> blocks{};
  for (const auto& [x, block] : by_x) blocks.push_back(block);
  return blocks;
}

std::vector<PsychometricBlock> psychometric_blocks(const DiscriminationTask& task,
                                                   const HitsByValue& hits) {
  // A design whose responses are words has no alternatives, and no response "cannot tell".
  const std::size_t alternatives = std::max<std::size_t>(task.design->alternatives(), 1);
  std::vector<PsychometricBlock> blocks{};
  for (const UnforcedBlock& block : unforced_blocks(task, hits)) {
    blocks.push_back(split_block(block, alternatives));
  }
  return blocks;
}

Basis basis_in_standards(Basis estimate, double standard) {
  estimate.unit = "1";
  if (estimate.interval) {
    estimate.interval->low /= standard;
    estimate.interval->high /= standard;
  }
  return estimate;
}

PsychometricModel psychometric_model(const DiscriminationTask& task) {
  if (!task.is_performance) {
    return {.shape = PsychometricShape::normal,
            .gamma = kSymmetricLapseRate,
            .lambda = kSymmetricLapseRate};
  }
  return {.shape = PsychometricShape::weibull,
          .gamma = task.design->guess_rate(),
          .lambda = std::nullopt,
          .greatest_lambda = kGreatestLapseRate};
}

TidyInput psychometric_input(const DiscriminationTask& task,
                             std::span<const DiscriminationData> data, double proportion_of_hits) {
  TidyInput input{};
  LabelRows conditions{};
  NumberColumn levels{};
  NumberColumn trials{};
  NumberColumn hits{};
  for (const DiscriminationData& one : data) {
    for (const PsychometricBlock& block : psychometric_blocks(task, one.hits)) {
      conditions.add(input.label_of(one.key));
      levels.push_back(block.x);
      trials.push_back(static_cast<double>(block.trials));
      hits.push_back(static_cast<double>(block.hits));
    }
  }
  input.tables.emplace_back(
      std::vector<TidyTable::Column>{{"condition", std::move(conditions).take()},
                                     {"x", std::move(levels)},
                                     {"n", std::move(trials)},
                                     {"k", std::move(hits)}},
      "the responses");
  input.options.set("bootstrap", 0.0);
  input.options.set("pt", proportion_of_hits);
  const PsychometricModel model = psychometric_model(task);
  input.options.set("shape", std::string(task.is_performance ? "weibull" : "normal"));
  input.options.set("gamma", *model.gamma);
  if (model.lambda) {
    input.options.set("lambda", *model.lambda);
  } else {
    input.options.set("lambda", std::string("free"));
    input.options.set("lambda_max", model.greatest_lambda);
  }
  return input;
}

DiscriminationFit fit_discrimination(const DiscriminationTask& task,
                                     std::span<const DiscriminationData> data) {
  DiscriminationFit fit{};
  if (data.empty()) return fit;
  if (task.design->has_noise()) return fit_detections(task, data);
  const double at_threshold = proportion_at_threshold(*task.design);
  const double at_unit = proportion_at_unit_sensitivity(*task.design);
  std::vector<double> performances{task.is_performance ? at_threshold : 0.5};
  if (task.is_performance) performances.push_back(at_unit);
  const std::vector<std::vector<Finding>> functions = functions_at(task, data, performances);
  fit.functions = functions.front();
  if (task.design->is_choice_of_three()) add_design(task, data, fit.functions);
  const FoundNumbers found(fit.functions);
  const FoundNumbers found_at_unit(functions.back());
  ThresholdList list(task);
  for (const DiscriminationData& one : data) {
    list.begin(one);
    list.number("standard", task.standard(),
                list.basis("value of the parameter in the standard", task.varied.unit));
    list.unfinished(one.placed);
    if (task.is_performance) {
      add_performance(task, one, "jnd", at_threshold, found, list);
      add_performance(task, one, "jnd.dprime1", at_unit, found_at_unit, list);
      add_posterior(task, one, list);
    } else {
      add_comparison(task, one, found, list);
    }
    add_slope(task, one, found, list);
  }
  fit.thresholds = list.take();
  fit.reasons = list.take_reasons();
  for (Finding& finding : fit.thresholds) finding.analysis = "thresholds";
  return fit;
}

}  // namespace asperity
