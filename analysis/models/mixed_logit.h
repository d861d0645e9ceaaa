// Hits of many participants in two groups: logistic regression with and without a participant's own
// level.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>

#include "analysis/numbers/proportion.h"

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
/// participants). A single participant of a group is fitted exactly: NaN for what depends on it.
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
/// The integral over u is the trapezoidal rule around each participant's mode, with a step that
/// follows σ and the number of trials: exact to about 10⁻¹² for every σ, where Gauss–Hermite
/// quadrature fails as the integrand turns into a step. Gradient and Hessian follow from the same
/// nodes by Louis' identity, and Newton's steps end where the likelihood no longer grows. The
/// likelihood includes the binomial coefficients; standard errors are of the observed information,
/// ln σ included.
struct MixedLogit {
  LogitCoefficients beta{};
  LogitCoefficients standard_error{};
  double sigma = 0.0;
  double log_likelihood = 0.0;
  /// Against β₁ = 0, one degree of freedom.
  double likelihood_ratio = 0.0;
  std::optional<double> p{};
};

/// Why there is no such fit.
enum class NoMixedLogit {
  separated,  ///< `fixed_logit` has none either
  no_spread,  ///< the likelihood is greatest at σ = 0 (below 10⁻³): `fixed_logit` is the fit
  unbounded_spread,  ///< no participant has both hits and misses: it grows with σ without end
  flat               ///< one trial each: it does not depend on σ
};

/// A maximum at a finite σ exists if a participant has both hits and misses: the probability of such
/// a count falls to 0 as σ grows. If none has, P(all hits) + P(all misses) of a participant with two
/// trials or more is below 1 for every finite σ and tends to 1 as σ grows with β/σ constant, and the
/// likelihood tends to that of one trial per participant without reaching it. Throws as
/// `fixed_logit` does.
std::variant<MixedLogit, NoMixedLogit> mixed_logit(std::span<const GroupedHits> participants);

}  // namespace asperity
