// Declares Latin squares, orders in which every item occurs equally often at every position.

#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Orders of 0 … n−1, one per row.
using Square = std::vector<std::vector<std::size_t>>;

/// A Latin square of n rows: every item occurs once at every position. Row r is r, r+1, …, r+n−1 (mod n).
Square latin_square(std::size_t n);

/// A Williams square, in which every item also follows every other equally often. This balances carry-over effects of
/// the preceding item. It has n rows for even n and 2n for odd n. The first n rows are a Latin square, and so are the
/// last n.
///
/// [Williams 1949] Williams: Experimental designs balanced for the estimation of residual effects
/// of treatments.
Square williams_square(std::size_t n);

}  // namespace asperity
