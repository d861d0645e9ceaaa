// Proportions of hits over the trials of several participants, with the participant as the unit.

#pragma once

#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The pooled share p = Σ x_s/Σ m_s of participants with x_s hits of m_s trials each.
struct PooledShare {
  double share = 0.0;
  /// √(N/(N − 1)·Σ(x_s − p·m_s)²)/Σ m_s: the ratio estimator, which lets the answers of a
  /// participant depend on each other in whatever way. NaN for a single participant.
  double clustered_standard_error = 0.0;
  double binomial_standard_error = 0.0;  ///< as if all trials were independent
  double design_effect = 1.0;  ///< ratio of both, squared; NaN where the binomial one is 0
};

/// Throws std::invalid_argument for no participant and for one without trials.
PooledShare pooled_share(std::span<const HitCount> participants);

struct MeanShareQuestion {
  double confidence = 0.95;
  /// By how much the variance of a participant's count exceeds the binomial one at least, where the trials are not
  /// independent by their very nature.
  double least_design_effect = 1.0;
};

/// The interval of p, the mean of the participants' own proportions x_s/m_s, by Student's t on the logit scale.
///
/// The variance v of p is s²/N, of the proportions between participants, but at least the binomial one: p(1 − p)/n with
/// n = N²/Σ(1/m_s) trials. So p rests on n' = p(1 − p)/v effective independent trials (n where p is 0 or 1), and with
/// half a hit and half a miss added to them, q = (n'p + ½)/(n' + 1), the interval is logit q ∓ t/√((n' + 1)q(1 − q))
/// with N − 1 degrees of freedom, 0 and 1 included where p is 0 or 1.
///
/// Student's interval of p itself is too short near 0 and 1, where p and its standard error depend on each other, and
/// does not exist where all participants are alike. docs/analysis.md has the coverage of both; [Dean 2015] compare
/// such intervals.
///
/// Nothing for a single participant. Throws std::invalid_argument as `pooled_share` does, for a confidence outside
/// 0 … 1 and for a design effect below 1.
///
/// [Dean 2015] Dean, Pagano: Evaluating confidence interval methods for binomial proportions in clustered surveys.
std::optional<ConfidenceInterval> mean_share_interval(std::span<const HitCount> participants,
                                                      const MeanShareQuestion& question = {});

/// A proportion that all participants have.
struct EqualShares {
  double share = 0.0;
  std::span<const double> trials{};  ///< of each participant
  double confidence = 0.95;
};

/// `mean_share_interval` of equal proportions, also where a tie counts as half a hit: the variance between the participants
/// is 0, so that the binomial one determines the interval.
///
/// Nothing for a single participant. Throws std::invalid_argument for a share outside 0 … 1, for trials that are not above 0,
/// and for a confidence outside 0 … 1.
std::optional<ConfidenceInterval> equal_shares_interval(const EqualShares& shares);

}  // namespace asperity
