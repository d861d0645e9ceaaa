// The noncentral hypergeometric distribution, and intervals.

#include "analysis/tests/two_by_two.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <boost/math/tools/roots.hpp>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

// All tables with the margins of one, by the hits of the first group.
class Margins final {
 public:
  explicit Margins(const TwoByTwo& table) {
    const std::uint64_t hits = table.first.hits + table.second.hits;
    low_ = hits > table.second.trials ? hits - table.second.trials : 0;
    high_ = std::min(table.first.trials, hits);
    for (std::uint64_t x = low_; x <= high_; ++x) {
      log_weight_.push_back(
          log_choose(static_cast<double>(table.first.trials), static_cast<double>(x)) +
          log_choose(static_cast<double>(table.second.trials), static_cast<double>(hits - x)));
    }
  }

  std::uint64_t low() const noexcept { return low_; }
  std::uint64_t high() const noexcept { return high_; }

  std::vector<double> probabilities(double log_odds) const {
    std::vector<double> p;
    for (std::size_t i = 0; i < log_weight_.size(); ++i) {
      p.push_back(log_weight_[i] + log_odds * static_cast<double>(low_ + i));
    }
    const double greatest = *std::max_element(p.begin(), p.end());
    double sum = 0.0;
    for (double& one : p) {
      one = std::exp(one - greatest);
      sum += one;
    }
    for (double& one : p) {
      one /= sum;
    }
    return p;
  }

  double mean(double log_odds) const {
    const std::vector<double> p = probabilities(log_odds);
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      sum += p[i] * static_cast<double>(low_ + i);
    }
    return sum;
  }

  double at_least(std::uint64_t x, double log_odds) const {
    const std::vector<double> p = probabilities(log_odds);
    double sum = 0.0;
    for (std::uint64_t value = high_; value + 1 > x; --value) {
      sum += p[static_cast<std::size_t>(value - low_)];
      if (value == low_) {
        break;
      }
    }
    return sum;
  }

  double at_most(std::uint64_t x, double log_odds) const {
    const std::vector<double> p = probabilities(log_odds);
    double sum = 0.0;
    for (std::uint64_t value = low_; value <= x; ++value) {
      sum += p[static_cast<std::size_t>(value - low_)];
    }
    return sum;
  }

 private:
  std::uint64_t low_ = 0;
  std::uint64_t high_ = 0;
  std::vector<double> log_weight_{};
};

// e to the root of an increasing or decreasing function of the logarithm of the odds.
double odds_at_root(const std::function<double(double)>& error) {
  constexpr double kFurthest = 40.0;  // odds of 10¹⁷
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      error, -kFurthest, kFurthest, boost::math::tools::eps_tolerance<double>(50), iterations);
  return std::exp(low + 0.5 * (high - low));
}

}  // namespace

double fisher_two_sided(const TwoByTwo& table) {
  static_cast<void>(proportion(table.first));  // refuses impossible counts
  static_cast<void>(proportion(table.second));
  const Margins margins(table);
  const std::vector<double> p = margins.probabilities(0.0);
  constexpr double kAsProbable = 1.0 + 1e-7;
  const double most = p[static_cast<std::size_t>(table.first.hits - margins.low())] * kAsProbable;
  double sum = 0.0;
  for (const double one : p) {
    sum += one <= most ? one : 0.0;
  }
  return std::min(1.0, sum);
}

FisherTest fisher_test(const TwoByTwo& table, double confidence) {
  static_cast<void>(wilson_interval(table.first, confidence));  // refuses improbable confidence
  const Margins margins(table);
  const std::uint64_t x = table.first.hits;
  FisherTest test{.margins_decide = margins.low() == margins.high()};
  test.p_two_sided = fisher_two_sided(table);
  test.p_greater = std::min(1.0, margins.at_least(x, 0.0));
  test.p_less = std::min(1.0, margins.at_most(x, 0.0));

  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const double outside = 0.5 * (1.0 - confidence);
  const bool lowest = x == margins.low();
  const bool highest = x == margins.high();
  test.interval.low = lowest ? 0.0 : odds_at_root([&](double log_odds) {
    return margins.at_least(x, log_odds) - outside;
  });
  test.interval.high = highest ? kInfinite : odds_at_root([&](double log_odds) {
    return margins.at_most(x, log_odds) - outside;
  });
  if (lowest || highest) {
    test.odds_ratio = lowest ? 0.0 : kInfinite;
  } else {
    test.odds_ratio = odds_at_root(
        [&](double log_odds) { return margins.mean(log_odds) - static_cast<double>(x); });
  }
  return test;
}

HaldaneRatio haldane_ratio(const TwoByTwo& table) {
  static_cast<void>(proportion(table.first));
  static_cast<void>(proportion(table.second));
  const double hits_1 = static_cast<double>(table.first.hits) + 0.5;
  const double misses_1 = static_cast<double>(table.first.trials - table.first.hits) + 0.5;
  const double hits_2 = static_cast<double>(table.second.hits) + 0.5;
  const double misses_2 = static_cast<double>(table.second.trials - table.second.hits) + 0.5;
  return {.odds_ratio = hits_1 * misses_2 / (misses_1 * hits_2),
          .log_standard_error =
              std::sqrt(1.0 / hits_1 + 1.0 / misses_1 + 1.0 / hits_2 + 1.0 / misses_2)};
}

ShareDifference newcombe_difference(const TwoByTwo& table, double confidence) {
  const double p1 = proportion(table.first);
  const double p2 = proportion(table.second);
  const ConfidenceInterval w1 = wilson_interval(table.first, confidence);
  const ConfidenceInterval w2 = wilson_interval(table.second, confidence);
  const double difference = p1 - p2;
  return {.difference = difference,
          .interval = {.low = difference - std::hypot(p1 - w1.low, w2.high - p2),
                       .high = difference + std::hypot(w1.high - p1, p2 - w2.low)}};
}

}  // namespace asperity
