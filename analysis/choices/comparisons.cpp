// Adds wins and ties to matrices of item by item; an impossible comparison is refused.

#include "analysis/choices/comparisons.h"

#include <stdexcept>
#include <string>

namespace asperity {

Comparisons count_comparisons(std::span<const Comparison> comparisons, std::size_t items) {
  const auto size = static_cast<Eigen::Index>(items);
  Comparisons counts{.wins = Eigen::MatrixXd::Zero(size, size),
                     .ties = Eigen::MatrixXd::Zero(size, size)};
  for (const Comparison& one : comparisons) {
    const bool judged = !one.winner || *one.winner == one.first || *one.winner == one.second;
    if (one.first >= items || one.second >= items || one.first == one.second || !judged) {
      throw std::invalid_argument(
          "comparisons: one is of the items " + std::to_string(one.first) + " and " +
          std::to_string(one.second) +
          (one.winner ? ", won by " + std::to_string(*one.winner) : ", tied") +
          "; the items must be different and below " + std::to_string(items) +
          ", and the winner must be one of them");
    }
    const auto a = static_cast<Eigen::Index>(one.first);
    const auto b = static_cast<Eigen::Index>(one.second);
    const auto times = static_cast<double>(one.times);
    if (!one.winner) {
      counts.ties(a, b) += times;
      counts.ties(b, a) += times;
    } else if (*one.winner == one.first) {
      counts.wins(a, b) += times;
    } else {
      counts.wins(b, a) += times;
    }
  }
  return counts;
}

}  // namespace asperity
