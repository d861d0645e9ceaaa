// Computes the least-squares slope in two passes; none where all trials are the same.

#include "analysis/tests/learning.h"

#include <cmath>
#include <stdexcept>

namespace asperity {

std::optional<double> slope_over_trials(std::span<const TrialResult> results) {
  const auto n = static_cast<double>(results.size());
  double mean_trial = 0.0;
  double mean_result = 0.0;
  for (const TrialResult& one : results) {
    if (!std::isfinite(one.trial) || !std::isfinite(one.result)) {
      throw std::invalid_argument(
          "results contains a number that is not finite; every trial and result must be finite");
    }
    mean_trial += one.trial / n;
    mean_result += one.result / n;
  }
  double squares = 0.0;
  double products = 0.0;
  for (const TrialResult& one : results) {
    const double from_mean = one.trial - mean_trial;
    squares += from_mean * from_mean;
    products += from_mean * (one.result - mean_result);
  }
  // Places of trials are whole numbers: two that differ are far apart, compared with rounding.
  constexpr double kRounding = 1e-9;
  if (!(squares > kRounding)) return std::nullopt;
  return products / squares;
}

}  // namespace asperity
