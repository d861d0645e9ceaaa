// Comparisons of two items: one by one, and counted.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace asperity {

/// One comparison, items by number.
struct Comparison {
  std::size_t participant = 0;
  std::size_t first = 0;  ///< presented first
  std::size_t second = 0;
  std::optional<std::size_t> winner{};  ///< nothing for a tie
  std::size_t times = 1;                ///< how often the participant judged so
};

/// How often each of K items won against each other one, and how often they tied.
struct Comparisons {
  Eigen::MatrixXd wins{};  ///< (winner, loser)
  Eigen::MatrixXd ties{};  ///< symmetric: each tie stands in both places
};

/// Throws std::invalid_argument for an item beyond K, one compared with itself, and a winner that
/// was not compared.
Comparisons count_comparisons(std::span<const Comparison> comparisons, std::size_t items);

}  // namespace asperity
