// How many participants to recruit for a planned sample: whole rounds of a design, dropout and exclusion.

#pragma once

#include <cstddef>

namespace asperity {

/// The smallest multiple of `multiple` that is not below `participants`; a number that exceeds a multiple by less than 10⁻⁹
/// counts as it. Throws std::invalid_argument for a number that is not above 0 or not finite, and for a multiple of 0.
std::size_t rounded_up_to_multiple(double participants, std::size_t multiple);

/// The proportions of participants without complete data, and of those with complete data who are excluded, each in [0, 1).
struct Attrition {
  double dropout = 0.0;
  double exclusion = 0.0;
};

/// Numbers of participants to recruit.
struct Recruitment {
  double retained = 1.0;  ///< (1 − dropout)·(1 − exclusion)
  std::size_t on_average =
      0;  ///< ⌈needed/retained⌉: the expected number of analysed participants is the needed one
  /// The smallest N with P(X ≥ needed) ≥ assurance for X ~ Bin(N, retained): participants are lost independently.
  std::size_t assured = 0;
};

/// Throws std::invalid_argument for rates outside [0, 1), an assurance outside (0, 1), and none needed.
Recruitment recruitment(std::size_t needed, const Attrition& attrition, double assurance = 0.9);

}  // namespace asperity
