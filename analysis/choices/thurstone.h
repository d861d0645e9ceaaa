// Thurstone's law of comparative judgement, Case V.

#pragma once

#include <cstddef>
#include <optional>

#include "analysis/choices/bradley_terry.h"

namespace asperity {

/// P(i before j) = Φ(s_i − s_j): the unit is the standard deviation of a difference (√2 of it is d′).

/// By least squares [Mosteller 1951]: s_i is the mean over all j, i included, of z_ij = Φ⁻¹(p_ij),
/// z_ii = 0, so that Σs = 0. A share of 0 or 1 of n comparisons is taken as 1/(2n) or 1 − 1/(2n);
/// `clipped` counts those pairs. Fit: X² = Σ n·(2·asin√p − 2·asin√p̂)², (K − 1)(K − 2)/2 degrees of
/// freedom.
///
/// Nothing unless every pair was compared.
///
/// [Mosteller 1951] Mosteller: Remarks on the method of paired comparisons I, III.
struct ThurstoneLeastSquares {
  Eigen::VectorXd scale{};
  double chi_squared = 0.0;
  double df = 0.0;
  std::size_t clipped = 0;
};
std::optional<ThurstoneLeastSquares> thurstone_least_squares(const Comparisons& counts);

/// By maximum likelihood, incomplete designs too; the first item has 0. The covariance is the inverse
/// of the expected information. Nothing unless the wins connect all items in both directions.
struct ThurstoneLikelihood {
  Abilities abilities{};
  double deviance = 0.0;
};
std::optional<ThurstoneLikelihood> thurstone_likelihood(const Comparisons& counts);

}  // namespace asperity
