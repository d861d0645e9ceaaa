// Ratings on ordered categories: the proportional odds model, with participants and items as crossed
// random intercepts.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {

/// The response of one participant to one item, on J categories that are numbered from 0 in their
/// order. Participants and items are numbered from 0.
struct OrdinalResponse {
  std::size_t category = 0;
  std::size_t participant = 0;
  std::size_t item = 0;
};

/// P(Y ≤ j) = 1/(1 + exp(−(θ_j − η))), η = x'β + σ_p·u_participant + σ_i·v_item, with independent
/// u, v ~ N(0, 1), increasing thresholds θ_0 < … < θ_{J−2} and P(Y ≤ J − 1) = 1. A positive β moves
/// responses to higher categories: exp β is the ratio of the odds of Y > j to those without the effect,
/// the same for every j. The thresholds stand for the intercept.
struct CumulativeLinkModel {
  std::size_t categories = 0;  ///< J ≥ 2
  /// A row x' for each response, without a column of ones; a condition of c levels has c − 1 columns of
  /// 0 and 1. It may have no columns.
  Eigen::MatrixXd design{};
  bool participants_vary = false;  ///< without: σ_p = 0
  bool items_vary = false;         ///< without: σ_i = 0
};

/// The maximum of the likelihood; with random intercepts that of its Laplace approximation: with f the
/// joint density of responses, u and v, and H the negative Hessian of ln f at its mode,
/// ln L = ln f(mode) + (d/2)·ln 2π − ½·ln|H|, d the number of intercepts, as `clmm` of R's package
/// ordinal defines it (R. H. B. Christensen: ordinal – regression models for ordinal data, R package
/// 2022.11-16; P. McCullagh: Regression models for ordinal data. Journal of the Royal Statistical
/// Society B 42(2), 109–142, 1980). The approximation underestimates σ where participants and items
/// have few responses each [Joe 2008].
///
/// Standard errors are from the observed information of all parameters, θ, β and σ, together.
///
/// [Joe 2008] Joe: Accuracy of Laplace approximation for discrete response mixed models.
struct CumulativeLinkFit {
  Eigen::VectorXd thresholds{};  ///< θ, on the scale of log odds
  Eigen::VectorXd beta{};        ///< log odds ratios per unit of the design
  double sigma_participants = 0.0;
  double sigma_items = 0.0;
  Eigen::MatrixXd covariance{};  ///< of θ, then β
  double log_likelihood = 0.0;
  std::size_t parameters = 0;  ///< θ, β and those of σ that are estimated
  std::size_t responses = 0;

  Eigen::VectorXd threshold_standard_error() const;
  Eigen::VectorXd standard_error() const;  ///< of β
};

/// Why there is no fit.
enum class CumulativeLinkProblem {
  unused_category,  ///< a category without responses: its thresholds are not determined
  separated,        ///< the fixed effects predict categories completely: |β| or |θ| is infinite
  no_participant_variance,  ///< the maximum has σ_p = 0: a boundary, without standard errors
  no_item_variance,         ///< σ_i = 0
  no_variance,              ///< both
  unbounded_variance,       ///< the likelihood grows with σ without bound
  not_converged,            ///< no maximum was found
};

/// A fit or a problem, never both.
struct CumulativeLinkAnswer {
  std::optional<CumulativeLinkFit> fit{};
  CumulativeLinkProblem problem = CumulativeLinkProblem::not_converged;  ///< where there is no fit
  std::optional<std::size_t> unused_category{};  ///< the lowest one, where that is the problem
};

/// By Newton's method on the analytic gradient of ln L, from two values of σ; the model without random
/// intercepts has a single maximum at most (J. W. Pratt: Concavity of the log likelihood. Journal of the
/// American Statistical Association 76(373), 103–106, 1981). Responses that the fixed effects separate
/// are separated whatever the random intercepts.
///
/// Throws std::invalid_argument for no responses, fewer than two categories, a category beyond them, a
/// design that does not fit the responses, is not finite, or whose columns are linearly dependent
/// together with a column of ones, and where a factor that varies has fewer than two levels.
CumulativeLinkAnswer cumulative_link_fit(std::span<const OrdinalResponse> responses,
                                         const CumulativeLinkModel& model);

/// ln L (Laplace's, with random intercepts) at given θ, β, σ_p and σ_i. Throws as
/// `cumulative_link_fit` does, and for thresholds that do not increase.
double cumulative_link_log_likelihood(std::span<const OrdinalResponse> responses,
                                      const CumulativeLinkModel& model,
                                      const CumulativeLinkFit& at);

/// z = β/SE, and its two-sided p from the normal distribution. Throws std::invalid_argument for an
/// effect that is not in the fit.
struct WaldTest {
  double z = 0.0;
  double p = 1.0;
};
WaldTest wald_test(const CumulativeLinkFit& fit, std::size_t effect);

/// 2·(ln L of the larger − ln L of the smaller model) with the difference of their numbers of parameters;
/// `upper_tail` has its p. The models are nested and fitted to the same responses. Where they
/// differ by a σ, the smaller one lies on the boundary of the larger one, and p is too large (twice
/// the correct one for a single σ). Throws std::invalid_argument for different numbers of responses,
/// and where the larger model does not have more parameters or has a smaller likelihood.
ChiSquaredStatistic likelihood_ratio(const CumulativeLinkFit& smaller,
                                     const CumulativeLinkFit& larger);

}  // namespace asperity
