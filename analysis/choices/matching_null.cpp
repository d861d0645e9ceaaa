// Fixed points of random permutations, counted.

#include "analysis/choices/matching_null.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr std::size_t kMostItems = 12;

void refuse_impossible_size(std::size_t items) {
  if (items < 1 || items > kMostItems) {
    throw std::invalid_argument("items is " + std::to_string(items) + "; it must be from 1 to 12");
  }
}

std::uint64_t factorial(std::size_t n) {
  std::uint64_t product = 1;
  for (std::uint64_t i = 2; i <= n; ++i) {
    product *= i;
  }
  return product;
}

std::uint64_t choose(std::size_t n, std::size_t k) {
  return factorial(n) / (factorial(k) * factorial(n - k));
}

// D(j) = (j − 1)·(D(j − 1) + D(j − 2)), D(0) = 1, D(1) = 0.
std::uint64_t derangements(std::size_t n) {
  std::array<std::uint64_t, kMostItems + 1> count{1, 0};
  for (std::size_t j = 2; j <= n; ++j) {
    count[j] = (j - 1) * (count[j - 1] + count[j - 2]);
  }
  return count[n];
}

}  // namespace

double item_chance(std::size_t items) {
  refuse_impossible_size(items);
  return 1.0 / static_cast<double>(items);
}

double whole_chance(std::size_t items) {
  refuse_impossible_size(items);
  return 1.0 / static_cast<double>(factorial(items));
}

std::vector<double> fixed_point_distribution(std::size_t items) {
  refuse_impossible_size(items);
  const std::uint64_t all = factorial(items);
  std::vector<double> probability(items + 1);
  for (std::size_t right = 0; right <= items; ++right) {
    probability[right] = static_cast<double>(choose(items, right) * derangements(items - right)) /
                         static_cast<double>(all);
  }
  return probability;
}

std::size_t fixed_points(MatchingTrial trial) noexcept {
  return static_cast<std::size_t>(
      std::count_if(trial.begin(), trial.end(),
                    [](const MatchedItem& item) { return item.chosen == item.felt; }));
}

bool is_permutation(MatchingTrial trial) {
  for (std::size_t i = 0; i < trial.size(); ++i) {
    bool is_chosen = false;
    for (std::size_t j = 0; j < trial.size(); ++j) {
      if (j != i && trial[j].felt == trial[i].felt) return false;
      is_chosen = is_chosen || trial[j].chosen == trial[i].felt;
    }
    if (!is_chosen) return false;  // as many answers as items: each of them once
  }
  return true;
}

IntegerDistribution chance_matches(MatchingTrial trial) {
  const std::size_t m = trial.size();
  refuse_impossible_size(m);
  struct Copies {
    std::size_t felt = 0;
    std::size_t chosen = 0;
  };
  std::map<std::size_t, Copies> copies{};
  for (const MatchedItem& item : trial) {
    ++copies[item.felt].felt;
    if (item.chosen) ++copies[*item.chosen].chosen;
  }
  std::vector<std::int64_t> marked(m + 1, 0);  // N_j
  marked[0] = 1;
  for (const auto& [label, of] : copies) {
    std::vector<std::int64_t> next(m + 1, 0);
    for (std::size_t i = 0; i <= std::min(of.felt, of.chosen); ++i) {
      const auto ways =
          static_cast<std::int64_t>(choose(of.felt, i) * choose(of.chosen, i) * factorial(i));
      for (std::size_t j = 0; i + j <= m; ++j) next[i + j] += ways * marked[j];
    }
    marked = std::move(next);
  }
  IntegerDistribution distribution{.lowest = 0, .probability = std::vector<double>(m + 1)};
  for (std::size_t k = 0; k <= m; ++k) {
    std::int64_t ways = 0;
    for (std::size_t j = k; j <= m; ++j) {
      const std::int64_t term =
          static_cast<std::int64_t>(choose(j, k) * factorial(m - j)) * marked[j];
      ways += (j - k) % 2 == 0 ? term : -term;
    }
    distribution.probability[k] = static_cast<double>(ways) / static_cast<double>(factorial(m));
  }
  return distribution;
}

MatchingNull::MatchingNull(const Design& design) {
  if (design.assignments < 1) {
    throw std::invalid_argument("assignments is 0; a null distribution needs at least one");
  }
  const IntegerDistribution one{.lowest = 0, .probability = fixed_point_distribution(design.items)};
  sum_ = repeated_sum(one, design.assignments);
}

double MatchingNull::upper_tail(std::size_t right) const {
  return sum_.upper_tail(static_cast<std::int64_t>(right));
}

CountInterval MatchingNull::central_interval(double confidence) const {
  return asperity::central_interval(sum_, confidence);
}

CountInterval central_interval(const IntegerDistribution& distribution, double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
  const double allowed = 0.5 * (1.0 - confidence);
  const std::vector<double>& p = distribution.probability;
  std::size_t low = 0;
  double below = p[low];
  while (below <= allowed) below += p[++low];
  std::size_t high = p.size() - 1;
  double above = p[high];
  while (above <= allowed) above += p[--high];
  const auto first = static_cast<std::size_t>(distribution.lowest);
  return {.low = first + low, .high = first + high};
}

}  // namespace asperity
