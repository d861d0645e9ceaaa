// Psychometric functions of conditions: correct responses by level.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/psychometric/psychometric_bootstrap.h"
#include "analysis/psychometric/psychometric_fit.h"
#include "analysis/psychometric/psychometric_maximum.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/psychometric_conditions.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/unforced_estimates.h"

namespace asperity {
namespace {

using Blocks = std::vector<PsychometricBlock>;
using Condition = PsychometricCondition;

PsychometricShape shape_of(const std::string& name) {
  for (const auto& [known, shape] : {std::pair{"logistic", PsychometricShape::logistic},
                                     std::pair{"normal", PsychometricShape::normal},
                                     std::pair{"gumbel", PsychometricShape::gumbel},
                                     std::pair{"weibull", PsychometricShape::weibull}}) {
    if (name == known) return shape;
  }
  throw std::runtime_error("the option \"shape\" is \"" + name +
                           "\"; it must be logistic, normal, gumbel or weibull");
}

std::optional<double> rate_of(const FamilyOptions& options, const std::string& name) {
  if (options.text(name) == "free") return std::nullopt;
  return options.number(name);
}

/// Rejects a performance that the model cannot reach. A rate that is fitted can be 0.
void refuse_unreachable(double performance, const PsychometricModel& model) {
  const double low = model.gamma.value_or(0.0);
  const double high = 1.0 - model.lambda.value_or(0.0);
  if (performance > low && performance < high) return;
  throw std::runtime_error("the option \"pt\" is " + number_text(performance) +
                           "; the performance at the threshold must lie between gamma and 1 - "
                           "lambda, which are " +
                           number_text(low) + " and " + number_text(high) +
                           ". Choose a value between them");
}

PsychometricQuestion question_of(const FamilyOptions& options) {
  const PsychometricQuestion question{
      .model = {.shape = shape_of(options.text("shape")),
                .gamma = rate_of(options, "gamma"),
                .lambda = rate_of(options, "lambda"),
                .greatest_lambda = options.number_or("lambda_max", 0.1)},
      .performance = options.number("pt"),
      .confidence = options.confidence()};
  refuse_unreachable(question.performance, question.model);
  return question;
}

struct Word {
  const char* word = "";
  const char* sentence = "";
};

Word word_of(PsychometricStatus status) {
  switch (status) {
    case PsychometricStatus::ok:
      return {"ok", "ok"};
    case PsychometricStatus::no_data:
      return {"no_data", "no level has trials, so that nothing can be estimated: add trials"};
    case PsychometricStatus::all_correct:
      return {"all_correct", "every response is correct: present weaker stimuli"};
    case PsychometricStatus::all_wrong:
      return {"all_wrong", "every response is incorrect: present stronger stimuli"};
    case PsychometricStatus::one_level:
      return {"one_level", "a slope requires at least two levels with trials: present more levels"};
    case PsychometricStatus::too_few_levels:
      return {"too_few_levels",
              "the function has more parameters than there are levels with trials, so that many "
              "functions fit equally well: present more levels, or fix gamma or lambda"};
    case PsychometricStatus::separated:
      return {"separated",
              "a step function fits perfectly: present levels between those on either side of the "
              "step"};
    case PsychometricStatus::quasi_separated:
      return {"quasi_separated",
              "all levels but one have only correct or only incorrect responses: present levels "
              "nearer to it"};
    case PsychometricStatus::not_increasing:
      return {"not_increasing",
              "the proportion of hits does not rise with the level, so that no threshold exists: "
              "check which responses count as hits and whether the levels increase with the "
              "stimulus, or fit the levels with the opposite sign"};
  }
  return {};
}

std::size_t draws_of(const FamilyOptions& options) {
  constexpr double kDraws = 1000.0;
  constexpr double kMost = 1e6;
  const double draws = options.number_or("bootstrap", kDraws);
  if (draws >= 0.0 && draws <= kMost && draws == std::floor(draws)) {
    return static_cast<std::size_t>(draws);
  }
  throw std::runtime_error("the option \"bootstrap\" is " + number_text(draws) +
                           "; it must be a whole number of draws from 0 (none) to 1000000");
}

constexpr const char* kNoDegreesOfFreedom =
    "the function has as many parameters as there are levels, so that the goodness of fit cannot "
    "be "
    "tested: present more levels";

/// Whether a threshold lies beyond all levels with trials.
bool is_outside_levels(double threshold, const Blocks& blocks) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const PsychometricBlock& block : blocks) {
    if (block.trials == 0) continue;
    lowest = std::min(lowest, block.x);
    highest = std::max(highest, block.x);
  }
  return threshold < lowest || threshold > highest;
}

class PsychometricList final {
 public:
  PsychometricList(PsychometricQuestion question, std::size_t draws)
      : question_(std::move(question)), draws_(draws) {}

  /// The function of a condition with responses "cannot tell".
  void unforced(const Condition& condition) {
    begin(condition);
    PsychometricStatus status = judge(condition.blocks, question_.model).status;
    std::optional<PsychometricMaximum> maximum{};
    if (status == PsychometricStatus::ok) {
      maximum = maximise_psychometric(condition.blocks, question_.model);
      if (!maximum->increases) status = PsychometricStatus::not_increasing;
    }
    const auto [word, sentence] = word_of(status);
    list_.word("status", key_, word, sentence, basis("whether a function can be fitted"));
    if (status != PsychometricStatus::ok) return;
    add_unforced_estimates(condition.unforced, *maximum,
                           {.model = question_.model,
                            .performances = {question_.performance},
                            .confidence = question_.confidence},
                           draws_, {&list_, 1});
    say_where_outside(maximum->function.inverse(question_.performance), condition.blocks);
  }

  /// The fit, where there is one.
  std::optional<PsychometricFit> condition(const Condition& condition) {
    begin(condition);
    const PsychometricJudgement judgement = judge(condition.blocks, question_.model);
    std::optional<PsychometricFit> fit{};
    PsychometricStatus status = judgement.status;
    if (status == PsychometricStatus::ok) {
      fit = fit_psychometric(condition.blocks, question_);
      if (!fit) status = PsychometricStatus::not_increasing;
    }
    const auto [word, sentence] = word_of(status);
    list_.word("status", key_, word, sentence, basis("whether a function can be fitted"));
    if (judgement.bracket) {
      number("threshold.bracket.lower", judgement.bracket->low,
             "the threshold is above this level");
      number("threshold.bracket.upper", judgement.bracket->high,
             "the threshold is below this level");
    }
    if (!fit) return std::nullopt;
    parameters(*fit);
    threshold(*fit, condition.blocks);
    say_where_outside(fit->threshold, condition.blocks);
    overdispersion(*fit, condition.blocks);
    if (fit->free_lapses) lapses(*fit);
    if (draws_ > 0) drawn(condition.blocks, *fit);
    return fit;
  }

  void same_function(const Condition& first, const Condition& second, double separate) {
    Blocks both = first.blocks;
    both.insert(both.end(), second.blocks.begin(), second.blocks.end());
    const double ratio =
        2.0 * (separate - maximise_psychometric(both, question_.model).log_likelihood);
    key_ = {first.name, second.name};
    number("lr.same.function", ratio, "likelihood-ratio statistic against shared α and β");
    number("lr.same.function.p",
           upper_tail(ChiSquaredStatistic{.value = ratio, .df = 2.0}).value_or(kUndefined),
           "χ² test with two degrees of freedom, liberal with few trials: in simulations of equal "
           "functions the Type I error rate at α = .05 was up to 12 %");
  }

  void bootstrap(const Condition& condition,
                 std::span<const std::vector<std::uint64_t>> resamples) {
    const ThresholdBootstrap boot = bootstrap_threshold(condition.blocks, resamples, question_);
    key_ = condition.name;
    const std::string method = "resamples given as a table";
    number("boot.slope.at.bound", static_cast<double>(boot.slopes_at_bound),
           method + ", slope at its bound (included)");
    number("boot.valid", static_cast<double>(boot.valid), method + ", with a threshold");
    constexpr std::size_t kShown = 5;
    for (std::size_t i = 0; i < std::min(kShown, boot.thresholds.size()); ++i) {
      list_.number("boot.threshold", std::to_string(i + 1), boot.thresholds[i].value_or(kUndefined),
                   basis(method + ", one threshold"));
    }
    const ConfidenceInterval none{.low = kUndefined, .high = kUndefined};
    const ConfidenceInterval ends = boot.percentile.value_or(none);
    number("boot.perc.lower", ends.low, method + ", quantile of type 7");
    number("boot.perc.upper", ends.high, method + ", quantile of type 7");
    number("boot.se", boot.standard_error.value_or(kUndefined), method + ", SD of the thresholds");
  }

  std::vector<Finding> take() { return list_.take(); }

 private:
  void begin(const Condition& condition) {
    key_ = condition.name;
    n_ = 0;
    for (const PsychometricBlock& block : condition.blocks) {
      n_ += static_cast<std::size_t>(block.trials);
    }
  }

  Basis basis(std::string method) const { return {.n = n_, .method = std::move(method)}; }
  void number(const char* quantity, double value, std::string method) {
    list_.number(quantity, key_, value, basis(std::move(method)));
  }

  void parameters(const PsychometricFit& fit) {
    const std::string method = "maximum likelihood";
    Basis alpha = basis(method + "; profile interval" + simulated_coverage({93, 100}));
    if (fit.profile_low && fit.profile_high) {
      alpha.interval = ConfidenceInterval{.low = *fit.profile_low, .high = *fit.profile_high};
      alpha.confidence = question_.confidence;
    }
    list_.number("fit.alpha", key_, fit.function.alpha, alpha);
    number("fit.beta", fit.function.beta, method);
    number("fit.gamma", fit.function.gamma, question_.model.gamma ? "fixed" : method);
    number("fit.lambda", fit.function.lambda, question_.model.lambda ? "fixed" : method);
    list_.truth("bound.lambda", key_, fit.lambda_at_bound, basis("whether λ is at its bound"));
    list_.truth("bound.beta", key_, fit.beta_at_bound,
                basis("whether the slope is at its bound: steeper than the levels can resolve"));
    number("loglik", fit.log_likelihood, "binomial coefficients included");
    number("deviance", fit.deviance, "against one proportion per block");
    number("deviance.df", fit.deviance_df, "number of blocks minus number of parameters");
    number("pearson", fit.pearson.value_or(kUndefined), "Pearson's X²");
    Basis test = basis(
        "χ² test of the deviance; indicative only: in simulations of the fitted function the "
        "Type I error rate at α = .05 was up to 8 %");
    test.undefined = kNoDegreesOfFreedom;
    list_.number("deviance.p.chisq", key_, fit.deviance_p.value_or(kUndefined), std::move(test));
  }

  void overdispersion(const PsychometricFit& fit, const Blocks& blocks) {
    number("dispersion", fit.dispersion.value_or(kUndefined),
           "Pearson's X² over its degrees of freedom; near 1 for binomial hits");
    if (!fit.overdispersed) return;
    const std::string method =
        "standard error times √max(1, dispersion), for hits that vary more than binomially";
    number("se.alpha.overdispersed", fit.overdispersed->alpha_se, method);
    number("se.beta.overdispersed", fit.overdispersed->beta_se, method);
    if (is_outside_levels(fit.threshold, blocks)) return;
    number("threshold.se.overdispersed", fit.overdispersed->threshold_se, method);
    const std::string interval = method +
                                 "; t interval with the degrees of freedom of the deviance" +
                                 simulated_coverage({96, 100});
    number("threshold.overdispersed.lower", fit.overdispersed->threshold.low, interval);
    number("threshold.overdispersed.upper", fit.overdispersed->threshold.high, interval);
  }

  /// Lapse rates; intervals treat a fixed λ as known.
  void lapses(const PsychometricFit& fit) {
    const PsychometricFit::FreeLapses& free = *fit.free_lapses;
    const double shift = free.threshold - fit.threshold;
    const double most = std::max(question_.model.greatest_lambda, *question_.model.lambda);
    const std::string method = "λ fitted between 0 and " + number_text(most) + " instead of fixed";
    number("lapse.free.lambda", free.lambda, method);
    number("lapse.free.alpha", free.alpha, method);
    number("lapse.free.threshold", free.threshold, method);
    number("lapse.free.shift", shift, method + "; threshold minus that with the fixed λ");
    number("lapse.free.lr", free.likelihood_ratio,
           method + "; likelihood-ratio statistic against the fixed λ");
    if (!fit.precision) return;
    const bool moves = std::abs(shift) > fit.precision->threshold_se ||
                       std::abs(free.alpha - fit.function.alpha) > fit.precision->alpha_se;
    if (!moves) return;
    list_.word("lapse.status", key_, "sensitive",
               "with lambda fitted instead of fixed, alpha or the threshold moves by more than its "
               "standard error, which the intervals do not take into account: present levels at "
               "which only lapses cause misses, or fit lambda (free)",
               basis(method));
  }

  void drawn(const Blocks& blocks, const PsychometricFit& fit) {
    const ParametricBootstrap boot = parametric_bootstrap(blocks, fit, question_, draws_);
    const std::string method = "parametric bootstrap, " + way_of_counting(draws_);
    const ThresholdBootstrap& thresholds = boot.thresholds;
    Basis test = basis("Monte Carlo test of the deviance, " + way_of_counting(draws_));
    test.undefined = kNoDegreesOfFreedom;
    list_.number("deviance.p.montecarlo", key_, boot.deviance_p.value_or(kUndefined),
                 std::move(test));
    if (is_outside_levels(fit.threshold, blocks)) return;
    number("bootstrap.valid", static_cast<double>(thresholds.valid), method + ", with a threshold");
    number("bootstrap.slope.at.bound", static_cast<double>(thresholds.slopes_at_bound),
           method + ", slope at its bound (included)");
    number("bootstrap.threshold.se", thresholds.standard_error.value_or(kUndefined),
           method + ", SD of the thresholds");
    const ConfidenceInterval none{.low = kUndefined, .high = kUndefined};
    const ConfidenceInterval ends = thresholds.percentile.value_or(none);
    const std::string percentile = method + ", percentile interval" + simulated_coverage({87, 94});
    number("bootstrap.threshold.lower", ends.low, percentile);
    number("bootstrap.threshold.upper", ends.high, percentile);
  }

  /// A threshold outside the levels has no interval and no standard error: it depends on the form of the function.
  void threshold(const PsychometricFit& fit, const Blocks& blocks) {
    const bool is_outside = is_outside_levels(fit.threshold, blocks);
    if (fit.beta_at_bound) {
      number("threshold", fit.threshold, "x at the requested performance; slope at its bound");
      return;
    }
    Basis estimate = basis(is_outside ? "x at the requested performance; outside the tested levels"
                                      : "x at the requested performance; delta interval" +
                                            simulated_coverage({92, 100}));
    estimate.undefined =
        "the fitted function does not take the value pt: its gamma or lambda is too large; choose "
        "another pt, or fix gamma and lambda";
    if (fit.precision && !is_outside) {
      estimate.interval = fit.precision->threshold;
      estimate.confidence = question_.confidence;
    }
    list_.number("threshold", key_, fit.threshold, estimate);
    if (fit.precision) {
      number("se.alpha", fit.precision->alpha_se, "observed information");
      number("se.beta", fit.precision->beta_se, "observed information");
      if (!is_outside) {
        number("threshold.se", fit.precision->threshold_se, "delta method");
        number("threshold.delta.lower", fit.precision->threshold.low, "delta interval");
        number("threshold.delta.upper", fit.precision->threshold.high, "delta interval");
      }
      profile_end("alpha.profile.lower", fit.profile_low, "smaller");
      profile_end("alpha.profile.upper", fit.profile_high, "larger");
    } else {
      list_.word("se.alpha", key_, "undefined_singular_information",
                 "the likelihood is flat at its maximum: present other levels",
                 basis("observed information"));
    }
    number("slope.at.threshold", fit.function.slope(fit.threshold), "dψ/dx");
    const PsychometricShape shape = fit.function.shape;
    const bool symmetric =
        shape == PsychometricShape::logistic || shape == PsychometricShape::normal;
    if (symmetric && fit.function.gamma == 0.0) {
      // The threshold of F, without lapses.
      const PsychometricFunction plain{
          .shape = shape, .alpha = fit.function.alpha, .beta = fit.function.beta};
      number("jnd", 0.5 * (plain.inverse(0.75) - plain.inverse(0.25)), "(x75 − x25)/2 of F");
    }
  }

  void profile_end(const char* quantity, const std::optional<double>& end, const char* side) {
    if (end) {
      number(quantity, *end, "profile interval");
      return;
    }
    list_.word(quantity, key_, "unbounded",
               std::string("the likelihood-ratio test does not reject any ") + side +
                   " alpha: a function that is constant over the levels fits nearly "
                   "as well; present more trials, or levels on both sides of the threshold",
               basis("profile interval"));
  }

  /// A threshold beyond all tested levels depends on the form of the function alone.
  void say_where_outside(double threshold, const Blocks& blocks) {
    if (!is_outside_levels(threshold, blocks)) return;
    list_.word("threshold.status", key_, "outside_range",
               "the threshold is outside the tested levels and depends on the form of the function "
               "alone: present levels around it",
               basis("whether the tested levels include the threshold"));
  }

  PsychometricQuestion question_{};
  std::size_t draws_ = 0;
  FindingList list_{};
  FindingKey key_{};
  std::size_t n_ = 0;
};

/// Rows of counts, one column per block of the first condition after the column `b`.
std::vector<std::vector<std::uint64_t>> read_resampled_hits(const TidyTable& table,
                                                            std::size_t blocks) {
  std::vector<std::vector<std::uint64_t>> rows(table.rows());
  for (std::size_t block = 1; block <= blocks; ++block) {
    const std::vector<std::uint64_t> column = table.counts('k' + std::to_string(block));
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].push_back(column[row]);
  }
  return rows;
}

}  // namespace

std::vector<Finding> psyfit_findings(const TidyInput& input) {
  const PsychometricQuestion question = question_of(input.options);
  const std::vector<Condition> conditions = psychometric_conditions(input.table(), question.model);
  PsychometricList list(question, draws_of(input.options));
  std::vector<const Condition*> fitted{};
  double separate = 0.0;
  for (const Condition& condition : conditions) {
    if (has_unsure(condition.unforced)) {
      list.unforced(condition);
      continue;
    }
    if (const std::optional<PsychometricFit> fit = list.condition(condition)) {
      fitted.push_back(&condition);
      separate += fit->log_likelihood;
    }
  }
  if (fitted.size() == 2 && question.model.gamma && question.model.lambda) {
    list.same_function(*fitted[0], *fitted[1], separate);
  }
  const bool has_resamples = input.tables.size() > 1;
  if (has_resamples && !conditions.empty() && !fitted.empty() &&
      fitted.front() == &conditions.front()) {
    list.bootstrap(conditions.front(),
                   read_resampled_hits(input.table(1), conditions.front().blocks.size()));
  }
  return list.take();
}

}  // namespace asperity
