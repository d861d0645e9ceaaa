// The share of hits over the trials of several participants, with the participant as the unit.

#pragma once

#include <span>

#include "analysis/proportion.h"

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

}  // namespace asperity
