#include "analysis/comparison_graph.h"

#include <cstddef>
#include <vector>

namespace asperity {
namespace {

bool reaches_all(const Eigen::MatrixXd& wins) {
  std::vector<bool> reached(static_cast<std::size_t>(wins.rows()), false);
  std::vector<Eigen::Index> left{0};
  reached[0] = true;
  std::size_t count = 1;
  while (!left.empty()) {
    const Eigen::Index item = left.back();
    left.pop_back();
    for (Eigen::Index other = 0; other < wins.cols(); ++other) {
      if (!(wins(item, other) > 0.0) || reached[static_cast<std::size_t>(other)]) continue;
      reached[static_cast<std::size_t>(other)] = true;
      ++count;
      left.push_back(other);
    }
  }
  return count == reached.size();
}

}  // namespace

bool strongly_connected(const Eigen::MatrixXd& wins) {
  return wins.rows() == 0 || (reaches_all(wins) && reaches_all(wins.transpose()));
}

bool connected(const Eigen::MatrixXd& wins) {
  return wins.rows() == 0 || reaches_all(wins + wins.transpose());
}

}  // namespace asperity
