#include "analysis/psychometric_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>

#include <Eigen/Dense>
#include <boost/math/tools/roots.hpp>

#include "analysis/psychometric_maximum.h"
#include "analysis/tail_probabilities.h"

namespace asperity {
namespace {

std::optional<double> pearson(const std::vector<PsychometricBlock>& blocks,
                              const PsychometricFunction& f) {
  double sum = 0.0;
  for (const PsychometricBlock& block : blocks) {
    const auto n = static_cast<double>(block.trials);
    const double p = f.value(block.x);
    const double residual = static_cast<double>(block.hits) - n * p;
    sum += residual * residual / (n * p * (1.0 - p));
  }
  return std::isfinite(sum) ? std::optional<double>(sum) : std::nullopt;
}

// d(threshold)/d(α, ln β, γ, λ).
CurveParameters threshold_gradient(const PsychometricFunction& f, double performance) {
  const double reach = 1.0 - f.gamma - f.lambda;
  const double F = (performance - f.gamma) / reach;
  const double t = standard_quantile(f.shape, F);
  const double dt_dF = 1.0 / standard_curve(f.shape, t).d1;
  // x = α + t/β, or α·e^{t/β}
  const double x = f.inverse(performance);
  const double dx_dt = (is_weibull(f.shape) ? x : 1.0) / f.beta;
  CurveParameters gradient;
  gradient << (is_weibull(f.shape) ? x / f.alpha : 1.0), -dx_dt * t,
      dx_dt * dt_dF * (F - 1.0) / reach, dx_dt * dt_dF * F / reach;
  return gradient;
}

std::optional<PsychometricFit::Precision> precision_of(const PsychometricLikelihood& data,
                                                       const CurveSolution& solution,
                                                       const PsychometricQuestion& question) {
  const std::vector<Eigen::Index> places = places_of(solution.free);
  const Eigen::MatrixXd information = -data.likelihood(solution.maximum.at).hessian(places, places);
  const Eigen::LLT<Eigen::MatrixXd> factored(information);
  if (factored.info() != Eigen::Success) {
    return std::nullopt;
  }
  const auto size = static_cast<Eigen::Index>(places.size());
  const Eigen::MatrixXd covariance = factored.solve(Eigen::MatrixXd::Identity(size, size));
  const PsychometricFunction f = data.function(solution.maximum.at);
  const Eigen::VectorXd gradient = threshold_gradient(f, question.performance)(places);
  PsychometricFit::Precision answer;
  answer.alpha_se = std::sqrt(covariance(0, 0));
  answer.beta_se = f.beta * std::sqrt(covariance(1, 1));
  answer.threshold_se = std::sqrt(gradient.dot(covariance * gradient));
  const double half = normal_limit(question.confidence) * answer.threshold_se;
  const double threshold = f.inverse(question.performance);
  answer.threshold = {.low = threshold - half, .high = threshold + half};
  return answer;
}

PsychometricFit::Precision overdispersed(const PsychometricFit& fit, double limit) {
  const double factor = std::sqrt(std::max(1.0, *fit.dispersion));
  PsychometricFit::Precision answer{.alpha_se = factor * fit.precision->alpha_se,
                                    .beta_se = factor * fit.precision->beta_se,
                                    .threshold_se = factor * fit.precision->threshold_se};
  const double half = limit * answer.threshold_se;
  answer.threshold = {.low = fit.threshold - half, .high = fit.threshold + half};
  return answer;
}

std::optional<PsychometricFit::FreeLapses> free_lapses(std::span<const PsychometricBlock> blocks,
                                                       const PsychometricQuestion& question,
                                                       double log_likelihood) {
  if (!question.model.lambda) {
    return std::nullopt;
  }
  PsychometricModel model = question.model;
  model.lambda.reset();
  model.greatest_lambda = std::max(model.greatest_lambda, *question.model.lambda);
  const PsychometricMaximum maximum = maximise_psychometric(blocks, model);
  return PsychometricFit::FreeLapses{
      .lambda = maximum.function.lambda,
      .alpha = maximum.function.alpha,
      .threshold = maximum.function.inverse(question.performance),
      .likelihood_ratio = std::max(0.0, 2.0 * (maximum.log_likelihood - log_likelihood))};
}

// Where the profile of α has fallen by half the quantile of χ², on one side. Far beyond the levels
// the best functions of α are constant: with F(α) or less above it, with more below.
std::optional<double> profile_end(const PsychometricLikelihood& data, const CurveSolution& solution,
                                  double signed_error, double fall) {
  FreeParameters others = data.free();
  others[0] = false;
  const double alpha = solution.maximum.at(0);
  const double at_alpha = standard_curve(data.model().shape, 0.0).F;
  const double far_away = data.constant(signed_error < 0.0 ? CurveRange{.low = at_alpha}
                                                           : CurveRange{.high = at_alpha});
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
  constexpr double kFurthest = 1e6;
  for (double errors = 1.0; errors < kFurthest; errors += std::max(0.5, 0.05 * errors)) {
    const double end = alpha + errors * signed_error;
    if (missing(end) >= 0.0) {
      // Bisection of the bracket by TOMS 748 needs finite ends.
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

}  // namespace

PsychometricJudgement judge(std::span<const PsychometricBlock> all,
                            const PsychometricModel& model) {
  const std::vector<PsychometricBlock> blocks = answered_blocks(all, model);
  if (blocks.empty()) {
    return {.status = PsychometricStatus::no_data};
  }
  const auto every = [&](const auto& holds) {
    return std::all_of(blocks.begin(), blocks.end(), holds);
  };
  if (every([](const PsychometricBlock& b) { return b.hits == b.trials; })) {
    return {.status = PsychometricStatus::all_correct};
  }
  if (every([](const PsychometricBlock& b) { return b.hits == 0; })) {
    return {.status = PsychometricStatus::all_wrong};
  }
  std::map<double, HitCount> levels;
  for (const PsychometricBlock& block : blocks) {
    levels[block.x].hits += block.hits;
    levels[block.x].trials += block.trials;
  }
  if (distinct_levels(blocks, model.shape).size() < 2) {
    return {.status = PsychometricStatus::one_level};
  }
  if (!model.gamma || *model.gamma != 0.0 || !model.lambda || *model.lambda != 0.0) {
    return {};
  }
  // Wrong below, right above, at most one level between: no slope is the likeliest.
  std::optional<double> mixed;
  std::optional<double> last_wrong;
  std::optional<double> first_right;
  double before = 0.0;
  for (const auto& [x, count] : levels) {
    const double share = proportion(count);
    if (share < before) {
      return {};
    }
    before = share;
    if (share > 0.0 && share < 1.0) {
      if (mixed) {
        return {};
      }
      mixed = x;
    } else if (share == 0.0) {
      last_wrong = x;
    } else if (!first_right) {
      first_right = x;
    }
  }
  if (mixed) {
    return {.status = PsychometricStatus::quasi_separated,
            .bracket = ConfidenceInterval{.low = *mixed, .high = *mixed}};
  }
  return {.status = PsychometricStatus::separated,
          .bracket = ConfidenceInterval{.low = *last_wrong, .high = *first_right}};
}

std::optional<PsychometricFit> fit_psychometric(std::span<const PsychometricBlock> blocks,
                                                const PsychometricQuestion& question) {
  if (judge(blocks, question.model).status != PsychometricStatus::ok) {
    throw std::invalid_argument(
        "blocks: these data have no maximum-likelihood function; call judge first");
  }
  const double z = normal_limit(question.confidence);  // refuses improbable confidence
  const PsychometricLikelihood data(blocks, question.model);
  const CurveSolution solution = greatest_likelihood(data);
  if (!is_increasing(data, solution.maximum)) {
    return std::nullopt;
  }
  PsychometricFit fit;
  fit.function = data.function(solution.maximum.at);
  fit.log_likelihood = solution.maximum.value;
  fit.beta_at_bound = solution.at_bound.beta;
  fit.gamma_at_bound = solution.at_bound.gamma;
  fit.lambda_at_bound = solution.at_bound.lambda;
  const auto parameters = static_cast<double>(places_of(solution.free).size());
  fit.deviance = 2.0 * (data.saturated() - fit.log_likelihood);
  fit.deviance_df = static_cast<double>(data.blocks().size()) - parameters;
  fit.pearson = pearson(data.blocks(), fit.function);
  fit.deviance_p = upper_tail(ChiSquaredStatistic{.value = fit.deviance, .df = fit.deviance_df});
  fit.threshold = fit.function.inverse(question.performance);
  fit.free_lapses = free_lapses(blocks, question, fit.log_likelihood);
  if (fit.pearson && fit.deviance_df > 0.0) {
    fit.dispersion = *fit.pearson / fit.deviance_df;
  }
  if (fit.beta_at_bound) {
    return fit;
  }
  fit.precision = precision_of(data, solution, question);
  const auto t = t_limit({.confidence = question.confidence, .df = fit.deviance_df});
  if (fit.precision && fit.dispersion && t) {
    fit.overdispersed = overdispersed(fit, *t);
  }
  if (fit.precision) {
    const double fall = 0.5 * z * z;
    fit.profile_low = profile_end(data, solution, -fit.precision->alpha_se, fall);
    fit.profile_high = profile_end(data, solution, fit.precision->alpha_se, fall);
  }
  return fit;
}

}  // namespace asperity
