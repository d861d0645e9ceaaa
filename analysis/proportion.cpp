// Proportions by Boost's beta, binomial and normal distributions.

#include "analysis/proportion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

#include "analysis/number_text.h"

namespace asperity {
namespace {

void refuse_impossible(const HitCount& count) {
  if (count.trials == 0) {
    throw std::invalid_argument("trials is 0; a proportion needs at least one trial");
  }
  if (count.hits > count.trials) {
    throw std::invalid_argument("hits is " + std::to_string(count.hits) + " of " +
                                std::to_string(count.trials) + " trials; at most all can be");
  }
}

void refuse_improbable(double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
}

}  // namespace

double proportion(const HitCount& count) {
  refuse_impossible(count);
  return static_cast<double>(count.hits) / static_cast<double>(count.trials);
}

ConfidenceInterval wilson_interval(const HitCount& count, double confidence) {
  refuse_impossible(count);
  refuse_improbable(confidence);
  const double z = boost::math::quantile(
      boost::math::complement(boost::math::normal(), 0.5 * (1.0 - confidence)));
  const auto n = static_cast<double>(count.trials);
  const double p = proportion(count);
  const double scale = 1.0 + z * z / n;
  const double middle = (p + z * z / (2.0 * n)) / scale;
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n)) / scale;
  return {.low = count.hits == 0 ? 0.0 : middle - half,
          .high = count.hits == count.trials ? 1.0 : middle + half};
}

ConfidenceInterval clopper_pearson_interval(const HitCount& count, double confidence) {
  refuse_impossible(count);
  refuse_improbable(confidence);
  const double error = 0.5 * (1.0 - confidence);
  const auto hits = static_cast<double>(count.hits);
  const auto misses = static_cast<double>(count.trials - count.hits);
  ConfidenceInterval interval;
  if (count.hits > 0) {
    interval.low = boost::math::quantile(boost::math::beta_distribution(hits, misses + 1.0), error);
  }
  if (count.hits < count.trials) {
    interval.high = boost::math::quantile(
        boost::math::complement(boost::math::beta_distribution(hits + 1.0, misses), error));
  }
  return interval;
}

double binomial_test(const HitCount& count, double chance) {
  refuse_impossible(count);
  if (!(chance >= 0.0 && chance <= 1.0)) {
    throw std::invalid_argument("chance is " + number_text(chance) +
                                "; it must lie between 0 and 1");
  }
  const boost::math::binomial distribution(static_cast<double>(count.trials), chance);
  constexpr double kAsProbable = 1.0 + 1e-7;
  const double most = boost::math::pdf(distribution, static_cast<double>(count.hits)) * kAsProbable;
  double sum = 0.0;
  for (std::uint64_t hits = 0; hits <= count.trials; ++hits) {
    const double probability = boost::math::pdf(distribution, static_cast<double>(hits));
    if (probability <= most) {
      sum += probability;
    }
  }
  return std::min(1.0, sum);
}

}  // namespace asperity
