// Random orders in which a level does not come too often in a row.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/random.h"

namespace asperity {

/// How many trials in a row may have the same level of one factor.
struct RowLimit {
  std::vector<std::size_t> level_of_trial{};  ///< the level's number, for every trial
  std::size_t maximum = 1;
};

/// What is to be put in order: trials 0 … trials−1, in consecutive groups of `group_size` that stay
/// together (repetitions); one group of all trials when nothing has to.
struct OrderProblem {
  std::size_t trials = 0;
  std::size_t group_size = 0;  ///< divides `trials`
  std::vector<RowLimit> limits{};
};

bool meets(const OrderProblem& problem, const std::vector<std::size_t>& order);

/// An order found without chance, or nothing where there is none. The search gives up after a fixed
/// number of steps, which counts as "none".
std::optional<std::vector<std::size_t>> some_order(const OrderProblem& problem);

/// A random order that meets every limit, or nothing where there is none.
///
/// First whole shuffles are tried, so that every good order is equally likely; where good orders
/// are rare, one is built trial by trial with look-ahead and backtracking, which is nearly so. The
/// last resort is `some_order`: whether an order is found therefore does not depend on the random
/// numbers.
std::optional<std::vector<std::size_t>> random_order(const OrderProblem& problem, Random random);

}  // namespace asperity
