// Sensitivity in a choice among m alternatives.

#pragma once

#include <cstddef>

namespace asperity {

/// The share of right answers of an observer without bias who picks the largest of m independent
/// normal impressions, of which the right one is d′ standard deviations above the others
/// [Hacker 1979]:
///
///   P(d′) = ∫ φ(x − d′)·Φ(x)^(m−1) dx,
///
/// 1/m for d′ = 0. It takes the m − 1 wrong alternatives for equally confusable, so it is to be
/// read beside the confusion matrix. By Gauss–Kronrod quadrature within 12 standard deviations.
///
/// Every function throws std::invalid_argument for fewer than two alternatives and for a share that
/// is not between 0 and 1.
///
/// [Hacker 1979] Hacker, Ratcliff: A revised table of d′ for M-alternative forced choice.
struct ForcedChoice {
  std::size_t alternatives = 2;

  double share(double dprime) const;
  /// dP/dd′.
  double slope(double dprime) const;
  /// The d′ of a share, to the last digits of the quadrature; −∞ for 0 and ∞ for 1. Below 1/m it is
  /// negative.
  double dprime(double share) const;
};

}  // namespace asperity
