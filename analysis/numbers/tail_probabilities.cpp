// Tails by Boost, with answers where Boost throws.

#include "analysis/numbers/tail_probabilities.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

bool usable(double df) { return std::isfinite(df) && df > 0.0; }

// The tail where the statistic is not a positive finite number; nothing where it is one.
std::optional<double> tail_at_the_end(double value) {
  if (value <= 0.0) {
    return 1.0;
  }
  if (std::isinf(value)) {
    return 0.0;
  }
  return std::nullopt;
}

void refuse_confidence(double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
}

}  // namespace

std::optional<double> upper_tail(const ChiSquaredStatistic& statistic) {
  if (std::isnan(statistic.value)) {
    return std::nullopt;
  }
  if (!usable(statistic.df)) {
    return std::nullopt;
  }
  if (const std::optional<double> end = tail_at_the_end(statistic.value)) {
    return end;
  }
  const boost::math::chi_squared distribution(statistic.df);
  return boost::math::cdf(boost::math::complement(distribution, statistic.value));
}

std::optional<double> upper_tail(const FStatistic& statistic) {
  if (std::isnan(statistic.value) || !usable(statistic.df1) || !usable(statistic.df2)) {
    return std::nullopt;
  }
  if (const std::optional<double> end = tail_at_the_end(statistic.value)) {
    return end;
  }
  const boost::math::fisher_f distribution(statistic.df1, statistic.df2);
  return boost::math::cdf(boost::math::complement(distribution, statistic.value));
}

std::optional<double> upper_tail(const TStatistic& statistic) {
  if (std::isnan(statistic.value) || !usable(statistic.df)) {
    return std::nullopt;
  }
  if (std::isinf(statistic.value)) {
    return statistic.value > 0.0 ? 0.0 : 1.0;
  }
  const boost::math::students_t distribution(statistic.df);
  return boost::math::cdf(boost::math::complement(distribution, statistic.value));
}

std::optional<double> two_sided_tail(const TStatistic& statistic) {
  const std::optional<double> one_sided =
      upper_tail(TStatistic{.value = std::abs(statistic.value), .df = statistic.df});
  return one_sided ? std::optional<double>(2.0 * *one_sided) : std::nullopt;
}

double normal_limit(double confidence) {
  refuse_confidence(confidence);
  return boost::math::quantile(
      boost::math::complement(boost::math::normal(), 0.5 * (1.0 - confidence)));
}

std::optional<double> t_limit(const TLimit& limit) {
  refuse_confidence(limit.confidence);
  if (!usable(limit.df)) {
    return std::nullopt;
  }
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(limit.df), 0.5 * (1.0 - limit.confidence)));
}

double exceeded_by(const ChiSquaredTail& of) {
  return boost::math::quantile(boost::math::complement(boost::math::chi_squared(of.df), of.tail));
}

double exceeded_by(const FTail& of) {
  return boost::math::quantile(
      boost::math::complement(boost::math::fisher_f(of.df1, of.df2), of.tail));
}

double normal_density(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

double normal_below(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normal_quantile(double p) { return boost::math::quantile(boost::math::normal(), p); }

double log_choose(double n, double k) {
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

}  // namespace asperity
