// The likelihood of a psychometric function given counts by level, with its exact derivatives.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/psychometric_function.h"

namespace asperity {

/// k hits in n trials at one level x. Levels without trials are left out; several blocks may have one level.
struct PsychometricBlock {
  double x = 0.0;
  std::uint64_t trials = 0;
  std::uint64_t hits = 0;
  /// The hits that are expected of trials without a choice, if each is a guess; those trials are no `hits`. The likelihood is
  /// then the mean log likelihood of such guesses, whose counts vary less than binomial ones: intervals and tests of the fit
  /// that assume binomial counts do not hold.
  double guessed_hits = 0.0;
};

/// k and n − k with guessed hits.
inline double hits_of(const PsychometricBlock& block) noexcept {
  return static_cast<double>(block.hits) + block.guessed_hits;
}
inline double misses_of(const PsychometricBlock& block) noexcept {
  return static_cast<double>(block.trials - block.hits) - block.guessed_hits;
}

/// Limits of β, for few trials at levels that an adaptive procedure chose: such data hardly determine a slope, and the
/// threshold of a flat function can be anywhere. 0 < least < greatest.
struct SlopeRange {
  double least = 0.0;
  double greatest = 0.0;
};

/// The parameters that are fitted in addition to α and ln β. A rate is fixed at a value, or free: γ in [0, ½], λ in
/// [0, `greatest_lambda`].
struct PsychometricModel {
  PsychometricShape shape = PsychometricShape::logistic;
  std::optional<double> gamma = 0.0;   ///< free where absent
  std::optional<double> lambda = 0.0;  ///< free where absent
  double greatest_lambda = 0.1;
  /// Where absent, the levels limit β (`PsychometricLikelihood`). Only `maximise_psychometric` takes limits.
  std::optional<SlopeRange> slope{};
};

/// Whether the count has the probability 0 under every function of the model: hits at x = 0 of a weibull
/// with γ = 0.
bool is_impossible(const PsychometricBlock& block, const PsychometricModel& model);

/// The blocks with trials. Errors: std::invalid_argument for more hits than trials, levels that are not
/// finite (or negative for a weibull), impossible counts, and rates outside [0, 1).
std::vector<PsychometricBlock> answered_blocks(std::span<const PsychometricBlock> blocks,
                                               const PsychometricModel& model);

/// The distinct levels in ascending order: x, or ln x for a weibull, without x = 0.
std::vector<double> distinct_levels(std::span<const PsychometricBlock> blocks,
                                    PsychometricShape shape);

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
