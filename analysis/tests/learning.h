// How a participant's results change over the trials.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

/// A result at its place in the order of a participant's trials.
struct TrialResult {
  double trial = 1.0;
  double result = 0.0;
};

/// Over how many trials a slope is stated; of fewer it would be extrapolated.
inline constexpr std::size_t kTrialsOfSlope = 10;

/// The slope of the least-squares line through the results, per trial: Σ(t − t̄)(r − r̄)/Σ(t − t̄)². Nothing where there
/// are not two different trials. Throws std::invalid_argument for what is not finite.
std::optional<double> slope_over_trials(std::span<const TrialResult> results);

}  // namespace asperity
