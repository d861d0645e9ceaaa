// Counts circular triads from the wins; the exact distribution adds one item at a time to all outcomes.

#include "analysis/choices/circular_triads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity {
namespace {

double triads_of(std::size_t items) {
  const auto k = static_cast<double>(items);
  return k * (k - 1.0) * (k - 2.0) / 6.0;
}

double most_circular_triads(std::size_t items) {
  const auto k = static_cast<double>(items);
  return (items % 2 == 1 ? k * k * k - k : k * k * k - 4.0 * k) / 24.0;
}

void refuse_few_items(std::size_t items) {
  if (items < 3) {
    throw std::invalid_argument("items is " + std::to_string(items) +
                                "; circular triads require at least 3");
  }
}

double circular_triads_of(std::span<const std::size_t> wins) {
  double not_circular = 0.0;
  for (const std::size_t own : wins) {
    const auto s = static_cast<double>(own);
    not_circular += s * (s - 1.0) / 2.0;
  }
  return triads_of(wins.size()) - not_circular;
}

/// How many outcomes of all comparisons give these wins, in increasing order.
using WinsCounts = std::map<std::vector<std::size_t>, double>;

WinsCounts with_another_item(const WinsCounts& smaller, std::size_t items) {
  WinsCounts larger{};
  for (const auto& [wins, count] : smaller) {
    for (std::size_t subset = 0; subset < std::size_t{1} << items; ++subset) {
      std::vector<std::size_t> more = wins;
      std::size_t own = 0;  // wins of the new item, against those that are not in the subset
      for (std::size_t i = 0; i < items; ++i) {
        if ((subset >> i & 1U) == 1U) {
          ++more[i];
        } else {
          ++own;
        }
      }
      more.push_back(own);
      std::sort(more.begin(), more.end());
      larger[more] += count;
    }
  }
  return larger;
}

}  // namespace

Consistency consistency(std::span<const std::size_t> wins) {
  refuse_few_items(wins.size());
  const std::size_t pairs = wins.size() * (wins.size() - 1) / 2;
  const std::size_t sum = std::accumulate(wins.begin(), wins.end(), std::size_t{0});
  if (sum != pairs) {
    throw std::invalid_argument("wins: the sum is " + std::to_string(sum) +
                                "; it must be the number of pairs, " + std::to_string(pairs));
  }
  const double circular = circular_triads_of(wins);
  return {.circular_triads = circular, .zeta = 1.0 - circular / most_circular_triads(wins.size())};
}

double mean_zeta_under_guessing(std::size_t items) {
  refuse_few_items(items);
  const auto k = static_cast<double>(items);
  return 1.0 - k * (k - 1.0) * (k - 2.0) / 24.0 / most_circular_triads(items);
}

WinsOfJudge wins_of_judge(std::span<const Comparison> of_one_judge, std::size_t items) {
  static_cast<void>(count_comparisons(of_one_judge, items));  // refuses impossible comparisons
  std::vector<std::size_t> wins(items);
  std::set<std::pair<std::size_t, std::size_t>> pairs{};
  std::size_t compared = 0;
  bool tied = false;
  for (const Comparison& one : of_one_judge) {
    if (one.times == 0) continue;
    pairs.insert(std::minmax(one.first, one.second));
    compared += one.times;
    tied = tied || !one.winner;
    if (one.winner) wins[*one.winner] += one.times;
  }
  if (tied) return {.problem = IncompletePairs::tie};
  if (2 * pairs.size() < items * (items - 1)) return {.problem = IncompletePairs::pair_missing};
  if (compared > pairs.size()) return {.problem = IncompletePairs::pair_repeated};
  return {.wins = std::move(wins)};
}

IntegerDistribution circular_triad_distribution(std::size_t items) {
  refuse_few_items(items);
  if (items > kMostItemsForExactTriads) {
    throw std::invalid_argument("items is " + std::to_string(items) + "; it must be at most " +
                                std::to_string(kMostItemsForExactTriads));
  }
  WinsCounts counts{{{0}, 1.0}};
  for (std::size_t k = 1; k < items; ++k) counts = with_another_item(counts, k);
  // Whole numbers below 2⁵³ and a power of two: the sums and quotients are exact.
  const double all = std::exp2(static_cast<double>(items * (items - 1) / 2));
  IntegerDistribution distribution{};
  distribution.probability.assign(static_cast<std::size_t>(most_circular_triads(items)) + 1, 0.0);
  for (const auto& [wins, count] : counts) {
    distribution.probability[static_cast<std::size_t>(circular_triads_of(wins))] += count / all;
  }
  return distribution;
}

TriadTest triad_test(std::size_t circular_triads, std::size_t items) {
  refuse_few_items(items);
  const auto d = static_cast<double>(circular_triads);
  const double most = most_circular_triads(items);
  if (d > most) {
    throw std::invalid_argument("circular_triads is " + std::to_string(circular_triads) +
                                " and items is " + std::to_string(items) +
                                "; circular_triads must be at most " +
                                std::to_string(static_cast<std::size_t>(most)));
  }
  TriadTest test{.exact = items <= kMostItemsForExactTriads};
  constexpr std::size_t kFewestForApproximation = 7;
  if (items >= kFewestForApproximation) {
    const double beyond = static_cast<double>(items) - 4.0;
    const double df = 6.0 * triads_of(items) / (beyond * beyond);
    test.approximation = {.value = 8.0 / beyond * (triads_of(items) / 4.0 - d - 0.5) + df,
                          .df = df};
  }
  test.p = test.exact ? circular_triad_distribution(items).lower_tail(
                            static_cast<std::int64_t>(circular_triads))
                      : *upper_tail(*test.approximation);
  return test;
}

std::optional<JudgesAgreement> judges_agreement(const Comparisons& counts) {
  const Eigen::Index items = counts.wins.rows();
  if (items < 2) {
    throw std::invalid_argument("counts: the number of items is " + std::to_string(items) +
                                "; agreement requires at least 2");
  }
  const double m = counts.wins(0, 1) + counts.wins(1, 0);
  if (m < 2.0 || counts.ties.sum() > 0.0) return std::nullopt;
  double sum = 0.0;  // Σ
  for (Eigen::Index i = 0; i < items; ++i) {
    for (Eigen::Index j = 0; j < items; ++j) {
      if (i == j) continue;
      if (counts.wins(i, j) + counts.wins(j, i) != m) return std::nullopt;
      sum += counts.wins(i, j) * (counts.wins(i, j) - 1.0) / 2.0;
    }
  }
  const auto k = static_cast<double>(items);
  const double pairs = k * (k - 1.0) / 2.0;
  const double couples = m * (m - 1.0) / 2.0;
  const auto judges = static_cast<std::size_t>(m);
  JudgesAgreement answer{.judges = judges,
                         .u = 2.0 * sum / (pairs * couples) - 1.0,
                         .least = judges % 2 == 0 ? -1.0 / (m - 1.0) : -1.0 / m};
  IntegerDistribution of_pair{.probability =
                                  std::vector<double>(static_cast<std::size_t>(couples) + 1, 0.0)};
  for (std::size_t first = 0; first <= judges; ++first) {
    const auto before = static_cast<double>(first);
    const double after = m - before;
    const double agreements = before * (before - 1.0) / 2.0 + after * (after - 1.0) / 2.0;
    of_pair.probability[static_cast<std::size_t>(agreements)] +=
        std::exp(log_choose(m, before) - m * std::log(2.0));
  }
  answer.p = std::min(1.0, repeated_sum(of_pair, static_cast<std::uint64_t>(pairs))
                               .upper_tail(static_cast<std::int64_t>(sum)));
  if (m > 2.0) {
    const double beyond = m - 2.0;
    answer.approximation = {
        .value = 4.0 / beyond * (sum - pairs * couples * (m - 3.0) / (2.0 * beyond)),
        .df = pairs * m * (m - 1.0) / (beyond * beyond)};
  }
  return answer;
}

}  // namespace asperity
