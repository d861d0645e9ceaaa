// Searches the directed graph of wins depth-first; the blocked items are its smallest closed set.

#include "analysis/choices/comparison_graph.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace asperity {
namespace {

/// The items to which chains of wins lead from `start`, itself included.
std::vector<bool> reached_from(const Eigen::MatrixXd& wins, Eigen::Index start) {
  std::vector<bool> reached(static_cast<std::size_t>(wins.rows()), false);
  std::vector<Eigen::Index> left{start};
  reached[static_cast<std::size_t>(start)] = true;
  while (!left.empty()) {
    const Eigen::Index item = left.back();
    left.pop_back();
    for (Eigen::Index other = 0; other < wins.cols(); ++other) {
      if (!(wins(item, other) > 0.0) || reached[static_cast<std::size_t>(other)]) continue;
      reached[static_cast<std::size_t>(other)] = true;
      left.push_back(other);
    }
  }
  return reached;
}

bool reaches_all(const Eigen::MatrixXd& wins) {
  const std::vector<bool> reached = reached_from(wins, 0);
  return std::find(reached.begin(), reached.end(), false) == reached.end();
}

/// The smallest of the sets that chains of wins reach from an item: no win leads out of it. The set of
/// any item contains one from which every item reaches the same set, and that is a smallest one.
std::vector<std::size_t> smallest_closed_set(const Eigen::MatrixXd& wins) {
  std::vector<std::size_t> smallest{};
  for (Eigen::Index start = 0; start < wins.rows(); ++start) {
    const std::vector<bool> reached = reached_from(wins, start);
    std::vector<std::size_t> items{};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      if (reached[i]) items.push_back(i);
    }
    if (smallest.empty() || items.size() < smallest.size()) smallest = items;
  }
  return smallest;
}

}  // namespace

bool strongly_connected(const Eigen::MatrixXd& wins) {
  return wins.rows() == 0 || (reaches_all(wins) && reaches_all(wins.transpose()));
}

bool connected(const Eigen::MatrixXd& wins) {
  return wins.rows() == 0 || reaches_all(wins + wins.transpose());
}

BlockedItems blocked_items(const Eigen::MatrixXd& wins) {
  if (!connected(wins)) {
    return {.blocker = ScaleBlocker::never_compared,
            .items = smallest_closed_set(wins + wins.transpose())};
  }
  if (strongly_connected(wins)) return {};
  std::vector<std::size_t> never_lose = smallest_closed_set(wins.transpose());
  std::vector<std::size_t> never_win = smallest_closed_set(wins);
  if (never_win.size() < never_lose.size()) {
    return {.blocker = ScaleBlocker::never_win, .items = std::move(never_win)};
  }
  return {.blocker = ScaleBlocker::never_lose, .items = std::move(never_lose)};
}

}  // namespace asperity
