// Several tests at once: p values adjusted so that the family keeps its error.

#pragma once

#include <span>
#include <vector>

namespace asperity {

/// For each p the smallest error of the whole family at which its test rejects, at most 1, in the
/// order of `p`. What is a family is declared before the data are seen.
///
/// Errors: std::invalid_argument for a p outside 0 to 1.
///
/// The probability of any false rejection, however the tests depend on each other [Holm 1979]: with
/// the p ascending, the i-th becomes the largest of (m − j + 1)·p_j, j ≤ i.
///
/// [Holm 1979] Holm: A simple sequentially rejective multiple test procedure.
std::vector<double> holm_adjusted(std::span<const double> p);

/// The expected share of false rejections among all, for independent or positively dependent tests
/// [Benjamini 1995]: the i-th becomes the smallest of m/j·p_j, j ≥ i.
///
/// [Benjamini 1995] Benjamini, Hochberg: Controlling the false discovery rate.
std::vector<double> benjamini_hochberg_adjusted(std::span<const double> p);

}  // namespace asperity
