// Implements the search for an order: rejection sampling first, then depth-first search over kinds of trials.

#include "protocols/plan/trial_order.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace asperity {

namespace {

constexpr int kWholeShuffles = 200;
constexpr int kSearches = 8;
constexpr std::size_t kRandomSteps = 5'000;
constexpr std::size_t kExactSteps = 100'000;

/// Searches for an order depth-first. Trials that no constraint distinguishes are one kind, so that the search does not
/// try them in turn.
class Search {
 public:
  Search(const OrderProblem& problem, Random* random) : problem_(problem), random_(random) {
    std::map<std::vector<std::size_t>, std::size_t> kinds{};
    const std::size_t groups = problem.trials / problem.group_size;
    for (std::size_t trial = 0; trial < problem.trials; ++trial) {
      std::vector<std::size_t> levels{};
      for (const RowLimit& limit : problem.limits) levels.push_back(limit.level_of_trial[trial]);
      std::vector<std::size_t> distant{};
      for (const LevelDistance& each : problem.distances) {
        distant.push_back(each.level_of_trial[trial]);
      }
      std::vector<std::size_t> key = levels;
      key.insert(key.end(), distant.begin(), distant.end());
      for (const FixedPlace& place : problem.places) key.push_back(place.allows_trial[trial]);
      const auto [found, is_new] = kinds.emplace(std::move(key), kinds.size());
      if (is_new) {
        levels_.push_back(levels);
        distant_levels_.push_back(std::move(distant));
        examples_.push_back(trial);
        members_.emplace_back(groups);
      }
      members_[found->second][trial / problem.group_size].push_back(trial);
    }
    if (random_ != nullptr) {
      for (auto& by_group : members_) {
        for (auto& members : by_group) random_->shuffle(std::span<std::size_t>(members));
      }
    }
    runs_.assign(problem.limits.size(), Run{});
    ages_.resize(problem.distances.size());
    for (std::size_t i = 0; i < ages_.size(); ++i) {
      const std::vector<std::size_t>& all = problem.distances[i].level_of_trial;
      // As if every level had been presented long ago.
      ages_[i].assign(*std::max_element(all.begin(), all.end()) + 1, problem.distances[i].minimum);
    }
    left_.resize(levels_.size());
    load_group(0);
  }

  std::optional<std::vector<std::size_t>> find(std::size_t steps) {
    steps_ = steps;
    if (!descend(0)) return std::nullopt;
    std::vector<std::vector<std::size_t>> used(levels_.size(),
                                               std::vector<std::size_t>(members_[0].size(), 0));
    std::vector<std::size_t> order{};
    for (std::size_t position = 0; position < problem_.trials; ++position) {
      const std::size_t group = position / problem_.group_size;
      const std::size_t kind = chosen_[position];
      order.push_back(members_[kind][group][used[kind][group]++]);
    }
    return order;
  }

 private:
  struct Run {
    std::size_t level = 0;
    std::size_t length = 0;
    auto operator<=>(const Run&) const = default;
  };

  void load_group(std::size_t group) {
    for (std::size_t kind = 0; kind < levels_.size(); ++kind) {
      left_[kind] = members_[kind][group].size();
    }
  }

  bool allowed(std::size_t kind, std::size_t position) const {
    for (std::size_t i = 0; i < ages_.size(); ++i) {
      if (ages_[i][distant_levels_[kind][i]] < problem_.distances[i].minimum) return false;
    }
    for (const FixedPlace& place : problem_.places) {
      if (place.position == position && !place.allows_trial[examples_[kind]]) return false;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (runs_[i].length >= problem_.limits[i].maximum && runs_[i].level == levels_[kind][i]) {
        return false;
      }
    }
    return true;
  }

  /// A necessary condition for the rest of the group, checked for each limit (and sufficient for a single limit): the
  /// trials of a level fit into the gaps between the others.
  bool promising(std::size_t position) const {
    const std::size_t end = (position / problem_.group_size + 1) * problem_.group_size;
    if (!places_can_be_filled(position, end) || !distances_fit(position, end)) return false;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      std::map<std::size_t, std::size_t> of_level{};
      std::size_t all = 0;
      for (std::size_t kind = 0; kind < levels_.size(); ++kind) {
        of_level[levels_[kind][i]] += left_[kind];
        all += left_[kind];
      }
      const std::size_t maximum = problem_.limits[i].maximum;
      for (const auto& [level, count] : of_level) {
        const std::size_t before =
            runs_[i].level == level ? maximum - std::min(maximum, runs_[i].length) : maximum;
        if (count > before + maximum * (all - count)) return false;
      }
    }
    return true;
  }

  /// Whether a remaining trial of the group fits every fixed place in it.
  bool places_can_be_filled(std::size_t position, std::size_t end) const {
    for (const FixedPlace& place : problem_.places) {
      if (place.position < position || place.position >= end) continue;
      bool is_filled = false;
      for (std::size_t kind = 0; kind < left_.size(); ++kind) {
        is_filled = is_filled || (left_[kind] > 0 && place.allows_trial[examples_[kind]]);
      }
      if (!is_filled) return false;
    }
    return true;
  }

  /// Whether the remaining trials of each level fit before the end of the group: c of them at a distance of d need
  /// (c − 1)·d + 1 positions, from the first one that the last trial of the level allows.
  bool distances_fit(std::size_t position, std::size_t end) const {
    for (std::size_t i = 0; i < ages_.size(); ++i) {
      std::vector<std::size_t> count(ages_[i].size());
      for (std::size_t kind = 0; kind < left_.size(); ++kind) {
        count[distant_levels_[kind][i]] += left_[kind];
      }
      const std::size_t minimum = problem_.distances[i].minimum;
      for (std::size_t level = 0; level < count.size(); ++level) {
        if (count[level] == 0) continue;
        const std::size_t first = position + minimum - ages_[i][level];
        if (first + (count[level] - 1) * minimum >= end) return false;
      }
    }
    return true;
  }

  /// The kinds that may come next; a kind with more remaining trials is more likely to come first.
  std::vector<std::size_t> candidates(std::size_t position) {
    std::vector<std::size_t> kinds{};
    for (std::size_t kind = 0; kind < levels_.size(); ++kind) {
      if (left_[kind] > 0 && allowed(kind, position)) kinds.push_back(kind);
    }
    if (random_ == nullptr) {
      std::stable_sort(kinds.begin(), kinds.end(),
                       [this](std::size_t a, std::size_t b) { return left_[a] > left_[b]; });
      return kinds;
    }
    for (std::size_t i = 0; i + 1 < kinds.size(); ++i) {
      std::uint64_t total = 0;
      for (std::size_t j = i; j < kinds.size(); ++j) total += left_[kinds[j]];
      std::uint64_t drawn = random_->below(total);
      std::size_t j = i;
      while (drawn >= left_[kinds[j]]) drawn -= left_[kinds[j++]];
      std::swap(kinds[i], kinds[j]);
    }
    return kinds;
  }

  bool descend(std::size_t position) {
    if (position == problem_.trials) return true;
    if (steps_ == 0) return false;
    --steps_;
    if (!promising(position)) return false;
    const State state{position, left_, runs_, ages_};
    if (failed_.contains(state)) return false;
    const std::vector<Run> runs = runs_;
    const std::vector<std::size_t> left = left_;
    const std::vector<std::vector<std::size_t>> ages = ages_;
    for (const std::size_t kind : candidates(position)) {
      chosen_.push_back(kind);
      --left_[kind];
      for (std::size_t i = 0; i < runs_.size(); ++i) {
        const std::size_t level = levels_[kind][i];
        runs_[i] = {level,
                    runs_[i].length > 0 && runs_[i].level == level ? runs_[i].length + 1 : 1};
      }
      for (std::size_t i = 0; i < ages_.size(); ++i) {
        ages_[i][distant_levels_[kind][i]] = 0;
        for (std::size_t& age : ages_[i]) age = std::min(age + 1, problem_.distances[i].minimum);
      }
      const std::size_t next = position + 1;
      if (next % problem_.group_size == 0 && next < problem_.trials) {
        load_group(next / problem_.group_size);
      }
      if (descend(next)) return true;
      chosen_.pop_back();
      left_ = left;
      runs_ = runs;
      ages_ = ages;
      if (steps_ == 0) return false;
    }
    failed_.insert(state);
    return false;
  }

  const OrderProblem& problem_;
  Random* random_ = nullptr;
  std::vector<std::vector<std::size_t>> levels_{};                ///< of a kind, by limit
  std::vector<std::vector<std::size_t>> distant_levels_{};        ///< of a kind, by distance
  std::vector<std::size_t> examples_{};                           ///< one trial of a kind
  std::vector<std::vector<std::vector<std::size_t>>> members_{};  ///< trials by kind and group
  std::vector<std::size_t> left_{};  ///< of a kind in this group, not yet placed
  std::vector<Run> runs_{};          ///< by limit
  /// By distance and level: positions since the last trial of the level, at most the minimum.
  std::vector<std::vector<std::size_t>> ages_{};
  std::vector<std::size_t> chosen_{};
  /// The position, and what decides whether the rest can be ordered from there.
  using State = std::tuple<std::size_t, std::vector<std::size_t>, std::vector<Run>,
                           std::vector<std::vector<std::size_t>>>;
  std::set<State> failed_{};
  std::size_t steps_ = 0;
};

std::vector<std::size_t> whole_shuffle(const OrderProblem& problem, Random& random) {
  std::vector<std::size_t> order(problem.trials);
  for (std::size_t i = 0; i < problem.trials; ++i) order[i] = i;
  for (std::size_t from = 0; from < problem.trials; from += problem.group_size) {
    random.shuffle(std::span<std::size_t>(order).subspan(from, problem.group_size));
  }
  return order;
}

}  // namespace

bool meets(const OrderProblem& problem, const std::vector<std::size_t>& order) {
  for (const RowLimit& limit : problem.limits) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool same =
          i > 0 && limit.level_of_trial[order[i]] == limit.level_of_trial[order[i - 1]];
      length = same ? length + 1 : 1;
      if (length > limit.maximum) return false;
    }
  }
  for (const LevelDistance& distance : problem.distances) {
    std::map<std::size_t, std::size_t> last{};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto [found, is_first] = last.emplace(distance.level_of_trial[order[i]], i);
      if (!is_first && i - found->second < distance.minimum) return false;
      found->second = i;
    }
  }
  for (const FixedPlace& place : problem.places) {
    if (place.position >= order.size() || !place.allows_trial[order[place.position]]) return false;
  }
  return true;
}

std::optional<std::vector<std::size_t>> some_order(const OrderProblem& problem) {
  if (problem.trials == 0) return std::vector<std::size_t>{};
  return Search(problem, nullptr).find(kExactSteps);
}

std::optional<std::vector<std::size_t>> random_order(const OrderProblem& problem, Random random) {
  if (problem.trials == 0) return std::vector<std::size_t>{};
  for (int i = 0; i < kWholeShuffles; ++i) {
    std::vector<std::size_t> order = whole_shuffle(problem, random);
    if (meets(problem, order)) return order;
  }
  for (int i = 0; i < kSearches; ++i) {
    if (auto order = Search(problem, &random).find(kRandomSteps)) return order;
  }
  return some_order(problem);
}

}  // namespace asperity
