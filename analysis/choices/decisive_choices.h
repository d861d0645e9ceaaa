// How many choices between two settle which is preferred.

#pragma once

#include <cstddef>
#include <optional>

namespace asperity {

/// The smallest number n ≥ `least` of independent choices at which the two-sided exact test against
/// ½ finds the preference with the probability `power` at least, and still does with 1 to 6 more:
/// the power of an exact test is a saw, and a number on one of its teeth is luck.
///
/// Nothing when 10 000 are not enough. Throws std::invalid_argument for probabilities outside
/// (0, 1).
struct DecisivePlan {
  double preference = 0.6;  ///< how often the first is chosen
  double error = 0.05;
  double power = 0.8;
  std::size_t least = 1;
};
std::optional<std::size_t> decisive_choices(const DecisivePlan& plan);

}  // namespace asperity
