// Declares random trial orders with constraints on levels and positions.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/numbers/random.h"

namespace asperity {

/// The maximum number of consecutive trials with the same level of one factor.
struct RowLimit {
  std::vector<std::size_t> level_of_trial{};  ///< the level's number, for every trial
  std::size_t maximum = 1;
};

/// The smallest difference of the positions of two trials with the same level of one factor.
struct LevelDistance {
  std::vector<std::size_t> level_of_trial{};
  std::size_t minimum = 2;  ///< 2: two such trials are not adjacent
};

/// The trial at a position, from 0, is one of these.
struct FixedPlace {
  std::size_t position = 0;
  std::vector<bool> allows_trial{};
};

/// The trials to be ordered: 0 … trials−1, in consecutive groups of `group_size` that stay together (repetitions); one
/// group of all trials if there are no groups.
struct OrderProblem {
  std::size_t trials = 0;
  std::size_t group_size = 0;  ///< divides `trials`
  std::vector<RowLimit> limits{};
  std::vector<LevelDistance> distances{};
  std::vector<FixedPlace> places{};
};

bool meets(const OrderProblem& problem, const std::vector<std::size_t>& order);

/// A deterministic order, or nullopt if none was found. The search stops after a fixed number of steps, which counts as
/// none.
std::optional<std::vector<std::size_t>> some_order(const OrderProblem& problem);

/// A random order that meets all constraints, or nullopt if none was found.
///
/// Complete shuffles are tried first, which makes all valid orders equally likely. Where valid orders are rare, one is
/// built trial by trial with look-ahead and backtracking, which is nearly uniform. The last resort is `some_order`:
/// whether an order is found therefore does not depend on the random numbers.
std::optional<std::vector<std::size_t>> random_order(const OrderProblem& problem, Random random);

}  // namespace asperity
