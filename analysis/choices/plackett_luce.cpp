// Fits each ranking as successive choices from the remaining items, by a conditional logit.

#include "analysis/choices/plackett_luce.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/choices/comparison_graph.h"

namespace asperity {
namespace {

/// Calls `use(ranking, taken, left)` at every stage with two items or more.
template <class Use>
void for_each_stage(std::span<const Ranking> rankings, Use use) {
  for (const Ranking& ranking : rankings) {
    std::vector<std::size_t> left = ranking.behind;
    left.insert(left.end(), ranking.ranked.rbegin(), ranking.ranked.rend());  // the best last
    for (const std::size_t taken : ranking.ranked) {
      if (left.size() < 2) break;
      use(ranking, taken, left);
      left.pop_back();
    }
  }
}

}  // namespace

RankingCounts count_stages(std::span<const Ranking> rankings, std::size_t items) {
  const auto size = static_cast<Eigen::Index>(items);
  RankingCounts counts{.wins = Eigen::MatrixXd::Zero(size, size)};
  for (const Ranking& ranking : rankings) {
    std::vector<std::size_t> all = ranking.ranked;
    all.insert(all.end(), ranking.behind.begin(), ranking.behind.end());
    std::sort(all.begin(), all.end());
    if ((!all.empty() && all.back() >= items) ||
        std::adjacent_find(all.begin(), all.end()) != all.end()) {
      throw std::invalid_argument(
          "rankings: one has an item twice or out of range; its items must differ and be below " +
          std::to_string(items));
    }
  }
  for_each_stage(rankings, [&counts](const Ranking& ranking, std::size_t taken,
                                     const std::vector<std::size_t>& left) {
    counts.stages += ranking.times;
    for (const std::size_t item : left) {
      if (item == taken) continue;
      counts.wins(static_cast<Eigen::Index>(taken), static_cast<Eigen::Index>(item)) +=
          static_cast<double>(ranking.times);
    }
  });
  return counts;
}

std::optional<PlackettLuce> plackett_luce(std::span<const Ranking> rankings, std::size_t items) {
  const RankingCounts counts = count_stages(rankings, items);
  if (items < 2 || !strongly_connected(counts.wins)) return std::nullopt;
  // Choices of one participant from the same set add up: they have the same probabilities.
  std::map<std::pair<std::size_t, std::vector<std::size_t>>, std::vector<double>> choices{};
  std::pair<std::size_t, std::vector<std::size_t>> set{};
  for_each_stage(rankings, [&](const Ranking& ranking, std::size_t taken,
                               const std::vector<std::size_t>& left) {
    set.first = ranking.participant;
    set.second = left;
    std::sort(set.second.begin(), set.second.end());
    std::vector<double>& times = choices[set];
    times.resize(left.size());
    const auto place = std::lower_bound(set.second.begin(), set.second.end(), taken);
    times[static_cast<std::size_t>(place - set.second.begin())] +=
        static_cast<double>(ranking.times);
  });
  ChoiceData data{};
  std::vector<std::size_t> clusters{};
  for (const auto& [of, times] : choices) {
    data.begin_stratum();
    clusters.push_back(of.first);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::size_t item = of.second[i];
      if (item == 0) {
        data.add(times[i], {});
      } else {
        data.add(times[i], {{item - 1, 1.0}});
      }
    }
  }
  const std::optional<ConditionalLogit> fit = conditional_logit(data);
  if (!fit) return std::nullopt;
  const auto size = static_cast<Eigen::Index>(items);
  const auto with_first = [size](const Eigen::MatrixXd& covariance) {
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(size, size);
    whole.bottomRightCorner(size - 1, size - 1) = covariance;
    return whole;
  };
  PlackettLuce result{.log_worths = {.value = Eigen::VectorXd::Zero(size),
                                     .covariance = with_first(fit->covariance)},
                      .log_likelihood = fit->log_likelihood};
  result.log_worths.value.tail(size - 1) = fit->coefficients;
  result.clustered = {.value = result.log_worths.value,
                      .covariance = with_first(clustered_covariance(*fit, data, clusters))};
  result.centred_errors =
      clustered_errors(*fit, data, clusters, centring(size).rightCols(size - 1));
  result.equal_log_likelihood = data.log_likelihood(Eigen::VectorXd::Zero(size - 1));
  return result;
}

}  // namespace asperity
