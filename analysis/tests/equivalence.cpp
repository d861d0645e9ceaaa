// Two one-sided tests, and a trapezoidal sum.

#include "analysis/tests/equivalence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

void refuse_unless_positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(std::string(name) + " is " + number_text(value) +
                                "; it must be a positive number");
  }
}

ConfidenceInterval interval_of(const EstimatedDifference& difference, double alpha) {
  refuse_unless_positive(difference.standard_error, "standard error");
  refuse_unless_positive(difference.df, "df");
  if (!(alpha > 0.0 && alpha < 0.5)) {
    throw std::invalid_argument("alpha is " + number_text(alpha) +
                                "; it must lie between 0 and 0.5");
  }
  const double half =
      *t_limit({.confidence = 1.0 - 2.0 * alpha, .df = difference.df}) * difference.standard_error;
  return {.low = difference.value - half, .high = difference.value + half};
}

}  // namespace

EquivalenceTest equivalence_test(const EstimatedDifference& difference,
                                 const EquivalenceBounds& bounds) {
  EquivalenceTest test{.interval = interval_of(difference, bounds.alpha)};
  if (!(bounds.lower < bounds.upper)) {
    throw std::invalid_argument("the equivalence bounds are " + number_text(bounds.lower) +
                                " and " + number_text(bounds.upper) +
                                "; the lower bound must be less than the upper one");
  }
  const double error = difference.standard_error;
  test.t_lower = (difference.value - bounds.lower) / error;
  test.t_upper = (difference.value - bounds.upper) / error;
  test.p_lower = *upper_tail(TStatistic{.value = test.t_lower, .df = difference.df});
  test.p_upper = *upper_tail(TStatistic{.value = -test.t_upper, .df = difference.df});
  test.p = std::max(test.p_lower, test.p_upper);
  test.equivalent = test.p < bounds.alpha;
  return test;
}

double smallest_equivalence_margin(const EstimatedDifference& difference, double alpha) {
  const ConfidenceInterval interval = interval_of(difference, alpha);
  return std::max(std::abs(interval.low), std::abs(interval.high));
}

double jzs_bayes_factor(const BayesFactorQuestion& question) {
  if (!std::isfinite(question.t)) {
    throw std::invalid_argument("t is " + number_text(question.t) + "; it must be finite");
  }
  refuse_unless_positive(question.df, "df");
  refuse_unless_positive(question.n, "n");
  refuse_unless_positive(question.scale, "scale of the prior");
  const double squared = question.t * question.t / question.df;
  // e^(−1/(2g)) is below 10⁻³⁰⁰ at the lower end; at the upper one the rest falls as 1/g.
  constexpr double kLowest = -8.0;
  constexpr double kHighest = 100.0;
  constexpr double kStep = 1.0 / 32.0;
  std::vector<double> logarithms{};
  for (double u = kLowest; u <= kHighest; u += kStep) {
    const double g = std::exp(u);
    const double widened = 1.0 + question.n * g * question.scale * question.scale;
    // The last −½u is −3/2·u of the prior and +u of dg = e^u·du.
    logarithms.push_back(-0.5 * std::log(widened) -
                         0.5 * (question.df + 1.0) *
                             (std::log1p(squared / widened) - std::log1p(squared)) -
                         0.5 / g - 0.5 * u);
  }
  const double greatest = *std::max_element(logarithms.begin(), logarithms.end());
  double sum = 0.0;
  for (const double one : logarithms) sum += std::exp(one - greatest);
  return std::exp(greatest + std::log(sum * kStep) - 0.5 * std::log(2.0 * std::numbers::pi));
}

}  // namespace asperity
