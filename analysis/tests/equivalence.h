// Equivalence of two means, and the evidence of the data for a difference and against it.

#pragma once

#include <cstddef>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// A difference of means with its standard error and degrees of freedom, of whatever design: one
/// sample, pairs, Welch's two samples.
struct EstimatedDifference {
  double value = 0.0;
  double standard_error = 1.0;  ///< positive
  double df = 1.0;              ///< positive; need not be whole
};

/// Differences from `lower` to `upper` count as none. They are chosen before the data are seen.
struct EquivalenceBounds {
  double lower = -1.0;
  double upper = 1.0;
  double alpha = 0.05;  ///< of either one-sided test; below ½
};

/// Two one-sided tests [Schuirmann 1987]: that the difference is above the lower bound,
/// t = (difference − lower)/SE, and that it is below the upper one. The larger p is that of
/// equivalence, because both must hold, and each is made at α: no correction is needed.
/// p < α exactly where the 1 − 2α confidence interval lies within the bounds.
///
/// [Schuirmann 1987] Schuirmann: A comparison of the two one-sided tests procedure and the power
/// approach for assessing the equivalence of average bioavailability.
struct EquivalenceTest {
  double t_lower = 0.0;
  double t_upper = 0.0;
  double p_lower = 1.0;
  double p_upper = 1.0;
  double p = 1.0;
  ConfidenceInterval interval{};  ///< of confidence 1 − 2α
  bool equivalent = false;
};
/// Throws std::invalid_argument for a standard error or degrees of freedom that are not positive,
/// bounds that are not in order, and an α outside (0, ½).
EquivalenceTest equivalence_test(const EstimatedDifference& difference,
                                 const EquivalenceBounds& bounds);

/// The smallest Δ with which the data would show equivalence within ±Δ: the end of the 1 − 2α
/// interval that is farther from 0. It is a description: bounds that are chosen by it were not
/// chosen before the data. Throws as `equivalence_test` does.
double smallest_equivalence_margin(const EstimatedDifference& difference, double alpha = 0.05);

/// A t statistic with what a Bayes factor needs besides: `n` is the number of differences of one
/// sample or of pairs, n₁n₂/(n₁ + n₂) of two samples with pooled variance.
struct BayesFactorQuestion {
  double t = 0.0;
  double df = 1.0;
  double n = 2.0;
  double scale = 1.0;  ///< r: half of the prior's differences lie within ±r standard deviations
};

/// How many times more probable the data are with a difference than without one [Rouder 2009]: a
/// Cauchy prior of scale r on the standardised difference, Jeffreys' prior on the variance (JZS).
/// With the prior as a normal one of variance g·r², g inverse χ² of one degree of freedom,
///
///   BF₁₀ = ∫ (1 + ngr²)^(−½)·[(1 + t²/((1 + ngr²)ν))/(1 + t²/ν)]^(−(ν+1)/2)·(2π)^(−½)·g^(−3/2)·e^(−1/(2g)) dg.
///
/// The integral is a trapezoidal sum over ln g: the integrand is analytic there and falls at both
/// ends, so that the sum converges faster than any power of its step. +∞ where the factor is beyond
/// the largest number. Throws std::invalid_argument for a t that is not finite and for n, degrees of
/// freedom and a scale that are not positive.
///
/// [Rouder 2009] Rouder, Speckman, Sun, Morey, Iverson: Bayesian t tests for accepting and rejecting
/// the null hypothesis.
double jzs_bayes_factor(const BayesFactorQuestion& question);

}  // namespace asperity
