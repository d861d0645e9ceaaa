// Whether two means are equivalent: two one-sided tests and a Bayes factor.

#include "analysis/tests/equivalence.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/effect_size.h"
#include "analysis/tests/t_test.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/findings/tidy/two_groups.h"

namespace asperity {
namespace {

/// The basis of the findings, for every design of the table.
struct MeanComparison {
  std::size_t n = 0;  ///< participants
  std::size_t incomplete = 0;
  double difference = 0.0;
  std::string method{};
  struct Estimate {
    EstimatedDifference difference{};
    double t = 0.0;
    double p = 1.0;
    BayesFactorQuestion pooled{};
  };
  std::optional<Estimate> estimate{};
};

/// A standardised difference with its interval.
struct StandardisedEffect {
  const char* quantity = "";
  std::string method{};
  double value = 0.0;
  std::optional<ConfidenceInterval> interval{};
};

struct ComparedMeans {
  MeanComparison comparison{};
  std::vector<StandardisedEffect> effects{};
};

ComparedMeans one_sample(const std::vector<double>& sample, std::string method, double confidence) {
  ComparedMeans made{.comparison = {.n = sample.size(), .method = std::move(method)}};
  if (sample.empty()) return made;
  const OneSampleT t = one_sample_t(sample);
  made.comparison.difference = t.mean;
  if (!t.test) return made;
  const auto n = static_cast<double>(t.n);
  made.comparison.estimate = {
      .difference = {.value = t.mean, .standard_error = t.test->standard_error, .df = t.test->df},
      .t = t.test->t,
      .p = t.test->p,
      .pooled = {.t = t.test->t, .df = t.test->df, .n = n}};
  const double d = t.mean / *t.sd;
  made.effects = {{"dz", "mean divided by the standard deviation", d,
                   standardised_mean_interval(d, n, confidence)}};
  return made;
}

/// Reads the columns of a design; rows with an empty cell are omitted and counted.
ComparedMeans read_one_sample(const TidyTable& table, double confidence) {
  std::vector<double> sample{};
  std::size_t incomplete = 0;
  const bool is_paired = table.has("a") || table.has("b");
  const std::vector<std::optional<double>> first = table.numbers(is_paired ? "a" : "value");
  const std::vector<std::optional<double>> second =
      is_paired ? table.numbers("b") : std::vector<std::optional<double>>(table.rows(), 0.0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (first[row] && second[row]) {
      sample.push_back(*first[row] - *second[row]);
    } else {
      ++incomplete;
    }
  }
  ComparedMeans made =
      one_sample(sample, is_paired ? "a − b within participants" : "mean, against 0", confidence);
  made.comparison.incomplete = incomplete;
  return made;
}

ComparedMeans read_two_samples(const TidyInput& input, double confidence) {
  const LabelColumn groups = two_groups(input);
  const std::vector<std::optional<double>> values = input.table().numbers("value");
  std::vector<double> first{};
  std::vector<double> second{};
  ComparedMeans made{
      .comparison = {.method = groups.names[0] + " − " + groups.names[1] + ", Welch"}};
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!values[row]) {
      ++made.comparison.incomplete;
    } else {
      (groups.codes[row] == 0 ? first : second).push_back(*values[row]);
    }
  }
  made.comparison.n = first.size() + second.size();
  if (first.empty() || second.empty()) {
    made.comparison.difference = kUndefined;
    return made;
  }
  made.comparison.difference = one_sample_t(first).mean - one_sample_t(second).mean;
  const TwoSamples samples{.first = first, .second = second};
  const std::optional<WelchT> welch = welch_t(samples, confidence);
  if (!welch) return made;
  const auto n = static_cast<double>(made.comparison.n);
  const double effective =
      static_cast<double>(first.size()) * static_cast<double>(second.size()) / n;
  made.comparison.estimate = {
      .difference = {.value = welch->difference,
                     .standard_error = welch->standard_error,
                     .df = welch->df},
      .t = welch->t,
      .p = welch->p,
      .pooled = {.t = welch->d * std::sqrt(effective), .df = n - 2.0, .n = effective}};
  const auto limits = standardised_difference_interval(*welch, samples, confidence);
  made.effects = {
      {"cohen.d", "difference divided by the pooled standard deviation", welch->d, limits},
      {"hedges.g", "d corrected for bias, exact J", welch->g, bias_corrected(*welch, limits)}};
  return made;
}

ComparedMeans compared_means_in(const TidyInput& input) {
  const TidyTable& table = input.table();
  refuse_repeated(table, "subject", "one row per participant");
  const double confidence = input.options.confidence();
  return table.has("group") ? read_two_samples(input, confidence)
                            : read_one_sample(table, confidence);
}

std::optional<EquivalenceBounds> bounds_of(const FamilyOptions& options, double alpha) {
  const std::optional<double> lower = options.number_if("lower");
  const std::optional<double> upper = options.number_if("upper");
  if (lower.has_value() != upper.has_value()) {
    throw std::runtime_error(
        std::string("the option \"") + (lower ? "upper" : "lower") +
        "\" is missing; set both equivalence bounds, \"lower\" and \"upper\", or neither");
  }
  if (!lower) return std::nullopt;
  if (!(*lower < *upper)) {
    throw std::runtime_error("the option \"lower\" is " + number_text(*lower) +
                             " and \"upper\" is " + number_text(*upper) +
                             "; the lower bound must be less than the upper one");
  }
  return EquivalenceBounds{.lower = *lower, .upper = *upper, .alpha = alpha};
}

double alpha_of(const FamilyOptions& options) {
  const double alpha = options.number_or("alpha", 0.05);
  if (alpha > 0.0 && alpha < 0.5) return alpha;
  throw std::runtime_error("the option \"alpha\" is " + number_text(alpha) +
                           "; it must lie between 0 and 0.5");
}

void add_bayes_factors(const MeanComparison& comparison, FindingList& findings) {
  const auto add = [&](const char* key, double scale) {
    BayesFactorQuestion question = comparison.estimate->pooled;
    question.scale = scale;
    findings.number("jzs.bf10", key, jzs_bayes_factor(question),
                    {.n = comparison.n,
                     .method = "JZS Bayes factor for a difference, Cauchy prior of "
                               "scale " +
                               std::string(key) + " on the standardised difference"});
  };
  add("0.7071", std::numbers::sqrt2 / 2.0);
  add("1", 1.0);
}

void add_equivalence(const MeanComparison& comparison,
                     const std::optional<EquivalenceBounds>& bounds, FindingList& findings) {
  const Basis basis{.n = comparison.n,
                    .method = "two one-sided tests (TOST); " + comparison.method};
  if (!bounds) return;
  const EquivalenceTest test = equivalence_test(comparison.estimate->difference, *bounds);
  findings.number("tost.t.lower", "", test.t_lower, basis);
  findings.number("tost.t.upper", "", test.t_upper, basis);
  findings.number("tost.p.lower", "", test.p_lower, basis);
  findings.number("tost.p.upper", "", test.p_upper, basis);
  findings.number("tost.p", "", test.p, basis);
  findings.truth("equivalent", "", test.equivalent, basis);
}

}  // namespace

std::vector<Finding> equivalence_findings(const TidyInput& input) {
  const double alpha = alpha_of(input.options);
  const double confidence = input.options.confidence();
  const std::optional<EquivalenceBounds> bounds = bounds_of(input.options, alpha);
  const ComparedMeans compared = compared_means_in(input);
  const MeanComparison& comparison = compared.comparison;
  FindingList findings{};
  if (comparison.incomplete > 0) {
    findings.count(
        "n.incomplete", "", comparison.incomplete,
        {.n = comparison.incomplete, .method = "rows without a value, which are left out"});
  }
  Basis basis{.n = comparison.n, .method = comparison.method};
  if (comparison.n == 0 || std::isnan(comparison.difference)) {
    findings.word(
        "diff", "", "no_data",
        "a sample has no participant with a value, so that no comparison is possible: add "
        "participants with a value",
        basis);
    return findings.take();
  }
  if (!comparison.estimate) {
    findings.number("diff", "", comparison.difference, basis);
    findings.word("tost.p", "", "undefined_zero_variance",
                  "the standard error of the difference is undefined: a sample has one "
                  "participant, or all participants of each sample have the same value; add "
                  "participants",
                  basis);
    return findings.take();
  }
  const MeanComparison::Estimate& estimate = *comparison.estimate;
  const double half = *t_limit({.confidence = 1.0 - 2.0 * alpha, .df = estimate.difference.df}) *
                      estimate.difference.standard_error;
  const ConfidenceInterval interval{.low = comparison.difference - half,
                                    .high = comparison.difference + half};
  Basis shown = basis;
  shown.interval = interval;
  shown.confidence = 1.0 - 2.0 * alpha;
  findings.number("diff", "", comparison.difference, shown);
  findings.number("se", "", estimate.difference.standard_error, basis);
  findings.number("df", "", estimate.difference.df, basis);
  add_equivalence(comparison, bounds, findings);
  findings.number("ci.lower", "", interval.low, basis);
  findings.number("ci.upper", "", interval.high, basis);
  findings.number("equivalence.margin", "", smallest_equivalence_margin(estimate.difference, alpha),
                  {.n = comparison.n,
                   .method = "smallest Δ for which the test would show equivalence within ±Δ; "
                             "descriptive, without a test"});
  for (const StandardisedEffect& effect : compared.effects) {
    Basis effect_basis{.n = comparison.n,
                       .method = effect.method + "; interval from the noncentral t distribution",
                       .interval = effect.interval};
    if (effect.interval) effect_basis.confidence = confidence;
    findings.number(effect.quantity, "", effect.value, effect_basis);
    if (!effect.interval) continue;
    findings.number(std::string(effect.quantity) + ".ci.lower", "", effect.interval->low,
                    {.n = comparison.n, .method = "noncentral t"});
    findings.number(std::string(effect.quantity) + ".ci.upper", "", effect.interval->high,
                    {.n = comparison.n, .method = "noncentral t"});
  }
  findings.number("t", "", estimate.t, basis);
  findings.number("t.p.two", "", estimate.p, basis);
  add_bayes_factors(comparison, findings);
  return findings.take();
}

}  // namespace asperity
