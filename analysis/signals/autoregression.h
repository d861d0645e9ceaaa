// Declares autoregressive models of a signal and two estimators of their coefficients.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

/// An autoregressive model of order p, with e_i white noise of mean 0 and variance 1.
///
///   m_i = Σ_{j=1..p} a_j·m_{i−j} + σ·e_i
struct Autoregression {
  std::vector<double> coefficients{};  ///< a_1 … a_p
  double innovation_variance = 0.0;    ///< σ², in the square of the signal's unit
};

/// The best predictors of a stationary process of variance 1, of the orders 0 to p, from its coefficients by the Levinson
/// recursion run downwards [Kay 1981].
struct Predictors {
  /// Element k holds the k coefficients of order k; the last element are the coefficients of the process.
  std::vector<std::vector<double>> coefficients{};
  /// Element k is the variance of the error of order k: 1 for k = 0, and σ² of the process for k = p.
  std::vector<double> error_variance{};
};

/// Nothing for coefficients of a process that is not stationary: one whose equation zᵖ = Σ a_j·z^{p−j} has a root with
/// |z| ≥ 1. The test is that every reflection coefficient (the last one of each order) lies between −1 and 1.
std::optional<Predictors> stationary_predictors(std::span<const double> coefficients);

/// The coefficients by Burg's method: each reflection coefficient minimises the sum of the forward and the backward
/// prediction error of its order [Burg 1975], [Kay 1981].
///
///   κ_k = 2·Σ f_i·b_{i−1} / Σ (f_i² + b_{i−1}²)
///
/// The sums run over all segments, which are parts of one process with no samples between them. The model is stationary
/// (|κ_k| ≤ 1 by construction, and < 1 unless the segments are predicted without error).
///
/// Signals are taken as they are: subtract the mean or a trend first. Constant 0 has the coefficients 0.
///
/// Errors: std::invalid_argument for an order of 0 and for a segment with 2·order samples or fewer.
///
/// [Burg 1975] Burg: Maximum entropy spectral analysis.
/// [Kay 1981] Kay, Marple: Spectrum analysis, a modern perspective.
Autoregression burg_autoregression(std::span<const std::vector<double>> segments,
                                   std::size_t order);

/// The model with the covariances c_0 … c_p of a stationary process, by the Levinson recursion; of order p.
///
/// Errors: std::invalid_argument for fewer than two covariances.
Autoregression autoregression_of_covariance(std::span<const double> covariance);

/// The coefficients that solve the Yule–Walker equations with the biased autocovariances c_k = Σ m_i·m_{i+k}/n, by the
/// Levinson recursion. Errors and signals as for Burg's method.
Autoregression yule_walker_autoregression(std::span<const std::vector<double>> segments,
                                          std::size_t order);

/// The coefficients of the same spectrum with less sharp peaks: a_j·ρ^j moves every root from z to ρ·z, 0 < ρ ≤ 1.
void shrink_poles(Autoregression& model, double rho);

}  // namespace asperity
