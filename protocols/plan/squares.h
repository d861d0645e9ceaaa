// Latin squares: orders in which everything is equally often everywhere.

#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Orders of 0 … n−1, one per row.
using Square = std::vector<std::vector<std::size_t>>;

/// n rows; every item stands once in every position. Row r is r, r+1, …, r+n−1 (mod n).
Square latin_square(std::size_t n);

/// Also every item follows every other equally often, which balances effects of the item before:
/// n rows for even n, 2n for odd n. The first n rows are a Latin square, and so are the last n.
///
/// [Williams 1949] Williams: Experimental designs balanced for the estimation of residual effects
/// of treatments.
Square williams_square(std::size_t n);

}  // namespace asperity
