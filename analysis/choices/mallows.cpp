// One unknown: the mean of F rises with θ, so a bracket and a root finder are enough.

#include "analysis/choices/mallows.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include "analysis/choices/matching_null.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

struct Moments {
  double log_sum = 0.0;  ///< ln Σ P(F)·exp(θ·F)
  double mean = 0.0;
  double variance = 0.0;
};

Moments moments_at(double theta, const std::vector<double>& chance) {
  const double most = std::max(0.0, theta * static_cast<double>(chance.size() - 1));
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t k = 0; k < chance.size(); ++k) {
    const auto right = static_cast<double>(k);
    const double weight = chance[k] * std::exp(theta * right - most);
    sum += weight;
    first += weight * right;
    second += weight * right * right;
  }
  const double mean = first / sum;
  return {.log_sum = std::log(sum) + most, .mean = mean, .variance = second / sum - mean * mean};
}

/// The root of a function that rises through 0 somewhere beyond `from` in the direction of `step`.
template <class Function>
double root_beyond(double from, double step, Function rising) {
  double near = from;
  double far = from + step;
  while (rising(far) < 0.0) {
    near = far;
    step *= 2.0;
    far += step;
  }
  std::uintmax_t most = 200;
  const auto [low, high] =
      boost::math::tools::toms748_solve(rising, std::min(near, far), std::max(near, far),
                                        boost::math::tools::eps_tolerance<double>(52), most);
  return 0.5 * (low + high);
}

}  // namespace

MallowsFit mallows_fit(std::span<const std::size_t> right, std::size_t items, double confidence) {
  const std::vector<double> chance = fixed_point_distribution(items);
  if (right.empty())
    throw std::invalid_argument(
        "the list of assignments is empty; at least one assignment is needed");
  for (const std::size_t one : right) {
    if (one > items) {
      throw std::invalid_argument(
          "the number of correct items of an assignment is " + std::to_string(one) +
          "; it must not exceed the number of items, " + std::to_string(items));
    }
  }
  const auto n = static_cast<double>(right.size());
  const auto total =
      static_cast<double>(std::accumulate(right.begin(), right.end(), std::size_t{0}));
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (total == n * static_cast<double>(items)) return {.theta = kInfinite};
  if (total == 0.0) return {.theta = -kInfinite};

  const double mean = total / n;
  const double side = mean > moments_at(0.0, chance).mean ? 1.0 : -1.0;
  const double theta =
      mean == moments_at(0.0, chance).mean ? 0.0 : root_beyond(0.0, side, [&](double t) {
        return side * (moments_at(t, chance).mean - mean);
      });
  const auto log_likelihood = [&](double t) {
    return total * t - n * moments_at(t, chance).log_sum;
  };
  const double top = log_likelihood(theta);
  const double z = normal_limit(confidence);
  const auto excess = [&](double t) { return 2.0 * (top - log_likelihood(t)) - z * z; };
  MallowsFit::Finite finite{};
  finite.standard_error = 1.0 / std::sqrt(n * moments_at(theta, chance).variance);
  finite.likelihood_ratio = 2.0 * (top - log_likelihood(0.0));
  finite.interval = {.low = root_beyond(theta, -finite.standard_error, excess),
                     .high = root_beyond(theta, finite.standard_error, excess)};
  return {.theta = theta, .finite = finite};
}

}  // namespace asperity
