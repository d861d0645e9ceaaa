// Hits of two groups against each other.

#pragma once

#include <optional>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// Hits and misses of two groups. Every function throws as those of proportion.h do. They take all
/// trials for independent, which trials of one person are not.
struct TwoByTwo {
  HitCount first{};
  HitCount second{};
};

/// Fisher's exact test, given all four margins: the hits x of the first group are hypergeometric.
/// Two-sided is the probability of all tables that are not more probable than the observed one, as
/// in `binomial_test`.
///
/// The odds ratio is the conditional maximum-likelihood one, the mean of Fisher's noncentral
/// hypergeometric distribution set to x, with the limits of the exact one-sided tests; 0 or ∞ where
/// x is at an end of its range.
struct FisherTest {
  double p_two_sided = 1.0;
  double p_greater = 1.0;  ///< the first group has the greater odds
  double p_less = 1.0;
  double odds_ratio = 1.0;
  ConfidenceInterval interval{};
  bool margins_decide = false;  ///< only one table has these margins: nothing was to be learned
};
FisherTest fisher_test(const TwoByTwo& table, double confidence = 0.95);
/// Its two-sided p alone.
double fisher_two_sided(const TwoByTwo& table);

/// The odds ratio with ½ added to every cell [Haldane 1956], and the standard error of its
/// logarithm.
///
/// [Haldane 1956] Haldane: The estimation and significance of the logarithm of a ratio of
/// frequencies.
struct HaldaneRatio {
  double odds_ratio = 1.0;
  double log_standard_error = 0.0;
};
HaldaneRatio haldane_ratio(const TwoByTwo& table);

/// The difference of the proportions, first minus second, with Newcombe's hybrid of both Wilson
/// intervals (his method 10) [Newcombe 1998].
///
/// [Newcombe 1998] Newcombe: Interval estimation for the difference between independent
/// proportions: comparison of eleven methods.
struct ShareDifference {
  double difference = 0.0;
  ConfidenceInterval interval{};
};
ShareDifference newcombe_difference(const TwoByTwo& table, double confidence = 0.95);

}  // namespace asperity
