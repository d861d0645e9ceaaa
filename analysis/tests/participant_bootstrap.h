// The bootstrap over participants, of any statistic of a group.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The interval of a statistic, from resamples of participants with all their trials: trials of one participant depend on
/// each other, and a resample of single trials would give intervals that are too short [Davison 1997].
///
/// Quantiles (type 7) at α and 1 − α of the draws, with α = Φ(−√(n/(n − 1))·t), t the two-sided limit of Student's
/// distribution with n − 1 degrees of freedom: the expanded percentiles of [Hesterberg 2015]. The percentiles at half the
/// error would be too short for few participants: a draw has the variance (n − 1)/n of the unbiased one, and normal
/// instead of t tails. For a mean of normal values the expanded interval is that of the t test but for simulation.
///
/// No resample exceeds the smallest and the largest participant. For a symmetric distribution that range misses the median
/// with the probability 2^(1 − n), 6 % with five participants: intervals require kFewestResampled of them.
///
/// [Davison 1997] Davison, Hinkley: Bootstrap methods and their application.
/// [Hesterberg 2015] Hesterberg: What teachers should know about the bootstrap.
struct ParticipantBootstrap {
  std::optional<ConfidenceInterval>
      interval{};  ///< nothing for fewer than kFewestResampled participants
  std::size_t draws = 0;
  std::size_t without = 0;  ///< draws in which the statistic does not exist; left out
};

constexpr std::size_t kFewestResampled = 6;

struct BootstrapPlan {
  std::size_t participants = 0;
  std::size_t draws = 2000;
  double confidence = 0.95;
};

/// `statistic` receives the places of the participants of one draw, of which some occur several times and others do not
/// occur. The draws are those of the seed kSeedOfTests.
ParticipantBootstrap bootstrap_participants(
    const BootstrapPlan& plan,
    const std::function<std::optional<double>(std::span<const std::size_t>)>& statistic);

}  // namespace asperity
