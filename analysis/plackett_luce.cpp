#include "analysis/plackett_luce.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "analysis/comparison_graph.h"
#include "analysis/conditional_logit.h"

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
      throw std::invalid_argument("a ranking must be of different items out of " +
                                  std::to_string(items));
    }
  }
  for_each_stage(
      rankings, [&counts](const Ranking&, std::size_t taken, const std::vector<std::size_t>& left) {
        ++counts.stages;
        for (const std::size_t item : left) {
          if (item == taken) continue;
          counts.wins(static_cast<Eigen::Index>(taken), static_cast<Eigen::Index>(item)) += 1.0;
        }
      });
  return counts;
}

std::optional<PlackettLuce> plackett_luce(std::span<const Ranking> rankings, std::size_t items) {
  const RankingCounts counts = count_stages(rankings, items);
  if (items < 2 || !strongly_connected(counts.wins)) return std::nullopt;
  ChoiceData data{};
  std::vector<std::size_t> clusters{};
  for_each_stage(rankings, [&](const Ranking& ranking, std::size_t taken,
                               const std::vector<std::size_t>& left) {
    data.begin_stratum();
    clusters.push_back(ranking.participant);
    for (const std::size_t item : left) {
      const double count = item == taken ? 1.0 : 0.0;
      if (item == 0) {
        data.add(count, {});
      } else {
        data.add(count, {{item - 1, 1.0}});
      }
    }
  });
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
  result.clustered_standard_error =
      with_first(clustered_covariance(*fit, data, clusters)).diagonal().cwiseMax(0.0).cwiseSqrt();
  result.equal_log_likelihood = data.log_likelihood(Eigen::VectorXd::Zero(size - 1));
  return result;
}

}  // namespace asperity
