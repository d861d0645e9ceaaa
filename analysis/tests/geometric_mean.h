// The geometric mean of positive numbers, such as response times.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// exp(m), with m the mean of the n logarithms ln x and s their standard deviation. The interval is exp(m ∓ t·s/√n)
/// with t the limit of Student's distribution with n − 1 degrees of freedom: that of the geometric mean of the
/// population, which is its median where the logarithms are distributed symmetrically.
struct GeometricMean {
  std::size_t n = 0;
  double mean = 0.0;
  /// Absent for a single number, and where all are equal but for rounding.
  std::optional<ConfidenceInterval> interval{};
};

/// Throws std::invalid_argument for no numbers, for one that is not finite and above 0, and for a confidence outside
/// 0 … 1.
GeometricMean geometric_mean(std::span<const double> numbers, double confidence = 0.95);

}  // namespace asperity
