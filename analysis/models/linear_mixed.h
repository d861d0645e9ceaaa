// Linear mixed model with a random intercept per participant, fitted by restricted maximum likelihood.

#pragma once

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// Measurements of participants, a row each. The first column of the design is 1.
struct GroupedMeasurements {
  Eigen::MatrixXd design{};  ///< X: rows × fixed effects
  Eigen::VectorXd y{};
  std::vector<std::size_t> participant{};  ///< of each row, numbered from 0
};

/// Why there is no fit.
enum class NoLinearMixed {
  /// Fewer than two have rows, or the fixed effects determine every participant's mean.
  too_few_participants,
  too_few_rows,             ///< no more rows than participants, or than fixed effects
  dependent_effects,        ///< a column of the design is a combination of the columns before it
  no_participant_variance,  ///< σ_b is estimated as 0: the maximum lies at the boundary
  no_residual_variance,     ///< participants and fixed effects determine every measurement
};

/// The restricted maximum likelihood (REML) of
///
///   y_ij = x_ij'β + b_i + ε_ij,  b_i ~ N(0, σ_b²),  ε_ij ~ N(0, σ²)  [Laird 1982],
///
/// for participant i and row j. With λ = σ_b²/σ², M = I + λ·Z·Z' (Z: which row is whose), and
/// P = M⁻¹ − M⁻¹X(X'M⁻¹X)⁻¹X'M⁻¹, −2 ln L_R = (n − p)·ln 2πσ² + y'Py/σ² + ln|M| + ln|X'M⁻¹X|: lme4's criterion.
///
/// Tests use Satterthwaite's degrees of freedom [Satterthwaite 1946], as lmerTest does [Kuznetsova 2017]: for a
/// combination l'β with the variance f = l'Cl, C = σ²(X'M⁻¹X)⁻¹, they are 2f²/Var(f), where
/// Var(f) = g'(2H⁻¹)g, g the gradient of f over (λ, σ²), H the observed Hessian of −2 ln L_R. They do not depend on the
/// parameters of the variances (such as σ_b instead of λ), because the criterion is stationary at the estimate.
///
/// Errors of β do not include that of σ_b and σ (no correction of Kenward and Roger).
///
/// [Laird 1982] Laird, Ware: Random-effects models for longitudinal data. [Satterthwaite 1946] Satterthwaite: An
/// approximate distribution of estimates of variance components. [Kuznetsova 2017] Kuznetsova, Brockhoff, Christensen:
/// lmerTest package: tests in linear mixed effects models.
class LinearMixedFit {
 public:
  /// Numbers that determine all others; made by `linear_mixed`.
  struct Estimates {
    Eigen::VectorXd beta{};
    Eigen::MatrixXd covariance{};    ///< C
    Eigen::MatrixXd over_lambda{};   ///< ∂C/∂λ
    Eigen::Matrix2d hessian{};       ///< of −2 ln L_R over (λ, σ²)
    double lambda = 0.0;             ///< λ
    double residual_variance = 0.0;  ///< σ²
    double log_likelihood = 0.0;     ///< ln L_R
    std::size_t participants = 0;
    std::size_t rows = 0;
  };
  explicit LinearMixedFit(Estimates estimates) : at_(std::move(estimates)) {}

  const Eigen::VectorXd& beta() const noexcept { return at_.beta; }
  Eigen::VectorXd standard_error() const;
  double participant_variance() const noexcept { return at_.lambda * at_.residual_variance; }
  double residual_variance() const noexcept { return at_.residual_variance; }
  /// σ_b²/(σ_b² + σ²): the correlation of two measurements of a participant with the same fixed effects.
  double intraclass_correlation() const noexcept { return at_.lambda / (1.0 + at_.lambda); }
  /// Comparable between models with the same fixed effects only.
  double log_likelihood() const noexcept { return at_.log_likelihood; }
  std::size_t participants() const noexcept { return at_.participants; }
  std::size_t rows() const noexcept { return at_.rows; }

  /// The t test of l'β = 0.
  struct Combination {
    double estimate = 0.0;
    double standard_error = 0.0;
    double t = 0.0;
    double df = 0.0;  ///< Satterthwaite's
    double p = 1.0;
    ConfidenceInterval interval{};
  };
  /// Throws std::invalid_argument unless there is a weight per fixed effect, one of them not 0.
  Combination combination(const Eigen::VectorXd& weights, double confidence = 0.95) const;
  /// Of one fixed effect.
  Combination effect(Eigen::Index column, double confidence = 0.95) const;

  /// The F test of q fixed effects = 0, in adjacent columns. Along the principal axes of their covariance F is the mean of q
  /// independent t², with E(F) = Σν_m/(ν_m − 2)/q; `df2` is that of the F distribution with this mean [Fai 1996]:
  /// 2E/(E − q) with E the sum over ν_m > 2, and 2 where a ν_m is not above 2.
  ///
  /// [Fai 1996] Fai, Cornelius: Approximate F-tests of multiple degree of freedom hypotheses in generalized least
  /// squares analyses of unbalanced split-plot experiments.
  struct JointTest {
    double F = 0.0;
    double df1 = 1.0;
    double df2 = 1.0;
    double p = 1.0;
  };
  struct Columns {
    Eigen::Index first = 0;
    Eigen::Index count = 1;
  };
  /// Throws std::invalid_argument for columns that are not in the design.
  JointTest joint_test(const Columns& columns) const;

 private:
  double degrees_of(const Eigen::VectorXd& weights) const;

  Estimates at_{};
};

/// Throws std::invalid_argument for data of different lengths, a number that is not finite, and a first column that is
/// not 1.
std::variant<LinearMixedFit, NoLinearMixed> linear_mixed(const GroupedMeasurements& data);

/// The columns of a design whose first column is 1 that are combinations of the columns before them, such as one that
/// does not vary. In ascending order.
std::vector<Eigen::Index> dependent_columns(const Eigen::MatrixXd& design);

}  // namespace asperity
