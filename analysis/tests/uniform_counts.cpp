// Pearson's X² and the likelihood ratio against equal counts, and Goodman's simultaneous intervals.

#include "analysis/tests/uniform_counts.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

double total_of(std::span<const std::uint64_t> counts) {
  if (counts.size() < 2) {
    throw std::invalid_argument("counts: the number of alternatives is " +
                                std::to_string(counts.size()) + "; at least 2 are needed");
  }
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
}

}  // namespace

UniformTest uniform_test(std::span<const std::uint64_t> counts) {
  const double n = total_of(counts);
  const auto alternatives = static_cast<double>(counts.size());
  UniformTest test{.df = alternatives - 1.0};
  if (n == 0.0) {
    test.pearson = test.pearson_p = test.likelihood_ratio = test.likelihood_ratio_p = test.cohen_w =
        kUndefined;
    return test;
  }
  const double expected = n / alternatives;
  for (const std::uint64_t count : counts) {
    const auto x = static_cast<double>(count);
    test.pearson += (x - expected) * (x - expected) / expected;
    if (count > 0) test.likelihood_ratio += 2.0 * x * std::log(x / expected);
  }
  test.pearson_p = *upper_tail(ChiSquaredStatistic{.value = test.pearson, .df = test.df});
  test.likelihood_ratio_p =
      *upper_tail(ChiSquaredStatistic{.value = test.likelihood_ratio, .df = test.df});
  test.cohen_w = std::sqrt(test.pearson / n);
  return test;
}

std::vector<ConfidenceInterval> goodman_intervals(std::span<const std::uint64_t> counts,
                                                  double confidence) {
  const double n = total_of(counts);
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
  const double error = (1.0 - confidence) / static_cast<double>(counts.size());
  const double a = exceeded_by(ChiSquaredTail{.tail = error, .df = 1.0});
  std::vector<ConfidenceInterval> intervals{};
  for (const std::uint64_t count : counts) {
    const auto x = static_cast<double>(count);
    const double half = std::sqrt(a * (a + 4.0 * x * (n - x) / n));
    intervals.push_back({.low = (a + 2.0 * x - half) / (2.0 * (n + a)),
                         .high = (a + 2.0 * x + half) / (2.0 * (n + a))});
  }
  return intervals;
}

}  // namespace asperity
