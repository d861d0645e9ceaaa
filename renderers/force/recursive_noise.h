// Declares coloured noise along the path of a hand.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "analysis/numbers/random.h"
#include "renderers/force/servo_low_pass.h"

namespace asperity {

/// Computes a stationary autoregressive process along the length of a path, for models whose texture belongs to the path.
///
///   y_j = Σ_{k=1..p} a_k·y_{j−k} + g·ξ_j            at the lengths ℓ = j/`steps_per_m`, p ≤ 4
///   y(ℓ)                                             linear between the y_j; y(0) = 0
///
/// ξ_j is the standard normal number that belongs to the seed and to j. g is chosen so that the y_j have the standard
/// deviation `sd`: g² = sd²·σ²_p with σ²_p the error variance of the predictor of order p (stationary_predictors). From
/// ℓ = 1/`steps_per_m` on the y_j are stationary, because y_0 … y_{1−p} are drawn with their joint distribution; y(0) =
/// 0 instead of y_0, so that a hand that touches down feels no texture before it moves.
///
/// Interpolation multiplies the spectrum by sinc⁴(f/(v·`steps_per_m`)), −1.8 dB at a quarter of the nodes' rate. What is
/// above 0.4 of the servo rate is filtered out (ServoLowPass). A path that grows by more than 64 nodes in a tick skips
/// noise.
///
/// Errors: the constructor throws std::invalid_argument for more than 4 coefficients and for coefficients of a process
/// that is not stationary.
///
/// Real-time: `reset` and `advance` do not allocate, lock or throw.
class RecursiveNoise final {
 public:
  static constexpr std::size_t kMostCoefficients = 4;

  struct Settings {
    std::span<const double> coefficients{};  ///< a_1 … a_p
    double sd = 0.0;                         ///< of the y_j
    double steps_per_m = 0.0;                ///< nodes per metre of the path
  };

  RecursiveNoise(const Settings& settings, const Random& noise);

  void reset() noexcept;
  /// The noise after the path has grown to this length, below half the servo rate. To be called once in each tick.
  double advance(double length_m) noexcept;

 private:
  static constexpr std::uint64_t kMostNodesPerTick = 64;

  double at(double length_m) noexcept;
  double node(std::uint64_t j) const noexcept;

  Random noise_;
  std::size_t order_ = 0;
  std::array<double, kMostCoefficients> coefficients_{};
  double gain_ = 0.0;  ///< g
  double sd_ = 0.0;
  double steps_per_m_ = 0.0;
  /// Of the predictors of order 1 … p − 1, by which the first values are drawn.
  std::array<std::array<double, kMostCoefficients>, kMostCoefficients> predictors_{};
  std::array<double, kMostCoefficients> predictor_sd_{};
  ServoLowPass low_pass_{};
  double length_m_ = 0.0;
  std::uint64_t step_ = 0;                          ///< j of the first of `values_`
  std::array<double, kMostCoefficients> values_{};  ///< y_j, y_{j−1}, …
  double next_ = 0.0;                               ///< y_{j+1}
};

}  // namespace asperity
