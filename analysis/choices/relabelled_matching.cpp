// Sums over permutations by dynamic programming; independent groups of items by convolution.

#include "analysis/choices/relabelled_matching.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity {
namespace {

constexpr std::size_t kMostExchanged = 12;

double permutations_of(std::size_t items) {
  double product = 1.0;
  for (std::size_t i = 2; i <= items; ++i) product *= static_cast<double>(i);
  return product;
}

/// Σ_b counts(σ(b), b) over all permutations σ. `ways[used]`: of so many permutations of the first answers onto the
/// items in the set `used`; whole numbers, exact up to 12!.
IntegerDistribution sums_over_permutations(const CountMatrix& counts) {
  const auto items = static_cast<std::size_t>(counts.rows());
  std::vector<std::vector<double>> ways(std::size_t{1} << items);
  ways[0] = {1.0};
  for (std::size_t used = 0; used + 1 < ways.size(); ++used) {
    const std::vector<double> so_far = std::exchange(ways[used], {});
    const Eigen::Index answer = std::popcount(used);
    for (std::size_t item = 0; item < items; ++item) {
      const std::size_t next = used | std::size_t{1} << item;
      if (next == used) continue;
      const auto right = static_cast<std::size_t>(counts(static_cast<Eigen::Index>(item), answer));
      std::vector<double>& sums = ways[next];
      sums.resize(std::max(sums.size(), so_far.size() + right));
      for (std::size_t i = 0; i < so_far.size(); ++i) sums[i + right] += so_far[i];
    }
  }
  IntegerDistribution distribution{.lowest = 0, .probability = std::move(ways.back())};
  for (double& probability : distribution.probability) probability /= permutations_of(items);
  return distribution;
}

/// Either of two numbers of right trials; what `probability` leaves is 0.
void add_possible(std::uint64_t right, double probability, std::vector<double>& distribution) {
  distribution.resize(std::max<std::size_t>(distribution.size(), right + 1));
  distribution[right] += probability;
  distribution[0] -= probability;
}

}  // namespace

RelabelledMatching::RelabelledMatching(std::span<const RepeatedTrial> trials) {
  std::map<std::vector<std::size_t>, std::size_t> sets{};  // of items felt together
  std::vector<std::size_t> set_of_trial{};
  for (const RepeatedTrial& trial : trials) {
    std::vector<std::size_t> felt{};
    for (const MatchedItem& item : trial.items) felt.push_back(item.felt);
    std::sort(felt.begin(), felt.end());
    felt.erase(std::unique(felt.begin(), felt.end()), felt.end());
    set_of_trial.push_back(sets.try_emplace(std::move(felt), sets.size()).first->second);
  }
  std::map<std::size_t, std::vector<std::size_t>> sets_of_item{};
  for (const auto& [items, set] : sets) {
    for (const std::size_t item : items) sets_of_item[item].push_back(set);
  }
  std::map<std::vector<std::size_t>, std::size_t> group_of_sets{};
  for (auto& [item, own] : sets_of_item) {
    std::sort(own.begin(), own.end());
    const std::size_t group = group_of_sets.try_emplace(own, group_of_sets.size()).first->second;
    exchanged_.resize(group_of_sets.size());
    exchanged_[group].items.push_back(item);
    group_of_[item] = group;
  }
  for (Exchanged& group : exchanged_) {
    const std::size_t items = group.items.size();
    if (items > kMostExchanged) {
      throw std::invalid_argument("trials: a set has " + std::to_string(items) +
                                  " items, and at most " + std::to_string(kMostExchanged) +
                                  " are possible; present fewer items in a trial");
    }
    group.chosen =
        CountMatrix::Zero(static_cast<Eigen::Index>(items), static_cast<Eigen::Index>(items));
  }
  const auto place = [this](std::size_t item) {
    const std::vector<std::size_t>& items = exchanged_[group_of_.at(item)].items;
    return static_cast<Eigen::Index>(std::lower_bound(items.begin(), items.end(), item) -
                                     items.begin());
  };
  for (const RepeatedTrial& trial : trials) {
    for (const MatchedItem& item : trial.items) {
      if (!item.chosen) continue;
      const auto chosen = group_of_.find(*item.chosen);
      if (chosen == group_of_.end() || chosen->second != group_of_.at(item.felt)) continue;
      exchanged_[chosen->second].chosen(place(item.felt), place(*item.chosen)) +=
          static_cast<std::int64_t>(trial.times);
    }
  }
  for (const Exchanged& group : exchanged_) {
    right_ = sum_of(right_, sums_over_permutations(group.chosen));
  }
  const bool are_disjoint = std::all_of(sets_of_item.begin(), sets_of_item.end(),
                                        [](const auto& of) { return of.second.size() == 1; });
  if (!are_disjoint) return;
  // Each set is one group: its permutations exclude each other.
  std::vector<std::map<std::vector<std::size_t>, std::uint64_t>> times_of(sets.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!is_permutation(trials[i].items)) return;
    std::vector<std::pair<std::size_t, std::size_t>> pairs{};
    for (const MatchedItem& item : trials[i].items) pairs.emplace_back(item.felt, *item.chosen);
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::size_t> chosen{};
    for (const auto& [felt, answer] : pairs) chosen.push_back(answer);
    times_of[set_of_trial[i]][chosen] += trials[i].times;
  }
  whole_.emplace();
  for (const auto& permutations : times_of) {
    std::vector<double> one{1.0};
    for (const auto& [chosen, times] : permutations) {
      add_possible(times, 1.0 / permutations_of(chosen.size()), one);
    }
    whole_ = sum_of(*whole_, {.lowest = 0, .probability = std::move(one)});
  }
}

IntegerDistribution RelabelledMatching::right_of(std::size_t felt) const {
  const Exchanged& group = exchanged_.at(group_of_.at(felt));
  const auto row = static_cast<Eigen::Index>(
      std::lower_bound(group.items.begin(), group.items.end(), felt) - group.items.begin());
  IntegerDistribution distribution{.lowest = 0, .probability = {}};
  for (Eigen::Index answer = 0; answer < group.chosen.cols(); ++answer) {
    const auto right = static_cast<std::size_t>(group.chosen(row, answer));
    distribution.probability.resize(std::max(distribution.probability.size(), right + 1));
    distribution.probability[right] += 1.0 / static_cast<double>(group.items.size());
  }
  return distribution;
}

}  // namespace asperity
