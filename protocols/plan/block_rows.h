// Declares the trials of a block before they are ordered.

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/plan/trial_order.h"

namespace asperity {

/// Factor levels of one trial.
using FactorLevels = std::map<std::string, Level, std::less<>>;

/// What distinguishes a trial of a block from the others of one repetition.
struct BlockRow {
  FactorLevels factors{};
  /// With `all_pairs`: the levels of its factor for the first and the second surface; otherwise empty.
  std::vector<Level> pair{};
};

/// The combinations of the crossed factors (the last one fastest), or the listed rows, once; one empty combination if
/// there are none. Each of them with every level of the dimension, where the block varies a parameter without a
/// procedure, and with every pair, where it has pairs.
std::vector<BlockRow> rows_of(const Protocol& protocol, const Protocol::Block& block);

/// The number of rows, without building them.
std::size_t row_count(const Protocol& protocol, const Protocol::Block& block);

/// The ordering problem of all repetitions of `rows`. Errors: none; see `random_order`.
OrderProblem order_problem(const Protocol::Block& block, const std::vector<BlockRow>& rows);

}  // namespace asperity
