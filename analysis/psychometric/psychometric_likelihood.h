// The likelihood of a psychometric function given counts by level, with its exact derivatives.

#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

/// α, ln β, γ, λ; γ and λ keep their places when they are fixed.
using CurveParameters = Eigen::Vector4d;
using FreeParameters = std::array<bool, 4>;
/// The indices of the parameters that are free.
std::vector<Eigen::Index> places_of(const FreeParameters& free);

struct CurveBounds {
  CurveParameters low = CurveParameters::Zero();
  CurveParameters high = CurveParameters::Zero();
};

/// Values of F.
struct CurveRange {
  double low = 0.0;
  double high = 1.0;
};

/// ln ψ and ln(1 − ψ) at the level of a block.
struct LogProbabilities {
  double hit = 0.0;
  double miss = 0.0;
};

struct CurveLikelihood {
  double value = 0.0;
  CurveParameters gradient = CurveParameters::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
};

/// The log likelihood as a function of the parameters:
///
///   ln L = Σ ln(n over k) + k·ln ψ(x) + (n − k)·ln(1 − ψ(x))
///
/// The slope has an upper bound, because data at few levels do not distinguish a steep function from a
/// step: F may not rise from 0.01 to 0.99 within less than the smallest gap between neighbouring levels
/// (of ln x for a weibull), unless the model limits the slope.
class PsychometricLikelihood final {
 public:
  /// Errors: those of `answered_blocks`, and std::invalid_argument for fewer than two levels and for limits of the slope
  /// that are not 0 < least < greatest.
  PsychometricLikelihood(std::span<const PsychometricBlock> blocks, const PsychometricModel& model);

  const CurveBounds& bounds() const noexcept { return bounds_; }
  const FreeParameters& free() const noexcept { return free_; }
  const std::vector<double>& levels() const noexcept { return levels_; }
  const std::vector<PsychometricBlock>& blocks() const noexcept { return blocks_; }
  const PsychometricModel& model() const noexcept { return model_; }

  PsychometricFunction function(const CurveParameters& at) const;
  double value(const CurveParameters& at) const;
  /// By block. They depend on the model and the levels, but not on the counts.
  std::vector<LogProbabilities> log_probabilities(const CurveParameters& at) const;
  /// `value` at the parameters of these probabilities, in every bit.
  double value(std::span<const LogProbabilities> of_blocks) const;
  CurveLikelihood likelihood(const CurveParameters& at) const;
  /// The log likelihood with a separate probability k/n for each block: the upper limit of all models.
  double saturated() const;
  /// The greatest log likelihood of functions that are constant over the levels, the limit of β → 0, with
  /// values between those of F = `F.low` and `F.high`. At x = 0 a weibull remains γ.
  double constant(const CurveRange& F = {}) const;

 private:
  void add_derivatives(const PsychometricBlock& block, const PsychometricFunction& f, double t,
                       const StandardCurve& s, CurveLikelihood& answer) const;

  PsychometricModel model_{};
  std::vector<PsychometricBlock> blocks_{};
  std::vector<double> levels_{};
  CurveBounds bounds_{};
  FreeParameters free_{};
  double constant_ = 0.0;
};

}  // namespace asperity
