// A sample of numbers in a few numbers.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

/// The quantile of type 7 [Hyndman 1996]: with h = (n − 1)·p, between the ⌊h⌋-th and the next of
/// the sorted values (counted from 0), x_⌊h⌋ + (h − ⌊h⌋)·(x_⌊h⌋₊₁ − x_⌊h⌋). What R and NumPy give
/// by default. `sorted` ascends and is not empty, 0 ≤ p ≤ 1; otherwise std::invalid_argument for an
/// empty sample or a wrong p.
///
/// [Hyndman 1996] Hyndman, Fan: Sample quantiles in statistical packages.
double quantile(std::span<const double> sorted, double p);

/// Every field is defined by +, −, ×, ÷ and √ in the order of the samples, so that whoever has the
/// same samples has the same bits, whenever it is computed.
struct Summary {
  std::size_t n = 0;
  double mean = 0.0;  ///< the sum from the first to the last sample, divided by n
  double sd = 0.0;    ///< √(Σ(x − mean)²/(n − 1)); 0 for a single sample
  double minimum = 0.0;
  double p05 = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
  double maximum = 0.0;
};

/// Nothing for no samples. Throws std::invalid_argument naming the first that is not finite.
std::optional<Summary> summary_of(std::span<const double> samples);

}  // namespace asperity
