// t tests, in two passes over the numbers.

#include "analysis/tests/t_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/summary.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

// Equal numbers must have no spread at all, whatever rounding does to their mean or did to them:
// 0.3 − 0.2 and 0.4 − 0.3 are the same difference.
double spread_of(std::span<const double> sample) {
  const Summary summary = *summary_of(sample);
  const double greatest = std::max(std::abs(summary.minimum), std::abs(summary.maximum));
  constexpr double kRounding = 10.0 * std::numeric_limits<double>::epsilon();
  return summary.maximum - summary.minimum <= kRounding * greatest ? 0.0 : summary.sd;
}

}  // namespace

OneSampleT one_sample_t(std::span<const double> sample, const OneSampleQuestion& question) {
  const std::optional<Summary> summary = summary_of(sample);
  if (!summary) {
    throw std::invalid_argument("sample is empty; a mean needs at least one value");
  }
  OneSampleT answer{.n = summary->n, .mean = summary->mean};
  if (answer.n < 2) {
    return answer;
  }
  answer.sd = spread_of(sample);
  if (*answer.sd > 0.0) {
    OneSampleT::Test test;
    const auto n = static_cast<double>(answer.n);
    test.standard_error = *answer.sd / std::sqrt(n);
    test.df = n - 1.0;
    test.t = (answer.mean - question.null_mean) / test.standard_error;
    test.p = *two_sided_tail(TStatistic{.value = test.t, .df = test.df});
    const double half =
        *t_limit({.confidence = question.confidence, .df = test.df}) * test.standard_error;
    test.interval = {.low = answer.mean - half, .high = answer.mean + half};
    answer.test = test;
  }
  return answer;
}

std::optional<WelchT> welch_t(const TwoSamples& samples, double confidence) {
  if (samples.first.size() < 2 || samples.second.size() < 2) {
    return std::nullopt;
  }
  const double spread_1 = spread_of(samples.first);
  const double spread_2 = spread_of(samples.second);
  if (spread_1 + spread_2 == 0.0) {
    return std::nullopt;
  }
  const auto n1 = static_cast<double>(samples.first.size());
  const auto n2 = static_cast<double>(samples.second.size());
  const double difference = summary_of(samples.first)->mean - summary_of(samples.second)->mean;
  const double v1 = spread_1 * spread_1 / n1;
  const double v2 = spread_2 * spread_2 / n2;
  const double f = n1 + n2 - 2.0;
  const double pooled =
      std::sqrt(((n1 - 1.0) * spread_1 * spread_1 + (n2 - 1.0) * spread_2 * spread_2) / f);
  WelchT answer;
  answer.difference = difference;
  answer.standard_error = std::sqrt(v1 + v2);
  answer.t = difference / answer.standard_error;
  answer.df = (v1 + v2) * (v1 + v2) / (v1 * v1 / (n1 - 1.0) + v2 * v2 / (n2 - 1.0));
  answer.p = *two_sided_tail(TStatistic{.value = answer.t, .df = answer.df});
  const double half = *t_limit({.confidence = confidence, .df = answer.df}) * answer.standard_error;
  answer.interval = {.low = difference - half, .high = difference + half};
  answer.d = difference / pooled;
  answer.bias_correction =
      std::exp(std::lgamma(0.5 * f) - std::lgamma(0.5 * (f - 1.0))) / std::sqrt(0.5 * f);
  answer.g = answer.d * answer.bias_correction;
  return answer;
}

}  // namespace asperity
