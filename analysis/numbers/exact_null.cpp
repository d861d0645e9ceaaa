// Counting by convolution; what is the same but for the order of labels is counted once.

#include "analysis/numbers/exact_null.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "analysis/numbers/matrix_place.h"

namespace asperity {

double IntegerDistribution::mean() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    sum += static_cast<double>(lowest + static_cast<std::int64_t>(i)) * probability[i];
  }
  return sum;
}

double IntegerDistribution::variance() const {
  const double middle = mean();
  double sum = 0.0;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    const double from = static_cast<double>(lowest + static_cast<std::int64_t>(i)) - middle;
    sum += from * from * probability[i];
  }
  return sum;
}

double IntegerDistribution::at(std::int64_t value) const {
  const std::int64_t index = value - lowest;
  if (index < 0 || index >= static_cast<std::int64_t>(probability.size())) return 0.0;
  return probability[static_cast<std::size_t>(index)];
}

double IntegerDistribution::upper_tail(std::int64_t value) const {
  if (value <= lowest) return 1.0;
  double sum = 0.0;
  const auto first = static_cast<std::size_t>(value - lowest);
  for (std::size_t i = probability.size(); i-- > first;) sum += probability[i];  // smallest first
  return std::min(1.0, sum);  // rounding may leave a little more
}

double IntegerDistribution::lower_tail(std::int64_t value) const {
  const auto highest = lowest + static_cast<std::int64_t>(probability.size()) - 1;
  if (value >= highest) return 1.0;
  double sum = 0.0;
  for (std::int64_t i = lowest; i <= value; ++i) sum += at(i);
  return std::min(1.0, sum);
}

IntegerDistribution sum_of(const IntegerDistribution& a, const IntegerDistribution& b) {
  IntegerDistribution sum{
      .lowest = a.lowest + b.lowest,
      .probability = std::vector<double>(a.probability.size() + b.probability.size() - 1)};
  // Nearly all the time of an exact test.
  const auto count = static_cast<Eigen::Index>(b.probability.size());
  const Eigen::Map<const Eigen::ArrayXd> terms(b.probability.data(), count);
  for (std::size_t i = 0; i < a.probability.size(); ++i) {
    Eigen::Map<Eigen::ArrayXd>(sum.probability.data() + i, count) += a.probability[i] * terms;
  }
  constexpr double kNever = 1e-300;
  constexpr double kNeverOfMany = 1e-40;
  constexpr std::size_t kMany = 10'000;
  std::vector<double>& p = sum.probability;
  const double least = p.size() > kMany ? kNeverOfMany : kNever;
  const auto probable = [least](double one) { return one > least; };
  p.erase(std::find_if(p.rbegin(), p.rend(), probable).base(), p.end());
  const auto first = std::find_if(p.begin(), p.end(), probable);
  sum.lowest += first - p.begin();
  p.erase(p.begin(), first);
  return sum;
}

IntegerDistribution repeated_sum(const IntegerDistribution& one, std::uint64_t times) {
  // From the first binary digit of `times` on: every large sum is of two halves, and what is added
  // to one for a digit is narrow.
  IntegerDistribution sum{};
  for (int digit = static_cast<int>(std::bit_width(times)) - 1; digit >= 0; --digit) {
    sum = sum_of(sum, sum);
    if ((times >> digit & 1U) == 1) sum = sum_of(one, sum);
  }
  return sum;
}

IntegerDistribution sum_of_all(std::span<const IntegerDistribution> numbers) {
  std::map<std::pair<std::int64_t, std::vector<double>>, std::uint64_t> times{};
  for (const IntegerDistribution& one : numbers) ++times[{one.lowest, one.probability}];
  IntegerDistribution sum{};
  for (const auto& [one, count] : times) {
    sum = sum_of(sum, repeated_sum({.lowest = one.first, .probability = one.second}, count));
  }
  return sum;
}

namespace {

SignFlipTest random_sign_flips(std::span<const std::int64_t> differences, Random& random) {
  const auto n = static_cast<double>(differences.size());
  const int draws = static_cast<int>(std::clamp(1e8 / n, 999.0, 9999.0));
  const std::int64_t observed =
      std::accumulate(differences.begin(), differences.end(), std::int64_t{0});
  int as_large = 1;
  int as_far = 1;
  for (int draw = 0; draw < draws; ++draw) {
    std::int64_t sum = 0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      if (i % 64 == 0) bits = random.bits();
      sum += (bits >> (i % 64) & 1U) != 0 ? differences[i] : -differences[i];
    }
    as_large += sum >= observed ? 1 : 0;
    as_far += std::abs(sum) >= std::abs(observed) ? 1 : 0;
  }
  return {.two_sided = as_far / (draws + 1.0),
          .upper = as_large / (draws + 1.0),
          .smallest = 1.0 / (draws + 1.0),
          .exact = false,
          .drawn = static_cast<std::size_t>(draws)};
}

}  // namespace

// The sum is 2·t − Σ|d| with t the part of Σ|d| whose signs are positive.
SignFlipTest sign_flip_test(std::span<const std::int64_t> differences, Random random) {
  constexpr double kMostSteps = 1e9;
  std::int64_t whole = 0;
  std::int64_t sum = 0;
  for (const std::int64_t difference : differences) {
    whole += std::abs(difference);
    sum += difference;
  }
  if (static_cast<double>(whole) * static_cast<double>(differences.size()) > kMostSteps) {
    return random_sign_flips(differences, random);
  }
  std::vector<double> p{1.0};  // of t
  p.reserve(static_cast<std::size_t>(whole) + 1);
  for (const std::int64_t difference : differences) {
    const auto size = static_cast<std::size_t>(std::abs(difference));
    if (size == 0) continue;
    p.resize(p.size() + size);
    for (std::size_t t = p.size(); t-- > 0;) {
      p[t] = 0.5 * p[t] + (t < size ? 0.0 : 0.5 * p[t - size]);
    }
  }
  const IntegerDistribution positive{.lowest = 0, .probability = std::move(p)};
  SignFlipTest test{};
  test.smallest = std::min(1.0, 2.0 * positive.smallest_upper_tail());
  test.upper = positive.upper_tail((whole + sum) / 2);
  if (sum != 0) {
    // Of an odd number of units of ±1 with a sum of ±1 the tail is one half, and a little by rounding.
    test.two_sided = std::min(1.0, 2.0 * positive.upper_tail((whole + std::abs(sum)) / 2));
  }
  return test;
}

namespace {

// Totals in descending order. A string, because strings have a hash and short ones no heap.
using Totals = std::u16string;
using TotalsDistribution = std::unordered_map<Totals, double>;

// All different orders of a unit's counts; nothing when there are too many to count.
constexpr std::size_t kMostOrders = 50'000;
std::vector<Totals> relabellings(const CountMatrix& counts, Eigen::Index unit) {
  Totals row{};
  for (Eigen::Index label = 0; label < counts.cols(); ++label) {
    row += static_cast<char16_t>(counts(unit, label));
  }
  std::sort(row.begin(), row.end());
  std::vector<Totals> all{};
  do {
    if (all.size() == kMostOrders) return {};
    all.push_back(row);
  } while (std::next_permutation(row.begin(), row.end()));
  return all;
}

// How many they are: K!/Π m! with m how often each count stands.
double number_of_relabellings(const CountMatrix& counts, Eigen::Index unit) {
  std::vector<std::int64_t> row(static_cast<std::size_t>(counts.cols()));
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = counts(unit, static_cast<Eigen::Index>(i));
  std::sort(row.begin(), row.end());
  double orders = 1.0;
  double equal = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    equal = i > 0 && row[i] == row[i - 1] ? equal + 1.0 : 1.0;
    orders *= static_cast<double>(i + 1) / equal;
  }
  return orders;
}

std::int64_t sum_of_squares(const CountMatrix& counts) {
  return counts.colwise().sum().array().square().sum();
}

RelabellingTest random_relabellings(const CountMatrix& counts, Random& random) {
  const auto cells = static_cast<double>(counts.size());
  const int draws = static_cast<int>(std::clamp(3e7 / cells, 199.0, 99'999.0));
  const std::int64_t observed = sum_of_squares(counts);
  const auto labels = static_cast<std::size_t>(counts.cols());
  int as_extreme = 1;
  std::vector<std::int64_t> row(labels);
  std::vector<std::int64_t> totals(labels);
  for (int draw = 0; draw < draws; ++draw) {
    std::fill(totals.begin(), totals.end(), 0);
    for (Eigen::Index unit = 0; unit < counts.rows(); ++unit) {
      for (std::size_t i = 0; i < labels; ++i) row[i] = counts(unit, static_cast<Eigen::Index>(i));
      random.shuffle(std::span(row));
      for (std::size_t i = 0; i < labels; ++i) totals[i] += row[i];
    }
    const std::int64_t squares =
        std::inner_product(totals.begin(), totals.end(), totals.begin(), std::int64_t{0});
    if (squares >= observed) ++as_extreme;
  }
  return {.p = static_cast<double>(as_extreme) / (draws + 1.0),
          .smallest = 1.0 / (draws + 1.0),
          .exact = false,
          .drawn = static_cast<std::size_t>(draws)};
}

}  // namespace

RelabellingTest relabelling_test(const CountMatrix& counts, Random random) {
  if (counts.cols() < 1)
    throw std::invalid_argument("counts has no column; at least one label is needed");
  if (counts.size() > 0 && counts.minCoeff() < 0) {
    throw std::invalid_argument("counts: the count in " +
                                place_of_first(counts, [](auto value) { return value < 0; }) +
                                " is negative; all must be at least 0");
  }
  constexpr double kMostSteps = 2e7;
  constexpr std::int64_t kLargestTotal = 65535;
  if (counts.sum() > kLargestTotal) return random_relabellings(counts, random);
  double relabellings_left = 0.0;
  for (Eigen::Index unit = 0; unit < counts.rows(); ++unit) {
    relabellings_left += number_of_relabellings(counts, unit);
  }
  TotalsDistribution now{{Totals(static_cast<std::size_t>(counts.cols()), u'\0'), 1.0}};
  double steps = 0.0;
  for (Eigen::Index unit = 0; unit < counts.rows(); ++unit) {
    // Adding a unit's counts in descending order keeps different totals different: there are never
    // fewer of them, so that what is certain to be too much is given up before it is done.
    const auto so_far = static_cast<double>(now.size());
    if (steps + so_far * relabellings_left > kMostSteps) {
      return random_relabellings(counts, random);
    }
    const std::vector<Totals> additions = relabellings(counts, unit);
    if (additions.empty()) return random_relabellings(counts, random);
    steps += so_far * static_cast<double>(additions.size());
    relabellings_left -= static_cast<double>(additions.size());
    TotalsDistribution next{};
    next.reserve(2 * now.size());
    for (const auto& [totals, probability] : now) {
      const double share = probability / static_cast<double>(additions.size());
      for (const Totals& addition : additions) {
        Totals sum = totals;
        for (std::size_t i = 0; i < sum.size(); ++i) {
          sum[i] = static_cast<char16_t>(sum[i] + addition[i]);
        }
        std::sort(sum.begin(), sum.end(), std::greater<>());
        next[sum] += share;
      }
    }
    now = std::move(next);
  }
  const std::int64_t observed = sum_of_squares(counts);
  double p = 0.0;
  std::map<std::int64_t, double> of_squares{};
  for (const auto& [totals, probability] : now) {
    std::int64_t squares = 0;
    for (const char16_t total : totals) squares += std::int64_t{total} * std::int64_t{total};
    of_squares[squares] += probability;
    if (squares >= observed) p += probability;
  }
  return {.p = std::min(1.0, p), .smallest = std::min(1.0, of_squares.rbegin()->second)};
}

namespace {

/// Walks over all counts of `n` choices in descending order.
class UniformCounts final {
 public:
  explicit UniformCounts(std::span<const std::uint64_t> counts)
      : n_(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0})),
        alternatives_(counts.size()),
        log_factorial_(std::max<std::size_t>(n_, counts.size()) + 1) {
    for (std::size_t i = 1; i < log_factorial_.size(); ++i) {
      log_factorial_[i] = std::lgamma(static_cast<double>(i) + 1.0);
    }
    observed_ = log_probability(0.0);
    for (const std::uint64_t count : counts) {
      observed_ -= log_factorial_[count];
      observed_squares_ += count * count;
    }
  }

  MultinomialTest test() {
    walk({.left = n_, .most = n_, .alternatives = alternatives_});
    result_.by_probability = std::min(1.0, by_probability_);
    result_.by_chi_squared = std::min(1.0, by_chi_squared_);
    return result_;
  }

 private:
  struct Walk {
    std::uint64_t left = 0;
    std::uint64_t most = 0;
    std::size_t alternatives = 0;
    std::size_t equal = 0;          ///< how many of the last count so far
    double log_denominator = 0.0;   ///< Σ ln x_j! so far
    double log_arrangements = 0.0;  ///< Σ ln (how often a count stands)!
    std::uint64_t squares = 0;
  };

  double log_probability(double log_denominator) const {
    return log_factorial_[n_] - log_denominator -
           static_cast<double>(n_) * std::log(static_cast<double>(alternatives_));
  }

  void walk(const Walk& so_far) {
    if (so_far.alternatives == 0) {
      const double log_p = log_probability(so_far.log_denominator);
      const double arrangements =
          log_factorial_[alternatives_] - so_far.log_arrangements - log_factorial_[so_far.equal];
      const double p = std::exp(log_p + arrangements);
      if (log_p <= observed_ + 1e-7) by_probability_ += p;
      if (so_far.squares >= observed_squares_) by_chi_squared_ += p;
      return;
    }
    const std::uint64_t least = (so_far.left + so_far.alternatives - 1) / so_far.alternatives;
    for (std::uint64_t count = std::min(so_far.left, so_far.most);; --count) {
      Walk next = so_far;
      next.left -= count;
      --next.alternatives;
      next.log_denominator += log_factorial_[count];
      next.squares += count * count;
      const bool again = count == so_far.most && so_far.alternatives < alternatives_;
      if (!again) next.log_arrangements += log_factorial_[so_far.equal];
      next.equal = again ? so_far.equal + 1 : 1;
      next.most = count;
      walk(next);
      if (count <= least) return;
    }
  }

  std::uint64_t n_ = 0;
  std::size_t alternatives_ = 0;
  std::vector<double> log_factorial_{};
  double observed_ = 0.0;
  std::uint64_t observed_squares_ = 0;
  double by_probability_ = 0.0;
  double by_chi_squared_ = 0.0;
  MultinomialTest result_{};
};

// About how many partitions of n into K parts there are: C(n + K − 1, K − 1)/K!.
double kinds_of_counts(double n, double alternatives) {
  return std::exp(std::lgamma(n + alternatives) - std::lgamma(alternatives) - std::lgamma(n + 1.0) -
                  std::lgamma(alternatives + 1.0));
}

}  // namespace

MultinomialTest uniform_multinomial_test(std::span<const std::uint64_t> counts) {
  if (counts.empty())
    throw std::invalid_argument("counts is empty; at least one alternative is needed");
  constexpr double kMostKinds = 1e6;
  const auto n =
      static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  if (kinds_of_counts(n, static_cast<double>(counts.size())) > kMostKinds) {
    return {.counted = false};
  }
  return UniformCounts(counts).test();
}

}  // namespace asperity
