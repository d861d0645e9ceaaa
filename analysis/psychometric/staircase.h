// Tracks of an up-down staircase: their levels from the responses, and the mean of their reversals.

#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/numbers/level_scale.h"
#include "analysis/psychometric/up_down.h"

namespace asperity {

/// How a staircase with the responses of a participant chose its levels.
struct Staircase {
  double start = 0.0;
  UpDownRule rule{};
  LevelScale scale = LevelScale::linear;
  std::vector<double>
      steps{};  ///< by the number of reversals, see `UpDownRun`; the last one continues
  double up_over_down = 1.0;  ///< a move up has this many steps [Kaernbach 1991]
  double lowest = -std::numeric_limits<double>::infinity();  ///< a move beyond a bound ends at it
  double highest = std::numeric_limits<double>::infinity();
};

struct StaircaseTrial {
  double level = 0.0;
  bool is_reversal = false;  ///< see `UpDownRun`
  bool is_clipped = false;   ///< a bound shortened or prevented its move
};

struct StaircaseTrack {
  std::vector<StaircaseTrial> trials{};
  double next_level = 0.0;
};

/// The levels at which the responses were given. Errors: std::invalid_argument for a rule with a count of 0, no step, a
/// step without length, a ratio that is not above 0, and a start that is not between the bounds or, except on the linear
/// scale, not above 0.
StaircaseTrack replay_staircase(const Staircase& staircase, const std::vector<bool>& is_correct);

/// Which reversals enter the mean.
struct ReversalQuestion {
  LevelScale scale = LevelScale::linear;
  std::size_t discard = 0;   ///< from the beginning
  bool even_number = false;  ///< leave out one more if the remaining number is odd
};

/// The mean of the levels of reversals. All but the linear scale average log10 of the levels: the mean and the median
/// are then a geometric mean and the antilogarithm of a median, and the spread and standard error are in log10 units.
struct ReversalMean {
  std::size_t used = 0;
  double mean = 0.0;
  double median = 0.0;
  std::optional<double> sd{};  ///< of two or more
  /// Of an even number: the SD of the means of successive pairs (midpoints of runs) over √(number of pairs), NaN for one
  /// pair. Successive reversals are correlated, which this error takes into account only within pairs.
  std::optional<double> midpoint_error{};
};
/// Empty if no reversal remains.
std::optional<ReversalMean> mean_of_reversals(const StaircaseTrack& track,
                                              const ReversalQuestion& question);

}  // namespace asperity
