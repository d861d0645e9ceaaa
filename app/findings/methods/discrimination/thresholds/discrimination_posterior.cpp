// Converts the prior to the unit of the parameter, and needs one prior that all tracks have in common.

#include "app/findings/methods/discrimination/thresholds/discrimination_posterior.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kCredibility = 0.95;

/// Thresholds are in the unit of the levels, which are proportional to the difference from the standard.
ThresholdPrior in_unit_of_parameter(const PosteriorTrack& track, const Dimension& levels) {
  ThresholdPrior prior = track.prior;
  const double unit = std::abs(levels.value_of(track.origin + 1.0) - levels.value_of(track.origin));
  prior.thresholds.lowest *= unit;
  prior.thresholds.highest *= unit;
  return prior;
}

}  // namespace

std::optional<ThresholdPrior> common_prior(const PlacedTrials& placed) {
  std::optional<ThresholdPrior> common{};
  for (const PlacedTrials::Track& track : placed.tracks) {
    const PosteriorTrack* const posterior = posterior_track_of(track.settings);
    if (posterior == nullptr) continue;
    const ThresholdPrior prior = in_unit_of_parameter(*posterior, track.levels);
    if (common && !(*common == prior)) return std::nullopt;
    common = prior;
  }
  return common;
}

CredibleThreshold posterior_threshold(const ThresholdPrior& prior,
                                      std::span<const PsychometricBlock> blocks,
                                      double performance) {
  const std::vector<PsychometricFunction> functions = functions_of(prior, {});
  return credible_threshold(prior, functions, posterior_of(functions, blocks),
                            {.performance = performance, .confidence = kCredibility});
}

}  // namespace asperity
