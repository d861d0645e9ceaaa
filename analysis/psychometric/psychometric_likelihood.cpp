// Adds the log likelihoods of blocks over α, ln β, γ and λ, with bounds of the slope from the spacing of the levels.

#include "analysis/psychometric/psychometric_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Core>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kGreatestGamma = 0.5;
constexpr double kSlopeRange = 12.0;  // the range of ln β below its upper bound
constexpr double kSteepest = 0.99;    // F at the end of the smallest gap, 1 − this at its start
constexpr double kLeastProbability = 1e-300;
constexpr double kNoBound = std::numeric_limits<double>::infinity();

double log_of_hit(const PsychometricFunction& f, const StandardCurve& s) {
  return std::log(std::max(f.gamma + (1.0 - f.gamma - f.lambda) * s.F, kLeastProbability));
}
double log_of_miss(const PsychometricFunction& f, const StandardCurve& s) {
  return std::log(std::max(f.lambda + (1.0 - f.gamma - f.lambda) * s.Q, kLeastProbability));
}

double log_probability_of(const PsychometricBlock& block, const PsychometricFunction& f,
                          const StandardCurve& s) {
  double sum = 0.0;
  if (hits_of(block) > 0.0) sum += hits_of(block) * log_of_hit(f, s);
  if (misses_of(block) > 0.0) sum += misses_of(block) * log_of_miss(f, s);
  return sum;
}

struct SplitCount {
  double hits = 0.0;
  double trials = 0.0;
};

// k·ln p + (n − k)·ln(1 − p) at the p in [low, high] where it is greatest.
double log_probability_within(const SplitCount& count, double low, double high) {
  const double k = count.hits;
  const double n = count.trials;
  if (n == 0.0) {
    return 0.0;
  }
  const double p = std::clamp(k / n, low, high);
  return (k > 0.0 ? k * std::log(std::max(p, kLeastProbability)) : 0.0) +
         (k < n ? (n - k) * std::log(std::max(1.0 - p, kLeastProbability)) : 0.0);
}

}  // namespace

std::vector<Eigen::Index> places_of(const FreeParameters& free) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i]) {
      places.push_back(static_cast<Eigen::Index>(i));
    }
  }
  return places;
}

PsychometricLikelihood::PsychometricLikelihood(std::span<const PsychometricBlock> blocks,
                                               const PsychometricModel& model)
    : model_(model), blocks_(answered_blocks(blocks, model)) {
  levels_ = distinct_levels(blocks_, model.shape);
  if (levels_.size() < 2) {
    throw std::invalid_argument(
        "blocks has fewer than two levels with trials; a slope needs at least two");
  }
  double gap = kNoBound;
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    gap = std::min(gap, levels_[i] - levels_[i - 1]);
  }
  const double rise =
      standard_quantile(model.shape, kSteepest) - standard_quantile(model.shape, 1.0 - kSteepest);
  const double steepest = std::log(rise / gap);
  bounds_.low << (is_weibull(model.shape) ? std::numeric_limits<double>::min() : -kNoBound),
      steepest - kSlopeRange, model.gamma.value_or(0.0), model.lambda.value_or(0.0);
  bounds_.high << kNoBound, steepest, model.gamma.value_or(kGreatestGamma),
      model.lambda.value_or(model.greatest_lambda);
  if (model.slope) {
    if (!(model.slope->least > 0.0 && model.slope->least < model.slope->greatest)) {
      throw std::invalid_argument(
          "slope: its limits are not in order; they must satisfy 0 < least < greatest");
    }
    bounds_.low(1) = std::log(model.slope->least);
    bounds_.high(1) = std::log(model.slope->greatest);
  }
  free_ = {true, true, !model.gamma, !model.lambda};
  for (const PsychometricBlock& block : blocks_) {
    const auto n = static_cast<double>(block.trials);
    const double k = hits_of(block);
    constant_ += log_choose(n, k);
  }
}

PsychometricFunction PsychometricLikelihood::function(const CurveParameters& at) const {
  return {.shape = model_.shape,
          .alpha = at(0),
          .beta = std::exp(at(1)),
          .gamma = at(2),
          .lambda = at(3)};
}

double PsychometricLikelihood::value(const CurveParameters& at) const {
  const PsychometricFunction f = function(at);
  double sum = constant_;
  for (const PsychometricBlock& block : blocks_) {
    const StandardCurve s = standard_curve(model_.shape, standard_argument(f, block.x));
    sum += log_probability_of(block, f, s);
  }
  return sum;
}

std::vector<LogProbabilities> PsychometricLikelihood::log_probabilities(
    const CurveParameters& at) const {
  const PsychometricFunction f = function(at);
  std::vector<LogProbabilities> of_blocks{};
  for (const PsychometricBlock& block : blocks_) {
    const StandardCurve s = standard_curve(model_.shape, standard_argument(f, block.x));
    of_blocks.push_back({.hit = log_of_hit(f, s), .miss = log_of_miss(f, s)});
  }
  return of_blocks;
}

double PsychometricLikelihood::value(std::span<const LogProbabilities> of_blocks) const {
  double sum = constant_;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    double of_block = 0.0;
    if (hits_of(blocks_[i]) > 0.0) of_block += hits_of(blocks_[i]) * of_blocks[i].hit;
    if (misses_of(blocks_[i]) > 0.0) of_block += misses_of(blocks_[i]) * of_blocks[i].miss;
    sum += of_block;
  }
  return sum;
}

CurveLikelihood PsychometricLikelihood::likelihood(const CurveParameters& at) const {
  const PsychometricFunction f = function(at);
  CurveLikelihood answer{.value = constant_};
  for (const PsychometricBlock& block : blocks_) {
    const double t = standard_argument(f, block.x);
    const StandardCurve s = standard_curve(model_.shape, t);
    answer.value += log_probability_of(block, f, s);
    add_derivatives(block, f, std::isfinite(t) ? t : 0.0, s, answer);
  }
  return answer;
}

double PsychometricLikelihood::saturated() const {
  double sum = constant_;
  for (const PsychometricBlock& block : blocks_) {
    const auto n = static_cast<double>(block.trials);
    const double k = hits_of(block);
    sum += k > 0.0 ? k * std::log(k / n) : 0.0;
    sum += k < n ? (n - k) * std::log((n - k) / n) : 0.0;
  }
  return sum;
}

double PsychometricLikelihood::constant(const CurveRange& F) const {
  SplitCount at_zero;
  SplitCount above;
  for (const PsychometricBlock& block : blocks_) {
    SplitCount& count = is_weibull(model_.shape) && block.x == 0.0 ? at_zero : above;
    count.hits += hits_of(block);
    count.trials += static_cast<double>(block.trials);
  }
  const double least_gamma = bounds_.low(2);
  const double greatest_gamma = bounds_.high(2);
  // ψ = γ + (1 − γ − λ)·F grows with γ and falls with λ.
  const double low = least_gamma + (1.0 - least_gamma - bounds_.high(3)) * F.low;
  const double high = greatest_gamma + (1.0 - greatest_gamma - bounds_.low(3)) * F.high;
  return constant_ + log_probability_within(at_zero, least_gamma, greatest_gamma) +
         log_probability_within(above, low, high);
}

void PsychometricLikelihood::add_derivatives(const PsychometricBlock& block,
                                             const PsychometricFunction& f, double t,
                                             const StandardCurve& s,
                                             CurveLikelihood& answer) const {
  // ψ = γ + r·F(t) with r = 1 − γ − λ, and t = β(x − α) or β·ln(x/α). By ln β, t is its own derivative:
  //
  //   ∂ψ/∂α = r·F′·t_α      ∂ψ/∂ln β = r·F′·t      ∂ψ/∂γ = 1 − F      ∂ψ/∂λ = −F
  //
  // with t_α = −β and t_αα = 0, or −β/α and β/α². For a term k·ln p,
  // ∇ = k/p·∇p and ∇∇ᵀ = k·(∇∇ᵀp/p − (∇p/p)(∇p/p)ᵀ); for (n − k)·ln(1 − p), p and its derivatives change sign.
  const bool weibull = is_weibull(model_.shape);
  const double t_alpha = weibull ? -f.beta / f.alpha : -f.beta;
  const double t_alpha_alpha = weibull ? f.beta / (f.alpha * f.alpha) : 0.0;
  const double reach = 1.0 - f.gamma - f.lambda;
  CurveParameters first;
  first << reach * s.d1 * t_alpha, reach * s.d1 * t, s.Q, -s.F;
  Eigen::Matrix4d second = Eigen::Matrix4d::Zero();
  second(0, 0) = reach * (s.d2 * t_alpha * t_alpha + s.d1 * t_alpha_alpha);
  second(0, 1) = reach * (s.d2 * t_alpha * t + s.d1 * t_alpha);
  second(1, 1) = reach * (s.d2 * t * t + s.d1 * t);
  for (const Eigen::Index rate : {2, 3}) {
    second(0, rate) = -s.d1 * t_alpha;
    second(1, rate) = -s.d1 * t;
  }
  second = second.selfadjointView<Eigen::Upper>();
  const auto add = [&](double count, double probability, double sign) {
    const double p = std::max(probability, kLeastProbability);
    answer.gradient += count * sign / p * first;
    const CurveParameters relative = first / p;
    answer.hessian += count * (sign / p * second - relative * relative.transpose());
  };
  if (hits_of(block) > 0.0) {
    add(hits_of(block), f.gamma + reach * s.F, 1.0);
  }
  if (misses_of(block) > 0.0) {
    add(misses_of(block), f.lambda + reach * s.Q, -1.0);
  }
}

}  // namespace asperity
