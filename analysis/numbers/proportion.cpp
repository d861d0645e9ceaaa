// Proportions by Boost's beta, binomial and normal distributions.

#include "analysis/numbers/proportion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

void refuse_impossible_count(const HitCount& count) {
  if (count.trials == 0) {
    throw std::invalid_argument("trials is 0; a proportion needs at least one trial");
  }
  if (count.hits > count.trials) {
    throw std::invalid_argument("hits is " + std::to_string(count.hits) + " and trials is " +
                                std::to_string(count.trials) + "; hits must not exceed trials");
  }
}

void refuse_impossible_confidence(double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
}

void refuse_no_chance(double chance) {
  if (!(chance >= 0.0 && chance <= 1.0)) {
    throw std::invalid_argument("chance is " + number_text(chance) +
                                "; it must lie between 0 and 1");
  }
}

// The quantiles at both ends of beta distributions; an end without hits or misses is 0 or 1.
ConfidenceInterval beta_interval(const HitCount& count, double confidence,
                                 const boost::math::beta_distribution<>& below,
                                 const boost::math::beta_distribution<>& above) {
  const double error = 0.5 * (1.0 - confidence);
  ConfidenceInterval interval{};
  if (count.hits > 0) interval.low = boost::math::quantile(below, error);
  if (count.hits < count.trials) {
    interval.high = boost::math::quantile(boost::math::complement(above, error));
  }
  return interval;
}

}  // namespace

double proportion(const HitCount& count) {
  refuse_impossible_count(count);
  return static_cast<double>(count.hits) / static_cast<double>(count.trials);
}

ConfidenceInterval within(const ConfidenceInterval& possible, const ConfidenceInterval& interval) {
  return {.low = std::clamp(interval.low, possible.low, possible.high),
          .high = std::clamp(interval.high, possible.low, possible.high)};
}

ConfidenceInterval wilson_interval(const HitCount& count, double confidence) {
  refuse_impossible_count(count);
  refuse_impossible_confidence(confidence);
  const double z = normal_limit(confidence);
  const auto n = static_cast<double>(count.trials);
  const double p = proportion(count);
  const double scale = 1.0 + z * z / n;
  const double middle = (p + z * z / (2.0 * n)) / scale;
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n)) / scale;
  return {.low = count.hits == 0 ? 0.0 : middle - half,
          .high = count.hits == count.trials ? 1.0 : middle + half};
}

ConfidenceInterval clopper_pearson_interval(const HitCount& count, double confidence) {
  refuse_impossible_count(count);
  refuse_impossible_confidence(confidence);
  const auto hits = static_cast<double>(count.hits);
  const auto misses = static_cast<double>(count.trials - count.hits);
  // A shape of 0 is no distribution; beta_interval does not look at that end.
  return beta_interval(count, confidence, {std::max(hits, 0.5), misses + 1.0},
                       {hits + 1.0, std::max(misses, 0.5)});
}

ConfidenceInterval jeffreys_interval(const HitCount& count, double confidence) {
  refuse_impossible_count(count);
  refuse_impossible_confidence(confidence);
  const boost::math::beta_distribution posterior(
      static_cast<double>(count.hits) + 0.5, static_cast<double>(count.trials - count.hits) + 0.5);
  return beta_interval(count, confidence, posterior, posterior);
}

ConfidenceInterval agresti_coull_interval(const HitCount& count, double confidence) {
  refuse_impossible_count(count);
  refuse_impossible_confidence(confidence);
  const double z = normal_limit(confidence);
  const double n = static_cast<double>(count.trials) + z * z;
  const double p = (static_cast<double>(count.hits) + 0.5 * z * z) / n;
  const double half = z * std::sqrt(p * (1.0 - p) / n);
  return within(kShares, {.low = p - half, .high = p + half});
}

double binomial_upper_tail(const HitCount& count, double chance) {
  refuse_impossible_count(count);
  refuse_no_chance(chance);
  if (count.hits == 0) return 1.0;
  const boost::math::binomial distribution(static_cast<double>(count.trials), chance);
  return boost::math::cdf(
      boost::math::complement(distribution, static_cast<double>(count.hits - 1)));
}

double binomial_lower_tail(const HitCount& count, double chance) {
  refuse_impossible_count(count);
  refuse_no_chance(chance);
  if (count.hits == count.trials) return 1.0;
  const boost::math::binomial distribution(static_cast<double>(count.trials), chance);
  return boost::math::cdf(distribution, static_cast<double>(count.hits));
}

double binomial_upper_mid_tail(const HitCount& count, double chance) {
  refuse_impossible_count(count);
  refuse_no_chance(chance);
  const boost::math::binomial distribution(static_cast<double>(count.trials), chance);
  const auto hits = static_cast<double>(count.hits);
  const double above = count.hits == count.trials
                           ? 0.0
                           : boost::math::cdf(boost::math::complement(distribution, hits));
  return above + 0.5 * boost::math::pdf(distribution, hits);
}

double binomial_mid_test(const HitCount& count, double chance) {
  refuse_impossible_count(count);
  refuse_no_chance(chance);
  const HitCount misses{.hits = count.trials - count.hits, .trials = count.trials};
  const double upper = binomial_upper_mid_tail(count, chance);
  const double lower = binomial_upper_mid_tail(misses, 1.0 - chance);
  return std::min(1.0, 2.0 * std::min(upper, lower));
}

double cohen_h(const HitCount& count, double chance) {
  refuse_no_chance(chance);
  return 2.0 * std::asin(std::sqrt(proportion(count))) - 2.0 * std::asin(std::sqrt(chance));
}

// The probabilities rise to the expected count and fall beyond it, so those beyond it that are not
// above the observed one begin at some count, found by halves.
double binomial_test(const HitCount& count, double chance) {
  refuse_impossible_count(count);
  refuse_no_chance(chance);
  const double expected = static_cast<double>(count.trials) * chance;
  const auto hits = static_cast<double>(count.hits);
  if (hits == expected) return 1.0;
  if (chance == 0.0 || chance == 1.0) return 0.0;
  if (hits > expected) {
    return binomial_test({.hits = count.trials - count.hits, .trials = count.trials}, 1.0 - chance);
  }
  const boost::math::binomial distribution(static_cast<double>(count.trials), chance);
  constexpr double kAsProbable = 1.0 + 1e-7;
  const double most = boost::math::pdf(distribution, hits) * kAsProbable;
  auto begin = static_cast<std::uint64_t>(std::ceil(expected));
  std::uint64_t end = count.trials + 1;
  while (begin < end) {
    const std::uint64_t middle = begin + (end - begin) / 2;
    const bool improbable = boost::math::pdf(distribution, static_cast<double>(middle)) <= most;
    (improbable ? end : begin) = improbable ? middle : middle + 1;
  }
  const double above = begin > count.trials ? 0.0
                                            : boost::math::cdf(boost::math::complement(
                                                  distribution, static_cast<double>(begin) - 1.0));
  return std::min(1.0, boost::math::cdf(distribution, hits) + above);
}

}  // namespace asperity
