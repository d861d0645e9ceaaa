// The likelihood of a cumulative link model: Laplace's approximation and its gradient.

#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "analysis/models/cumulative_link.h"

namespace asperity {

/// θ, with the terms of the probability of a category between two of them that depend only on their
/// distance Δ.
struct OrdinalThresholds {
  explicit OrdinalThresholds(Eigen::VectorXd increasing);

  Eigen::VectorXd at{};
  std::vector<double> log_gap{};    ///< ln(1 − e^−Δ) of the categories from the second one
  std::vector<double> gap_slope{};  ///< its derivative, 1/(e^Δ − 1)
};

/// A value of each parameter. β belongs to columns of the design that are scaled to the mean square 1;
/// σ of a factor that does not vary is 0.
struct OrdinalParameters {
  OrdinalThresholds thresholds;
  Eigen::VectorXd beta{};
  double sigma_p = 0.0;
  double sigma_i = 0.0;
};

/// Random intercepts of participants and items, in units of σ.
struct CrossedIntercepts {
  Eigen::VectorXd u{};
  Eigen::VectorXd v{};
};

/// ln L of `CumulativeLinkFit` for these responses. It keeps references to both arguments.
class OrdinalLikelihood final {
 public:
  /// Throws std::invalid_argument as `cumulative_link_fit` does.
  OrdinalLikelihood(std::span<const OrdinalResponse> responses, const CumulativeLinkModel& model);

  Eigen::Index thresholds() const { return static_cast<Eigen::Index>(model_.categories) - 1; }
  Eigen::Index effects() const { return design_.cols(); }
  /// By what the columns of the design were divided.
  const Eigen::VectorXd& scale() const { return scale_; }
  /// Intercepts of 0.
  CrossedIntercepts none() const;

  /// ln L. Moves `intercepts` from where they are to the mode of the joint density.
  double value(const OrdinalParameters& at, CrossedIntercepts& intercepts) const;

  /// Its gradient by θ, β, σ_p and σ_i. Moves `intercepts` as `value` does.
  ///
  /// ln L = g(ψ, û(ψ)) − ½·ln|H(ψ, û(ψ))| of the parameters ψ, with g the logarithm of the joint density
  /// and ∂g/∂u = 0 at the mode û, so that
  ///
  ///   d ln L = ∂_ψ g − ½·tr(H⁻¹·dH),  H = Σ w_i·z_i·z_i' + I,  z_i = σ_p·e_p + σ_i·e_j
  ///
  /// over the responses i, with s_i and −w_i the first two derivatives of ln P_i by η_i. With
  /// c_i = z_i'H⁻¹z_i the trace is Σ c_i·dw_i + 2·Σ w_i·z_i'H⁻¹·dz_i. w_i depends on θ and on η_i, which
  /// moves with ψ and, by z_i'dû, with the mode: dû = H⁻¹·d(∂g/∂u), ∂g/∂u = Σ s_i·z_i − u. The sum
  /// Σ c_i·(∂w_i/∂η_i)·z_i'dû is q'd(∂g/∂u) with q = H⁻¹·Σ c_i·(∂w_i/∂η_i)·z_i: no derivative of û is
  /// needed.
  Eigen::VectorXd gradient(const OrdinalParameters& at, CrossedIntercepts& intercepts) const;

 private:
  struct Inverse;
  struct Curvature;

  double predictor(const Eigen::VectorXd& fixed, const OrdinalParameters& at,
                   const CrossedIntercepts& intercepts, std::size_t row) const;
  double joint_density(const Eigen::VectorXd& fixed, const OrdinalParameters& at,
                       const CrossedIntercepts& intercepts) const;
  double to_mode(const OrdinalParameters& at, CrossedIntercepts& intercepts) const;
  Curvature curvature(const OrdinalParameters& at, const CrossedIntercepts& intercepts,
                      CrossedIntercepts* slope = nullptr) const;
  void refuse_impossible() const;

  std::span<const OrdinalResponse> responses_{};
  const CumulativeLinkModel& model_;
  Eigen::VectorXd scale_{};
  Eigen::MatrixXd design_{};
  std::vector<Eigen::Index> participant_{};  // 0 throughout, where participants do not vary
  std::vector<Eigen::Index> item_{};
  Eigen::Index participants_ = 1;
  Eigen::Index items_ = 1;
};

}  // namespace asperity
