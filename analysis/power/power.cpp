// Enumerations, convolutions and noncentral distributions.

#include "analysis/power/power.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/non_central_t.hpp>

#include "analysis/choices/matching_null.h"
#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/proportion.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/two_by_two.h"

namespace asperity {
namespace {

using boost::math::cdf;
using boost::math::complement;

void refuse_unless_probability(double value, const char* name) {
  if (!(value >= 0.0 && value <= 1.0)) {
    throw std::invalid_argument(std::string(name) + " is " + number_text(value) +
                                "; it must be from 0 to 1");
  }
}

void refuse_error(double error) {
  if (!(error > 0.0 && error < 1.0)) {
    throw std::invalid_argument("error is " + number_text(error) + "; it must lie between 0 and 1");
  }
}

void refuse_fewer(std::size_t number, std::size_t least, const char* name) {
  if (number < least) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(number) +
                                "; it must be at least " + std::to_string(least));
  }
}

// Of the sum of n independent counts, each with these probabilities of 0, 1, 2, …, from 0 on.
std::vector<double> sum_distribution(const std::vector<double>& one, std::size_t n) {
  const IntegerDistribution sum = repeated_sum({.lowest = 0, .probability = one}, n);
  std::vector<double> all((one.size() - 1) * n + 1, 0.0);
  std::copy(sum.probability.begin(), sum.probability.end(),
            all.begin() + static_cast<std::ptrdiff_t>(sum.lowest));
  return all;
}

// The first number from `begin` on that is so, where all after it are as well; `end` where none is.
template <typename Predicate>
std::size_t first_that(std::size_t begin, std::size_t end, const Predicate& is_so) {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const bool found = is_so(middle);
    (found ? end : begin) = found ? middle : middle + 1;
  }
  return begin;
}

// The least number of hits whose upper tail under chance is at most the error; one more than there are trials where
// even that of all hits is not.
std::size_t least_rejected(std::size_t trials, double chance, double error) {
  return first_that(0, trials + 1, [=](std::size_t hits) {
    return binomial_upper_tail({.hits = hits, .trials = trials}, chance) <= error;
  });
}

// Consecutive weights around their largest, which is 1: those that are not below `least`.
struct Weights {
  std::int64_t lowest = 0;
  std::vector<double> of{1.0};

  std::int64_t highest() const { return lowest + static_cast<std::int64_t>(of.size()) - 1; }
  double at(std::int64_t value) const {
    return value < lowest || value > highest() ? 0.0 : of[static_cast<std::size_t>(value - lowest)];
  }
};

// `next(x)` is the weight of x + 1 over that of x; `mode` the most probable of low … high.
template <typename Ratio>
Weights weights_around(std::int64_t mode, std::int64_t low, std::int64_t high, double least,
                       const Ratio& next) {
  std::vector<double> below;
  double weight = 1.0;
  for (std::int64_t x = mode; x > low && weight >= least; --x) {
    weight /= next(x - 1);
    if (weight >= least) below.push_back(weight);
  }
  Weights weights{.lowest = mode - static_cast<std::int64_t>(below.size()),
                  .of = {below.rbegin(), below.rend()}};
  weights.of.push_back(1.0);
  weight = 1.0;
  for (std::int64_t x = mode; x < high; ++x) {
    weight *= next(x);
    if (weight < least) break;
    weights.of.push_back(weight);
  }
  return weights;
}

// The probabilities of a binomial, but for those at the ends, which are below 10⁻⁶⁰ of the largest.
Weights binomial_probabilities(std::size_t trials, double p) {
  const auto n = static_cast<std::int64_t>(trials);
  const auto mode = std::min(n, static_cast<std::int64_t>(static_cast<double>(n + 1) * p));
  Weights weights = weights_around(mode, 0, n, 1e-60, [n, p](std::int64_t x) {
    return static_cast<double>(n - x) / static_cast<double>(x + 1) * (p / (1.0 - p));
  });
  const double sum = std::accumulate(weights.of.begin(), weights.of.end(), 0.0);
  for (double& one : weights.of) one /= sum;
  return weights;
}

// What Fisher's two-sided test does not reject of all tables with the same sum of hits: the hits of the first group
// from `first` to `last`.
struct NotRejected {
  std::int64_t first = 0;
  std::int64_t last = 0;
};

NotRejected not_rejected(const TwoGroupPlan& plan, std::int64_t hits) {
  // Tables of the ends that are less probable all together than this part of the error are rejected.
  constexpr double kRejected = 1e-20;
  constexpr double kAsProbable = 1.0 + 1e-7;  // as in `fisher_two_sided`
  constexpr double kRounding = 1.0 + 1e-12;   // a p that is the error rejects
  const auto n = static_cast<std::int64_t>(plan.first_trials);
  const auto m = static_cast<std::int64_t>(plan.second_trials);
  const std::int64_t low = std::max<std::int64_t>(0, hits - m);
  const std::int64_t high = std::min(n, hits);
  const auto mode = std::clamp(
      static_cast<std::int64_t>(static_cast<double>(n + 1) * static_cast<double>(hits + 1) /
                                static_cast<double>(n + m + 2)),
      low, high);
  const Weights weights =
      weights_around(mode, low, high, kRejected * plan.error, [=](std::int64_t x) {
        return static_cast<double>(n - x) / static_cast<double>(x + 1) *
               (static_cast<double>(hits - x) / static_cast<double>(m - hits + x + 1));
      });
  const double error =
      plan.error * kRounding * std::accumulate(weights.of.begin(), weights.of.end(), 0.0);
  // From both ends, the less probable first.
  std::int64_t first = weights.lowest;
  std::int64_t last = weights.highest();
  double rejected = 0.0;
  while (first <= last) {
    const bool is_first = weights.at(first) <= weights.at(last);
    const double weight = weights.at(is_first ? first : last);
    double as_extreme = rejected;
    std::int64_t from = first;
    for (; from <= last && weights.at(from) <= weight * kAsProbable; ++from) {
      as_extreme += weights.at(from);
    }
    for (std::int64_t to = last; to >= from && weights.at(to) <= weight * kAsProbable; --to) {
      as_extreme += weights.at(to);
    }
    if (as_extreme > error) break;
    rejected += weight;
    (is_first ? first : last) += is_first ? 1 : -1;
  }
  return {.first = first, .last = last};
}

// A one-sided test that rejects the counts whose upper tail under the null is at most the error.
ExactPower upper_test(const std::vector<double>& null, const std::vector<double>& alternative,
                      double error) {
  ExactPower answer;
  double tail = 0.0;
  for (std::size_t count = null.size(); count-- > 0;) {
    tail += null[count];
    if (tail > error) {
      break;
    }
    answer.critical = count;
    answer.actual_error += null[count];
    answer.power += alternative[count];
  }
  return answer;
}

MatchingPower matching_power(const MatchingPlan& plan, const std::vector<double>& alternative) {
  refuse_fewer(plan.assignments, 1, "assignments");
  refuse_error(plan.error);
  MatchingPower answer;
  for (std::size_t right = 0; right < alternative.size(); ++right) {
    answer.mean_right += static_cast<double>(right) * alternative[right];
  }
  answer.exact =
      upper_test(sum_distribution(fixed_point_distribution(plan.items), plan.assignments),
                 sum_distribution(alternative, plan.assignments), plan.error);
  return answer;
}

// Walks over all counts of `left` choices among the alternatives from `place` on.
struct Enumeration {
  const UniformPlan& plan;
  UniformPower power{};

  void walk(std::size_t place, std::size_t left, double log_null, double log_truth,
            double squares) {
    const std::size_t alternatives = plan.truth.size();
    const double expected = static_cast<double>(plan.choices) / static_cast<double>(alternatives);
    const bool is_last = place + 1 == alternatives;
    for (std::size_t count = is_last ? left : 0; count <= left; ++count) {
      const auto k = static_cast<double>(count);
      const double ways = -std::lgamma(k + 1.0);
      const double null = log_null + ways - k * std::log(static_cast<double>(alternatives));
      // An alternative that is never chosen has no counts above 0; 0·ln 0 is 0.
      const double truth = log_truth + ways + (count > 0 ? k * std::log(plan.truth[place]) : 0.0);
      const double so_far = squares + (k - expected) * (k - expected) / expected;
      if (!is_last) {
        walk(place + 1, left - count, null, truth, so_far);
      } else if (rejects(so_far)) {
        power.actual_error += std::exp(null);
        power.power += std::exp(truth);
      }
    }
  }

  bool rejects(double x2) const {
    return *upper_tail(ChiSquaredStatistic{
               .value = x2, .df = static_cast<double>(plan.truth.size()) - 1.0}) <= plan.error;
  }
};

}  // namespace

ExactPower binomial_power(const BinomialPlan& plan) {
  refuse_fewer(plan.trials, 1, "trials");
  refuse_unless_probability(plan.chance, "chance");
  refuse_unless_probability(plan.truth, "truth");
  refuse_error(plan.error);
  const std::size_t critical = least_rejected(plan.trials, plan.chance, plan.error);
  if (critical > plan.trials) return {};
  const HitCount from{.hits = critical, .trials = plan.trials};
  return {.critical = critical,
          .actual_error = binomial_upper_tail(from, plan.chance),
          .power = binomial_upper_tail(from, plan.truth)};
}

ExactPower binomial_two_sided_power(const BinomialPlan& plan) {
  refuse_fewer(plan.trials, 1, "trials");
  refuse_unless_probability(plan.chance, "chance");
  refuse_unless_probability(plan.truth, "truth");
  refuse_error(plan.error);
  // Away from what is expected, p falls on either side.
  const double expected = static_cast<double>(plan.trials) * plan.chance;
  const auto rejects = [&plan](std::size_t hits) {
    return binomial_test({.hits = hits, .trials = plan.trials}, plan.chance) <= plan.error;
  };
  const std::size_t below = first_that(0, static_cast<std::size_t>(std::ceil(expected)),
                                       [&rejects](std::size_t hits) { return !rejects(hits); });
  const std::size_t above =
      first_that(static_cast<std::size_t>(std::floor(expected)) + 1, plan.trials + 1, rejects);
  const auto rejected = [&](double probability) {
    const double low =
        below == 0 ? 0.0
                   : binomial_lower_tail({.hits = below - 1, .trials = plan.trials}, probability);
    const double high =
        above > plan.trials
            ? 0.0
            : binomial_upper_tail({.hits = above, .trials = plan.trials}, probability);
    return std::min(1.0, low + high);
  };
  return {.actual_error = rejected(plan.chance), .power = rejected(plan.truth)};
}

UniformPower uniform_power(const UniformPlan& plan) {
  refuse_fewer(plan.choices, 1, "choices");
  refuse_fewer(plan.truth.size(), 2, "alternatives");
  refuse_error(plan.error);
  double sum = 0.0;
  for (const double p : plan.truth) {
    refuse_unless_probability(p, "truth");
    sum += p;
  }
  constexpr double kRounding = 1e-6;
  if (std::abs(sum - 1.0) > kRounding) {
    throw std::invalid_argument("truth: the probabilities add up to " + number_text(sum) +
                                "; those of all alternatives must add up to 1");
  }
  // C(n + K − 1, K − 1) of them.
  const auto choices = static_cast<double>(plan.choices);
  const auto places = static_cast<double>(plan.truth.size());
  const double counts =
      std::exp(std::lgamma(choices + places) - std::lgamma(places) - std::lgamma(choices + 1.0));
  constexpr double kMostCounts = 2e7;  // some seconds
  if (counts > kMostCounts) {
    throw std::invalid_argument(
        "choices is " + std::to_string(plan.choices) + " and the number of alternatives is " +
        std::to_string(plan.truth.size()) +
        ": too many outcomes to enumerate; plan fewer choices or alternatives");
  }
  Enumeration enumeration{.plan = plan};
  const double ways = std::lgamma(static_cast<double>(plan.choices) + 1.0);
  enumeration.walk(0, plan.choices, ways, ways, 0.0);
  UniformPower answer = enumeration.power;
  answer.power = std::min(1.0, answer.power);  // a sum of many terms, each rounded
  const auto alternatives = static_cast<double>(plan.truth.size());
  double noncentrality = 0.0;
  for (const double p : plan.truth) {
    noncentrality += static_cast<double>(plan.choices) * alternatives * (p - 1.0 / alternatives) *
                     (p - 1.0 / alternatives);
  }
  const double df = alternatives - 1.0;
  const double critical = exceeded_by(ChiSquaredTail{.tail = plan.error, .df = df});
  answer.noncentral_power =
      noncentrality > 0.0
          ? cdf(complement(boost::math::non_central_chi_squared(df, noncentrality), critical))
          : plan.error;
  return answer;
}

MatchingPower mallows_power(const MatchingPlan& plan, double theta) {
  if (!std::isfinite(theta)) {
    throw std::invalid_argument("theta is " + number_text(theta) + "; it must be a finite number");
  }
  std::vector<double> alternative = fixed_point_distribution(plan.items);
  double sum = 0.0;
  for (std::size_t right = 0; right < alternative.size(); ++right) {
    // Weighed against all right, so that no power overflows.
    alternative[right] *= std::exp(theta * (static_cast<double>(right) -
                                            (theta > 0.0 ? static_cast<double>(plan.items) : 0.0)));
    sum += alternative[right];
  }
  for (double& p : alternative) {
    p /= sum;
  }
  return matching_power(plan, alternative);
}

MatchingPower known_items_power(const MatchingPlan& plan, std::size_t known) {
  if (known > plan.items) {
    throw std::invalid_argument("known is " + std::to_string(known) + " and items is " +
                                std::to_string(plan.items) + "; known must not exceed items");
  }
  std::vector<double> alternative(known, 0.0);
  const std::vector<double> rest =
      known == plan.items ? std::vector<double>{1.0} : fixed_point_distribution(plan.items - known);
  alternative.insert(alternative.end(), rest.begin(), rest.end());
  return matching_power(plan, alternative);
}

double paired_t_power(const PairedPlan& plan) {
  refuse_fewer(plan.pairs, 2, "pairs");
  refuse_error(plan.error);
  const double df = static_cast<double>(plan.pairs) - 1.0;
  const double limit = *t_limit({.confidence = 1.0 - plan.error, .df = df});
  const double noncentrality = plan.d * std::sqrt(static_cast<double>(plan.pairs));
  if (noncentrality == 0.0) {
    return plan.error;
  }
  const boost::math::non_central_t truth(df, noncentrality);
  return cdf(complement(truth, limit)) + cdf(truth, -limit);
}

WithinPower within_power(const WithinPlan& plan) {
  refuse_fewer(plan.participants, 2, "participants");
  refuse_fewer(plan.levels, 2, "levels");
  refuse_error(plan.error);
  const auto n = static_cast<double>(plan.participants);
  const auto levels = static_cast<double>(plan.levels);
  if (!(plan.correlation < 1.0) || !(plan.epsilon > 0.0 && plan.epsilon <= 1.0)) {
    throw std::invalid_argument("correlation is " + number_text(plan.correlation) +
                                " and epsilon " + number_text(plan.epsilon) +
                                "; correlation must be below 1, and epsilon above 0 and at most 1");
  }
  WithinPower answer;
  answer.noncentrality = plan.f * plan.f * n * levels / (1.0 - plan.correlation) * plan.epsilon;
  const double df1 = (levels - 1.0) * plan.epsilon;
  const double df2 = (levels - 1.0) * (n - 1.0) * plan.epsilon;
  const double critical = exceeded_by(FTail{.tail = plan.error, .df1 = df1, .df2 = df2});
  answer.power =
      answer.noncentrality > 0.0
          ? cdf(complement(boost::math::non_central_f(df1, df2, answer.noncentrality), critical))
          : plan.error;
  return answer;
}

ExactPower fisher_power(const TwoGroupPlan& plan) {
  refuse_fewer(plan.first_trials, 1, "first_trials");
  refuse_fewer(plan.second_trials, 1, "second_trials");
  refuse_unless_probability(plan.first_truth, "first_truth");
  refuse_unless_probability(plan.second_truth, "second_truth");
  refuse_error(plan.error);
  const Weights first = binomial_probabilities(plan.first_trials, plan.first_truth);
  const Weights second = binomial_probabilities(plan.second_trials, plan.second_truth);
  const Weights second_by_chance = binomial_probabilities(plan.second_trials, plan.first_truth);
  const std::int64_t second_low = std::min(second.lowest, second_by_chance.lowest);
  const std::int64_t second_high = std::max(second.highest(), second_by_chance.highest());
  ExactPower answer;
  for (std::int64_t hits = first.lowest + second_low; hits <= first.highest() + second_high;
       ++hits) {
    const NotRejected kept = not_rejected(plan, hits);
    const std::int64_t end = std::min(first.highest(), hits - second_low);
    for (std::int64_t x = std::max(first.lowest, hits - second_high); x <= end; ++x) {
      if (x >= kept.first && x <= kept.last) continue;
      answer.power += first.at(x) * second.at(hits - x);
      answer.actual_error += first.at(x) * second_by_chance.at(hits - x);
    }
  }
  answer.power = std::min(1.0, answer.power);  // sums of many terms, each rounded
  answer.actual_error = std::min(1.0, answer.actual_error);
  return answer;
}

PooledRejection pooled_rejection(const PooledPlan& plan) {
  refuse_fewer(plan.participants, 1, "participants");
  refuse_fewer(plan.trials_each, 1, "trials_each");
  refuse_unless_probability(plan.chance, "chance");
  refuse_error(plan.error);
  if (!(plan.truth > 0.0 && plan.truth < 1.0) ||
      !(plan.correlation > 0.0 && plan.correlation < 1.0)) {
    throw std::invalid_argument("truth is " + number_text(plan.truth) + " and correlation " +
                                number_text(plan.correlation) + "; both must lie between 0 and 1");
  }
  const double both = 1.0 / plan.correlation - 1.0;
  const double alpha = plan.truth * both;
  const double beta = (1.0 - plan.truth) * both;
  const auto log_beta = [](double a, double b) {
    return std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
  };
  const auto m = static_cast<double>(plan.trials_each);
  const auto n = static_cast<double>(plan.participants);
  PooledRejection answer{.design_effect = 1.0 + (m - 1.0) * plan.correlation};
  // Sums are counted out to where they are improbable, some 14 standard deviations either way.
  constexpr double kFurthest = 14.0;
  constexpr double kMostPairs = 2e10;  // some seconds
  const double deviation =
      std::sqrt(n * m * plan.truth * (1.0 - plan.truth) * answer.design_effect);
  const double width = std::min(n * m, 2.0 * kFurthest * deviation);
  if (plan.participants > 1 && 0.5 * width * width > kMostPairs) {
    throw std::invalid_argument(
        "the number of participants is " + std::to_string(plan.participants) +
        " and that of the trials of each is " + std::to_string(plan.trials_each) +
        ": too many outcomes to enumerate; plan fewer trials per participant");
  }
  std::vector<double> one;
  for (std::size_t hits = 0; hits <= plan.trials_each; ++hits) {
    const auto k = static_cast<double>(hits);
    one.push_back(
        std::exp(log_choose(m, k) + log_beta(k + alpha, m - k + beta) - log_beta(alpha, beta)));
  }
  const IntegerDistribution pooled =
      repeated_sum({.lowest = 0, .probability = std::move(one)}, plan.participants);
  const std::size_t trials = plan.participants * plan.trials_each;
  const std::size_t critical = least_rejected(trials, plan.chance, plan.error);
  if (critical <= trials) answer.rate = pooled.upper_tail(static_cast<std::int64_t>(critical));
  return answer;
}

}  // namespace asperity
