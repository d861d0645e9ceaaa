// Noncentral distributions, turned round; a jackknife.

#include "analysis/tests/effect_size.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/tools/roots.hpp>

#include "analysis/tests/friedman.h"

namespace asperity {
namespace {

bool are_usable(double value, double df) {
  return std::isfinite(value) && std::isfinite(df) && df > 0.0;
}

// Where a function of the noncentrality is 0, between two ends at which its signs differ.
template <typename Function>
double crossing(const Function& function, double low, double high) {
  std::uintmax_t steps = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(50), steps);
  return 0.5 * (left + right);
}

// The end of an interval by which the function has changed its sign: steps of doubled width from
// `from` on, downwards where `width` is negative.
template <typename Function>
double beyond_crossing(const Function& function, double from, double width) {
  const bool sign = function(from) > 0.0;
  double to = from + width;
  for (int doubling = 0; doubling < 60 && (function(to) > 0.0) == sign; ++doubling) {
    width *= 2.0;
    to += width;
  }
  return to;
}

std::optional<ConfidenceInterval> scaled(const std::optional<ConfidenceInterval>& interval,
                                         double factor) {
  if (!interval) return std::nullopt;
  return ConfidenceInterval{.low = factor * interval->low, .high = factor * interval->high};
}

}  // namespace

std::optional<ConfidenceInterval> noncentrality_interval(const TStatistic& statistic,
                                                         double confidence) {
  static_cast<void>(normal_limit(confidence));  // refuses what is no confidence
  if (!are_usable(statistic.value, statistic.df)) return std::nullopt;
  const double tail = 0.5 * (1.0 - confidence);
  using boost::math::complement;
  using boost::math::non_central_t;
  try {
    const auto above = [&](double delta) {  // grows with δ
      return cdf(complement(non_central_t(statistic.df, delta), statistic.value)) - tail;
    };
    const auto below = [&](double delta) {  // falls with δ
      return cdf(non_central_t(statistic.df, delta), statistic.value) - tail;
    };
    const double low = beyond_crossing(above, statistic.value, -2.0);
    const double high = beyond_crossing(below, statistic.value, 2.0);
    return ConfidenceInterval{.low = crossing(above, low, statistic.value),
                              .high = crossing(below, statistic.value, high)};
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<ConfidenceInterval> noncentrality_interval(const FStatistic& statistic,
                                                         double confidence) {
  static_cast<void>(normal_limit(confidence));
  if (!are_usable(statistic.value, statistic.df1) || !are_usable(statistic.value, statistic.df2) ||
      statistic.value < 0.0) {
    return std::nullopt;
  }
  const double tail = 0.5 * (1.0 - confidence);
  using boost::math::complement;
  using boost::math::non_central_f;
  try {
    const auto above = [&](double lambda) {
      return cdf(complement(non_central_f(statistic.df1, statistic.df2, lambda), statistic.value)) -
             tail;
    };
    const auto below = [&](double lambda) {
      return cdf(non_central_f(statistic.df1, statistic.df2, lambda), statistic.value) - tail;
    };
    // Boost takes the complement of λ = 0 for its opposite: the central F is asked instead.
    const double central = *upper_tail(statistic);
    ConfidenceInterval limits{.low = 0.0, .high = 0.0};
    constexpr double kLeast = 1e-12;
    if (central < tail) limits.low = crossing(above, kLeast, beyond_crossing(above, kLeast, 1.0));
    if (1.0 - central > tail) {
      limits.high = crossing(below, kLeast, beyond_crossing(below, kLeast, 1.0));
    }
    return limits;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<ConfidenceInterval> standardised_mean_interval(double d, double n,
                                                             double confidence) {
  const double root = std::sqrt(n);
  return scaled(noncentrality_interval(TStatistic{.value = d * root, .df = n - 1.0}, confidence),
                1.0 / root);
}

std::optional<ConfidenceInterval> standardised_difference_interval(const WelchT& welch,
                                                                   const TwoSamples& samples,
                                                                   double confidence) {
  const auto first = static_cast<double>(samples.first.size());
  const auto second = static_cast<double>(samples.second.size());
  const double root = std::sqrt(first * second / (first + second));
  const TStatistic t{.value = welch.d * root, .df = first + second - 2.0};
  return scaled(noncentrality_interval(t, confidence), 1.0 / root);
}

std::optional<ConfidenceInterval> bias_corrected(const WelchT& welch,
                                                 const std::optional<ConfidenceInterval>& of_d) {
  return scaled(of_d, welch.bias_correction);
}

std::optional<ConfidenceInterval> partial_eta_interval(const FStatistic& statistic,
                                                       double confidence) {
  const auto limits = noncentrality_interval(statistic, confidence);
  if (!limits) return std::nullopt;
  const double observations = statistic.df1 + statistic.df2 + 1.0;
  return ConfidenceInterval{.low = limits->low / (limits->low + observations),
                            .high = limits->high / (limits->high + observations)};
}

double generalised_eta(double partial_eta, double errors) {
  const double odds = partial_eta / (1.0 - partial_eta);
  return std::isinf(odds) ? 1.0 : odds / (odds + errors);
}

std::optional<ConfidenceInterval> concordance_interval(const Eigen::MatrixXd& judgements,
                                                       double confidence) {
  const Eigen::Index rows = judgements.rows();
  if (rows < 4) return std::nullopt;
  const auto mean_correlation = [](const Eigen::MatrixXd& of) {
    const auto n = static_cast<double>(of.rows());
    return (n * friedman_test(of).concordance - 1.0) / (n - 1.0);
  };
  const auto n = static_cast<double>(rows);
  const double all = std::atanh(mean_correlation(judgements));
  std::vector<double> pseudo_values{};
  for (Eigen::Index left_out = 0; left_out < rows; ++left_out) {
    std::vector<Eigen::Index> others{};
    for (Eigen::Index row = 0; row < rows; ++row) {
      if (row != left_out) others.push_back(row);
    }
    const double without = std::atanh(mean_correlation(judgements(others, Eigen::all)));
    pseudo_values.push_back(n * all - (n - 1.0) * without);
    if (!std::isfinite(pseudo_values.back())) return std::nullopt;
  }
  const OneSampleT jackknife = one_sample_t(pseudo_values, {.confidence = confidence});
  if (!jackknife.test) return std::nullopt;
  const auto concordance = [n](double transformed) {
    return std::max(0.0, (1.0 + (n - 1.0) * std::tanh(transformed)) / n);
  };
  return ConfidenceInterval{.low = concordance(jackknife.test->interval.low),
                            .high = concordance(jackknife.test->interval.high)};
}

ArcsineDifference cohen_h(const HitCount& first, const HitCount& second, double confidence) {
  const double h = 2.0 * std::asin(std::sqrt(proportion(first))) -
                   2.0 * std::asin(std::sqrt(proportion(second)));
  const double half =
      normal_limit(confidence) *
      std::sqrt(1.0 / static_cast<double>(first.trials) + 1.0 / static_cast<double>(second.trials));
  return {.h = h, .interval = {.low = h - half, .high = h + half}};
}

}  // namespace asperity
