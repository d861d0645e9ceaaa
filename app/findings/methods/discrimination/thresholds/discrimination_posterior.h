// The posterior distribution of a threshold whose trials psi or QUEST+ placed.

#pragma once

#include <optional>
#include <span>

#include "analysis/psychometric/psychometric_model.h"
#include "analysis/psychometric/threshold_prior.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"

namespace asperity {

/// A posterior threshold is not reported where more than this probability is at the ends of the prior: its range would
/// determine the interval.
inline constexpr double kMostAtEndsOfPrior = 0.05;

/// The prior of the tracks as a prior of the difference from the standard, in the unit of the parameter. Nothing where no
/// track has one, or tracks differ in it.
std::optional<ThresholdPrior> common_prior(const PlacedTrials& placed);

/// The difference at this performance, with its 95 % credible interval: Bayes' theorem with all responses of one
/// psychometric function. How the trials were placed does not change it, because placement depends on earlier
/// responses alone.
CredibleThreshold posterior_threshold(const ThresholdPrior& prior,
                                      std::span<const PsychometricBlock> blocks,
                                      double performance);

}  // namespace asperity
