// Worths of items from rankings, whole or partial.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/choices/bradley_terry.h"

namespace asperity {

/// What one participant was offered and how it was ranked. Who ranks only the best leaves the rest
/// in `behind`.
struct Ranking {
  std::size_t participant = 0;
  std::vector<std::size_t> ranked{};  ///< items, the best first
  std::vector<std::size_t> behind{};  ///< offered and not ranked: behind every ranked one
  std::size_t times = 1;              ///< how often the participant ranked so
};

/// A ranking is a series of choices of the best among what is left, each with the probability
/// w_i/Σ w [Plackett 1975]; the last one, of a single item, says nothing. `wins` counts at each
/// stage the one that was taken over those that were left.
///
/// [Plackett 1975] Plackett: The analysis of permutations.
struct PlackettLuce {
  Abilities log_worths{};  ///< ln w, 0 for the first item
  Abilities clustered{};  ///< the same worths; their covariance with participants as clusters (CR0)
  /// Of `log_worths.about_mean()`, participants as clusters; empty for too few (`clustered_errors`).
  std::vector<ClusteredError> centred_errors{};
  double log_likelihood = 0.0;
  double equal_log_likelihood = 0.0;  ///< of equal worths
};

struct RankingCounts {
  std::size_t stages = 0;
  Eigen::MatrixXd wins{};
};
/// Throws std::invalid_argument for an item beyond `items` and one that stands twice.
RankingCounts count_stages(std::span<const Ranking> rankings, std::size_t items);

/// Nothing unless the wins connect every item with every other in both directions.
std::optional<PlackettLuce> plackett_luce(std::span<const Ranking> rankings, std::size_t items);

}  // namespace asperity
