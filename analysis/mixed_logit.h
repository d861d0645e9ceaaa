// Hits of many participants in two groups: logistic regression with and without a participant's own
// level.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "analysis/proportion.h"

namespace asperity {

/// What one participant got right, and in which of two groups.
struct GroupedHits {
  HitCount count{};
  bool second_group = false;
};

/// Coefficients on the logit scale: the level of the first group, and what the second group has
/// more.
struct LogitCoefficients {
  double intercept = 0.0;
  double second_group = 0.0;
};

/// logit P = β₀ + β₁·[second group] as if all trials were independent; standard errors from the
/// information, and with the participant as the unit (sandwich CR0: no correction for few
/// participants).
struct FixedLogit {
  LogitCoefficients beta{};
  LogitCoefficients standard_error{};
  LogitCoefficients cluster_standard_error{};
};

/// Nothing where all trials of a group are hits or all misses: its level is not finite. Throws
/// std::invalid_argument when a group is empty or a count impossible.
std::optional<FixedLogit> fixed_logit(std::span<const GroupedHits> participants);

/// logit P = β₀ + β₁·[second group] + σ·u, u ~ N(0, 1) per participant, by maximum likelihood.
///
/// The integral over u is Gauss–Hermite quadrature with 61 nodes, moved to each participant's mode
/// and scaled by the curvature there; gradient and Hessian follow from the same nodes by Louis'
/// identity, and Newton's steps end where the likelihood no longer grows. The likelihood includes
/// the binomial coefficients; standard errors are of the observed information, ln σ included.
struct MixedLogit {
  LogitCoefficients beta{};
  LogitCoefficients standard_error{};
  double sigma = 0.0;
  double log_likelihood = 0.0;
  /// Against β₁ = 0, one degree of freedom.
  double likelihood_ratio = 0.0;
  std::optional<double> p{};
};

/// Nothing where the greatest likelihood is at σ = 0 (below 10⁻³) or does not depend on σ (one trial
/// each): then `fixed_logit` is the fit, and nothing where that has none. Throws as `fixed_logit`
/// does.
std::optional<MixedLogit> mixed_logit(std::span<const GroupedHits> participants);

}  // namespace asperity
