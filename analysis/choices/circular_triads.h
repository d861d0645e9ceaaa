// Consistency of a judge's paired comparisons, and agreement of several judges.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/choices/comparisons.h"
#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {

/// How consistent one judge is who compared every pair of K ≥ 3 items once without ties, from the
/// wins s_i of each item [Kendall 1940]: the number of circular triads (A before B before C before A)
///
///   d = K(K − 1)(2K − 1)/12 − ½·Σ s_i²
///
/// and the coefficient of consistence ζ = 1 − d/d_max with d_max = (K³ − K)/24 for odd and
/// (K³ − 4K)/24 for even K: 1 for none and 0 for as many as possible. Derivation: a triad that is not
/// circular has exactly one item that wins both of its comparisons, so that Σ s_i(s_i − 1)/2 of the
/// K(K − 1)(K − 2)/6 triads are not circular, and Σ s_i = K(K − 1)/2.
///
/// [Kendall 1940] Kendall, Babington Smith: On the method of paired comparisons.
struct Consistency {
  double circular_triads = 0.0;
  double zeta = 1.0;
};
/// Throws std::invalid_argument for fewer than 3 items, and for wins whose sum is not that of all
/// pairs.
Consistency consistency(std::span<const std::size_t> wins);

/// The mean ζ of a judge to whom both outcomes of each comparison are equally likely. Each of the
/// K(K − 1)(K − 2)/6 triads is then circular with probability ¼, and ζ is linear in their number: ½ for
/// K = 4, and towards 0 for many items. Throws std::invalid_argument for fewer than 3 items.
double mean_zeta_under_guessing(std::size_t items);

/// Why the comparisons of one judge are not one of each pair.
enum class IncompletePairs {
  tie,            ///< a pair was tied
  pair_missing,   ///< a pair was not compared
  pair_repeated,  ///< a pair was compared more than once
};
/// The wins of each item where one judge compared every pair once without ties.
struct WinsOfJudge {
  std::vector<std::size_t> wins{};           ///< empty where there is a problem
  std::optional<IncompletePairs> problem{};  ///< the first that applies
};
/// `of_one_judge`: comparisons of a single participant. Throws as `count_comparisons` does.
WinsOfJudge wins_of_judge(std::span<const Comparison> of_one_judge, std::size_t items);

/// Most items for which the distribution of d is counted out.
inline constexpr std::size_t kMostItemsForExactTriads = 10;

/// The number of circular triads of a judge to whom both outcomes of each comparison are equally
/// likely: all 2^(K(K−1)/2) outcomes, counted by the wins of the items (a new item loses to each
/// subset of the others). Throws std::invalid_argument for fewer than 3 items and for more than
/// `kMostItemsForExactTriads`.
IntegerDistribution circular_triad_distribution(std::size_t items);

/// Whether a judge is more consistent than such a judge: p = P(D ≤ d). It is exact up to
/// `kMostItemsForExactTriads` items. Beyond them it is the upper tail of χ² with
///
///   ν = K(K − 1)(K − 2)/(K − 4)²,  χ² = 8/(K − 4)·(K(K − 1)(K − 2)/24 − d − ½) + ν
///
/// Derivation: a triad is circular with probability ¼, and triads are uncorrelated, so that d has the
/// mean T/4 and the variance 3T/16 with T = K(K − 1)(K − 2)/6 triads. a·(T/4 − d) + ν has the
/// variance 2ν of χ² if a = 8/(K − 4), and with this ν also its third moment [Kendall 1940]. The
/// continuity correction takes the probability up to d + ½; the + ½ that is often printed in place of
/// − ½ belongs to 1 − P(D ≥ d). At 10 items it deviates from the exact p by at most 0.011, and for p
/// between .001 and .1 it is 0.95 to 1.41 times as large.
struct TriadTest {
  double p = 1.0;
  bool exact = true;
  std::optional<ChiSquaredStatistic> approximation{};  ///< from 7 items
};
/// Throws std::invalid_argument for fewer than 3 items and an impossible number of triads.
TriadTest triad_test(std::size_t circular_triads, std::size_t items);

/// The agreement of m ≥ 2 judges who each compared every pair of K items once without ties
/// [Kendall 1940]. With γ_ij the number of judges who put i before j, Σ = Σ_{i≠j} γ_ij(γ_ij − 1)/2 is
/// the number of agreements of two judges about a pair, and
///
///   u = 2·Σ/(m(m − 1)/2·K(K − 1)/2) − 1
///
/// is 1 for complete agreement and −1/(m − 1) (m even) or −1/m (m odd) for the least one possible.
/// The mean of u over judges to whom both outcomes of each comparison are equally likely is 0.
struct JudgesAgreement {
  std::size_t judges = 0;
  double u = 0.0;
  double least = 0.0;  ///< the lowest value that u can have
  /// P(Σ at least as large) for such judges: exact. A pair contributes
  /// γ(γ − 1)/2 + (m − γ)(m − γ − 1)/2 with γ binomial (m, ½), and pairs are independent.
  double p = 1.0;
  /// χ² = 4/(m − 2)·(Σ − ½·K(K − 1)/2·m(m − 1)/2·(m − 3)/(m − 2)) with K(K − 1)/2·m(m − 1)/(m − 2)²
  /// degrees of freedom, the approximation of the source; nothing for two judges.
  std::optional<ChiSquaredStatistic> approximation{};
};
/// Nothing where judges tied a pair, where pairs were compared by different numbers of judges, and for
/// fewer than 2 judges. That each judge compared a pair only once is the caller's
/// (`wins_of_judge`). Throws std::invalid_argument for fewer than two items.
std::optional<JudgesAgreement> judges_agreement(const Comparisons& counts);

}  // namespace asperity
