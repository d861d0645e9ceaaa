// A table of counts: whether its rows are distributed alike.

#pragma once

#include <optional>

#include "analysis/numbers/exact_null.h"

namespace asperity {

/// Fisher's exact test of a table of any size, given all margins [Freeman 1951]: the probability of
/// all tables that are not more probable than this one, but for one part in 10⁷. Margins of 0 say
/// nothing. Nothing where counting them would take more than about a second.
///
/// Throws std::invalid_argument for a negative count.
///
/// [Freeman 1951] Freeman, Halton: Note on an exact treatment of contingency, goodness of fit and
/// other problems of significance.
std::optional<double> exact_independence_test(const CountMatrix& table);

}  // namespace asperity
