// The delta method from the observed information; ends of the profile likelihood of α by steps and TOMS 748.

#include "analysis/psychometric/psychometric_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/tools/roots.hpp>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/psychometric/psychometric_maximum.h"

namespace asperity {
namespace {

// ∂(threshold)/∂(α, ln β, γ, λ). With r = 1 − γ − λ, F = (performance − γ)/r and t = t(F), the threshold
// is x = α + t/β, or α·e^{t/β} for a weibull. Hence
//
//   ∂x/∂t = 1/β (x/β)        ∂x/∂α = 1 (x/α)        ∂x/∂ln β = −t·∂x/∂t
//   ∂F/∂γ = (F − 1)/r        ∂F/∂λ = F/r            dt/dF = 1/F′(t)
CurveParameters threshold_gradient(const PsychometricFunction& f, double performance) {
  const double reach = 1.0 - f.gamma - f.lambda;
  const double F = (performance - f.gamma) / reach;
  const double t = standard_quantile(f.shape, F);
  const double dt_dF = 1.0 / standard_curve(f.shape, t).d1;
  const double x = f.inverse(performance);
  const double dx_dt = (is_weibull(f.shape) ? x : 1.0) / f.beta;
  CurveParameters gradient;
  gradient << (is_weibull(f.shape) ? x / f.alpha : 1.0), -dx_dt * t,
      dx_dt * dt_dF * (F - 1.0) / reach, dx_dt * dt_dF * F / reach;
  return gradient;
}

// Where the profile likelihood of α has fallen by `fall`, on the side to which `signed_step` points.
std::optional<double> profile_end(const PsychometricLikelihood& data, const CurveSolution& solution,
                                  double signed_step, double fall) {
  FreeParameters others = data.free();
  others[0] = false;
  const double alpha = solution.maximum.at(0);
  // Far from the levels the best functions are constant. F(α) is their limit: an α above all levels
  // leaves values up to F(α), one below them values from F(α).
  const double at_alpha = standard_curve(data.model().shape, 0.0).F;
  const double far_away =
      data.constant(signed_step < 0.0 ? CurveRange{.low = at_alpha} : CurveRange{.high = at_alpha});
  if (solution.maximum.value - far_away < fall) {
    return std::nullopt;
  }
  const auto missing = [&](double at) {
    if (is_weibull(data.model().shape) && !(at > 0.0)) {
      return std::numeric_limits<double>::infinity();
    }
    CurveParameters start = solution.maximum.at;
    start(0) = at;
    return solution.maximum.value - climb(data, start, others).value - fall;
  };
  constexpr double kMostSteps = 1e6;
  for (double steps = 1.0; steps < kMostSteps; steps += std::max(0.5, 0.05 * steps)) {
    const double end = alpha + steps * signed_step;
    if (missing(end) >= 0.0) {
      // TOMS 748 needs finite values at both ends of its bracket.
      const auto error = [&](double at) { return std::min(missing(at), 1e10); };
      std::uintmax_t iterations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          error, std::min(alpha, end), std::max(alpha, end),
          boost::math::tools::eps_tolerance<double>(40), iterations);
      return low + 0.5 * (high - low);
    }
  }
  return std::nullopt;
}

ConfidenceInterval around_threshold(const PsychometricFunction& f, double threshold, double half) {
  const double low = threshold - half;
  return {.low = f.shape == PsychometricShape::weibull ? std::max(0.0, low) : low,
          .high = threshold + half};
}

}  // namespace

std::optional<PsychometricPrecision> delta_method_precision(const PsychometricLikelihood& data,
                                                            const CurveSolution& solution,
                                                            const PsychometricQuestion& question) {
  const std::vector<Eigen::Index> places = places_of(solution.free);
  const Eigen::MatrixXd information = -data.likelihood(solution.maximum.at).hessian(places, places);
  const CholeskyFactors factored(information);
  if (!factored.is_positive_definite()) {
    return std::nullopt;
  }
  const Eigen::MatrixXd covariance = factored.inverse();
  const PsychometricFunction f = data.function(solution.maximum.at);
  const Eigen::VectorXd gradient = threshold_gradient(f, question.performance)(places);
  PsychometricPrecision answer;
  answer.alpha_se = std::sqrt(covariance(0, 0));
  answer.beta_se = f.beta * std::sqrt(covariance(1, 1));  // dβ/d(ln β) = β
  answer.threshold_se = std::sqrt(gradient.dot(covariance * gradient));
  const double half = normal_limit(question.confidence) * answer.threshold_se;
  const double threshold = f.inverse(question.performance);
  answer.threshold = around_threshold(f, threshold, half);
  return answer;
}

std::optional<PsychometricPrecision> overdispersed_precision(const PsychometricPrecision& binomial,
                                                             const PsychometricFunction& f,
                                                             const PsychometricQuestion& question,
                                                             const Dispersion& dispersion) {
  const auto limit = t_limit({.confidence = question.confidence, .df = dispersion.df});
  if (!limit) {
    return std::nullopt;
  }
  const double factor = std::sqrt(std::max(1.0, dispersion.value));
  PsychometricPrecision answer{.alpha_se = factor * binomial.alpha_se,
                               .beta_se = factor * binomial.beta_se,
                               .threshold_se = factor * binomial.threshold_se};
  const double half = *limit * answer.threshold_se;
  const double threshold = f.inverse(question.performance);
  answer.threshold = around_threshold(f, threshold, half);
  return answer;
}

ProfileInterval profile_interval(const PsychometricLikelihood& data, const CurveSolution& solution,
                                 const PsychometricPrecision& precision, double confidence) {
  const double z = normal_limit(confidence);
  const double fall = 0.5 * z * z;
  return {.low = profile_end(data, solution, -precision.alpha_se, fall),
          .high = profile_end(data, solution, precision.alpha_se, fall)};
}

}  // namespace asperity
