// The likelihood of counts by level, with its exact derivatives.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/psychometric_function.h"

namespace asperity {

/// k right of n trials at one level x. Levels without trials are left out; a level may come twice.
struct PsychometricBlock {
  double x = 0.0;
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
};

/// What is fitted besides α and ln β. A rate is fixed at a value, or free: γ in [0, ½], λ in
/// [0, `greatest_lambda`].
struct PsychometricModel {
  PsychometricShape shape = PsychometricShape::logistic;
  std::optional<double> gamma = 0.0;   ///< free where absent
  std::optional<double> lambda = 0.0;  ///< free where absent
  double greatest_lambda = 0.1;
};

/// Whether the count has the probability 0 whatever the function: hits at x = 0 of a weibull with
/// γ = 0.
bool is_impossible(const PsychometricBlock& block, const PsychometricModel& model);

/// The blocks with trials. Throws std::invalid_argument for more hits than trials, levels that are not
/// finite (or negative for a weibull), impossible counts, and rates outside [0, 1).
std::vector<PsychometricBlock> answered_blocks(std::span<const PsychometricBlock> blocks,
                                               const PsychometricModel& model);

/// The distinct levels in order, as the shape takes them: ln x for a weibull, where 0 is none.
std::vector<double> distinct_levels(std::span<const PsychometricBlock> blocks,
                                    PsychometricShape shape);

/// α, ln β, γ, λ; γ and λ keep their places when they are fixed.
using CurveParameters = Eigen::Vector4d;
using FreeParameters = std::array<bool, 4>;
/// Of those that are free.
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

struct CurveLikelihood {
  double value = 0.0;
  CurveParameters gradient = CurveParameters::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
};

/// The log likelihood as a function of the parameters, binomial coefficients included.
///
/// The slope has a bound, because few levels cannot tell a steep function from a step: F may not
/// rise from 0.01 to 0.99 within less than the smallest gap between neighbouring levels (of ln x for
/// a weibull).
class PsychometricLikelihood final {
 public:
  /// Throws as `answered_blocks` does, and for fewer than two levels.
  PsychometricLikelihood(std::span<const PsychometricBlock> blocks, const PsychometricModel& model);

  const CurveBounds& bounds() const noexcept { return bounds_; }
  const FreeParameters& free() const noexcept { return free_; }
  const std::vector<double>& levels() const noexcept { return levels_; }
  const std::vector<PsychometricBlock>& blocks() const noexcept { return blocks_; }
  const PsychometricModel& model() const noexcept { return model_; }

  PsychometricFunction function(const CurveParameters& at) const;
  double value(const CurveParameters& at) const;
  CurveLikelihood likelihood(const CurveParameters& at) const;
  /// With a probability of its own for each block: no model does better.
  double saturated() const;
  /// The greatest of a function that is constant over the levels, which β → 0 approaches: with
  /// values between those of F = `F.low` and `F.high`. At x = 0 a weibull stays γ.
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
