// The trials of a block before they are put in order.

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

/// Combinations of the crossed factors (the last one fastest), or the listed rows, once; a single
/// empty one where there is neither.
std::vector<FactorLevels> rows_of(const Protocol& protocol, const Protocol::Block& block);

/// Number of rows without building them.
std::size_t row_count(const Protocol& protocol, const Protocol::Block& block);

/// The order that is asked for, of all repetitions of `rows`. Errors: none; see `random_order`.
OrderProblem order_problem(const Protocol::Block& block, const std::vector<FactorLevels>& rows);

}  // namespace asperity
