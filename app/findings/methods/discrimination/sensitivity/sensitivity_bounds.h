// Marks mean values of d′ that are bounds, because d′ of a participant depends on the number of trials.

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"

namespace asperity {

/// A level in the family `dprime`: its condition and its value.
FindingKey id_of_level(const DiscriminationResults& results,
                       const std::pair<std::size_t, double>& place);

/// The participants with trials at a level, and those whose d′ would be infinite without a correction, so that it depends on
/// the number of trials: at the ceiling it would be +∞ (each response to a signal is a hit, or none without a signal is a
/// false alarm), at the floor −∞ (the reverse).
struct UnboundedParticipants {
  std::size_t participants = 0;
  std::size_t at_ceiling = 0;
  std::size_t at_floor = 0;
  /// By a rule for which d′ is not negative (same–different, oddity): those whose estimate is 0.
  std::size_t at_zero = 0;

  bool is_any() const noexcept { return at_ceiling + at_floor > 0; }
};
/// By condition of DiscriminationResults and value of the parameter.
using UnboundedAtLevels = std::map<std::pair<std::size_t, double>, UnboundedParticipants>;
/// Removes the interval of every mean d′ (`dprime.mean`) that includes a participant at the ceiling or the floor. With
/// participants at the ceiling alone the mean is a lower bound, at the floor alone an upper bound, as its method then states;
/// with both it is neither.
void mark_bounds(const DiscriminationResults& results, const UnboundedAtLevels& levels,
                 std::vector<Finding>& findings);

/// "0.4 (at least; ceiling: 1 of 6 participants)"; without a bound where there are both.
Phrase with_bound(const Phrase& mean, const UnboundedParticipants& of);

/// The answer, and after it what these marks mean and, by a rule without negative d′, that means of small d′ are too high.
/// `unit`: of the levels.
Phrase explained_bounds(const Phrase& answer, const UnboundedAtLevels& levels,
                        const DiscriminationResults& results);

}  // namespace asperity
