// A likelihood with its exact derivatives, and where it is greatest.

#include "analysis/psychometric_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/roots.hpp>
#include <nlopt.hpp>

#include "analysis/number_text.h"
#include "analysis/summary.h"
#include "analysis/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kGreatestGamma = 0.5;
constexpr double kSlopeRange = 12.0;  // ln β may be this much below its bound
constexpr double kSteepest = 0.99;    // F from 1 − this to this within the smallest gap
constexpr double kLeastProbability = 1e-300;

// F as a function of t = β(x − α), or β·ln(x/α), with its complement and derivatives.
struct Standard {
  double F = 0.0;
  double Q = 1.0;  // 1 − F, with its own digits
  double d1 = 0.0;
  double d2 = 0.0;
};

Standard gumbel_at(double scaled) {  // 1 − exp(−e^s), derivatives by s
  const double e = std::exp(scaled);
  Standard s{.F = -std::expm1(-e), .Q = std::exp(-e)};
  if (s.Q > 0.0) {
    s.d1 = e * s.Q;
    s.d2 = s.d1 * (1.0 - e);
  }
  return s;
}

Standard standard_at(PsychometricShape shape, double t) {
  switch (shape) {
    case PsychometricShape::logistic: {
      const double e = std::exp(-std::abs(t));
      const double big = 1.0 / (1.0 + e);
      const double small = e / (1.0 + e);
      Standard s{.F = t >= 0.0 ? big : small, .Q = t >= 0.0 ? small : big, .d1 = big * small};
      s.d2 = s.d1 * (s.Q - s.F);
      return s;
    }
    case PsychometricShape::normal: {
      Standard s{.F = 0.5 * std::erfc(-t / std::numbers::sqrt2),
                 .Q = 0.5 * std::erfc(t / std::numbers::sqrt2),
                 .d1 = std::exp(-0.5 * t * t) / std::sqrt(2.0 * std::numbers::pi)};
      s.d2 = s.d1 > 0.0 ? -t * s.d1 : 0.0;
      return s;
    }
    case PsychometricShape::gumbel: {
      Standard s = gumbel_at(std::numbers::ln10 * t);
      s.d1 *= std::numbers::ln10;
      s.d2 *= std::numbers::ln10 * std::numbers::ln10;
      return s;
    }
    case PsychometricShape::weibull:
      return gumbel_at(t);
  }
  throw std::invalid_argument("shape is none of logistic, normal, gumbel and weibull");
}

// t(F), the inverse.
double standard_quantile(PsychometricShape shape, double F) {
  if (!(F > 0.0 && F < 1.0)) {
    return F == 0.0 ? -kUnbounded
                    : (F == 1.0 ? kUnbounded : std::numeric_limits<double>::quiet_NaN());
  }
  switch (shape) {
    case PsychometricShape::logistic:
      return std::log(F / (1.0 - F));
    case PsychometricShape::normal:
      return boost::math::quantile(boost::math::normal(), F);
    case PsychometricShape::gumbel:
      return std::log10(-std::log1p(-F));
    case PsychometricShape::weibull:
      return std::log(-std::log1p(-F));
  }
  throw std::invalid_argument("shape is none of logistic, normal, gumbel and weibull");
}

bool is_weibull(PsychometricShape shape) { return shape == PsychometricShape::weibull; }

// β(x − α), or β·ln(x/α): −∞ at x = 0.
double argument(const PsychometricFunction& f, double x) {
  return is_weibull(f.shape) ? f.beta * std::log(x / f.alpha) : f.beta * (x - f.alpha);
}

// α, ln β, γ, λ; γ and λ keep their places when they are fixed.
using CurveParameters = Eigen::Vector4d;
using Free = std::array<bool, 4>;

struct Bounds {
  CurveParameters low = CurveParameters::Zero();
  CurveParameters high = CurveParameters::Zero();
};

struct CurveLikelihood {
  double value = 0.0;
  CurveParameters gradient = CurveParameters::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
};

std::vector<PsychometricBlock> answered(std::span<const PsychometricBlock> blocks,
                                        const PsychometricModel& model) {
  const auto refuse_rate = [](const std::optional<double>& rate, const char* name) {
    if (rate && !(*rate >= 0.0 && *rate < 1.0)) {
      throw std::invalid_argument(std::string(name) + " is " + number_text(*rate) +
                                  "; a rate lies between 0 and 1");
    }
  };
  refuse_rate(model.gamma, "gamma");
  refuse_rate(model.lambda, "lambda");
  refuse_rate(model.greatest_lambda, "greatest_lambda");
  if (model.gamma.value_or(0.0) + model.lambda.value_or(0.0) >= 1.0) {
    throw std::invalid_argument("gamma and lambda leave no room for the function");
  }
  std::vector<PsychometricBlock> kept;
  for (const PsychometricBlock& block : blocks) {
    if (block.hits > block.trials) {
      throw std::invalid_argument("hits is " + std::to_string(block.hits) + " of " +
                                  std::to_string(block.trials) + " trials; at most all can be");
    }
    if (!std::isfinite(block.x) || (is_weibull(model.shape) && block.x < 0.0)) {
      throw std::invalid_argument("x is " + number_text(block.x) +
                                  "; a level is a finite number, for a weibull from 0 up");
    }
    if (block.trials > 0) {
      kept.push_back(block);
    }
  }
  return kept;
}

// What `shape` calls a level: ln x for a weibull, where 0 is none.
std::vector<double> levels_of(std::span<const PsychometricBlock> blocks, PsychometricShape shape) {
  std::vector<double> levels;
  for (const PsychometricBlock& block : blocks) {
    if (!is_weibull(shape)) {
      levels.push_back(block.x);
    } else if (block.x > 0.0) {
      levels.push_back(std::log(block.x));
    }
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

class Problem final {
 public:
  Problem(std::span<const PsychometricBlock> blocks, const PsychometricModel& model)
      : model_(model), blocks_(answered(blocks, model)) {
    levels_ = levels_of(blocks_, model.shape);
    if (levels_.size() < 2) {
      throw std::invalid_argument("blocks: a slope needs at least two levels with trials");
    }
    double gap = kUnbounded;
    for (std::size_t i = 1; i < levels_.size(); ++i) {
      gap = std::min(gap, levels_[i] - levels_[i - 1]);
    }
    const double rise =
        standard_quantile(model.shape, kSteepest) - standard_quantile(model.shape, 1.0 - kSteepest);
    const double steepest = std::log(rise / gap);
    bounds_.low << (is_weibull(model.shape) ? std::numeric_limits<double>::min() : -kUnbounded),
        steepest - kSlopeRange, model.gamma.value_or(0.0), model.lambda.value_or(0.0);
    bounds_.high << kUnbounded, steepest, model.gamma.value_or(kGreatestGamma),
        model.lambda.value_or(model.greatest_lambda);
    free_ = {true, true, !model.gamma, !model.lambda};
    for (const PsychometricBlock& block : blocks_) {
      const auto n = static_cast<double>(block.trials);
      const auto k = static_cast<double>(block.hits);
      constant_ += log_choose(n, k);
    }
  }

  const Bounds& bounds() const noexcept { return bounds_; }
  const Free& free() const noexcept { return free_; }
  const std::vector<double>& levels() const noexcept { return levels_; }
  const std::vector<PsychometricBlock>& blocks() const noexcept { return blocks_; }
  const PsychometricModel& model() const noexcept { return model_; }

  PsychometricFunction function(const CurveParameters& at) const {
    return {.shape = model_.shape,
            .alpha = at(0),
            .beta = std::exp(at(1)),
            .gamma = at(2),
            .lambda = at(3)};
  }

  double value(const CurveParameters& at) const {
    const PsychometricFunction f = function(at);
    double sum = constant_;
    for (const PsychometricBlock& block : blocks_) {
      const Standard s = standard_at(model_.shape, argument(f, block.x));
      sum += log_probability(block, f, s);
    }
    return sum;
  }

  CurveLikelihood likelihood(const CurveParameters& at) const {
    const PsychometricFunction f = function(at);
    CurveLikelihood answer{.value = constant_};
    for (const PsychometricBlock& block : blocks_) {
      const double t = argument(f, block.x);
      const Standard s = standard_at(model_.shape, t);
      answer.value += log_probability(block, f, s);
      add_derivatives(block, f, std::isfinite(t) ? t : 0.0, s, answer);
    }
    return answer;
  }

 private:
  // A count of 0 has no term: 0·ln 0 would make the whole sum undefined.
  static double log_probability(const PsychometricBlock& block, const PsychometricFunction& f,
                                const Standard& s) {
    const double reach = 1.0 - f.gamma - f.lambda;
    double sum = 0.0;
    if (block.hits > 0) {
      sum += static_cast<double>(block.hits) *
             std::log(std::max(f.gamma + reach * s.F, kLeastProbability));
    }
    if (block.hits < block.trials) {
      sum += static_cast<double>(block.trials - block.hits) *
             std::log(std::max(f.lambda + reach * s.Q, kLeastProbability));
    }
    return sum;
  }

  void add_derivatives(const PsychometricBlock& block, const PsychometricFunction& f, double t,
                       const Standard& s, CurveLikelihood& answer) const {
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
    if (block.hits > 0) {
      add(static_cast<double>(block.hits), f.gamma + reach * s.F, 1.0);
    }
    if (block.hits < block.trials) {
      add(static_cast<double>(block.trials - block.hits), f.lambda + reach * s.Q, -1.0);
    }
  }

  PsychometricModel model_{};
  std::vector<PsychometricBlock> blocks_{};
  std::vector<double> levels_{};
  Bounds bounds_{};
  Free free_{};
  double constant_ = 0.0;
};

std::vector<Eigen::Index> places_of(const Free& free) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i]) {
      places.push_back(static_cast<Eigen::Index>(i));
    }
  }
  return places;
}

struct CurveMaximum {
  CurveParameters at = CurveParameters::Zero();
  double value = -kUnbounded;
};

// Newton's method within the bounds over the parameters in `free`. A parameter that the gradient
// presses against its bound stands still; where the surface is not concave the step is damped.
CurveMaximum newton(const Problem& problem, CurveParameters at, const Free& free) {
  const Bounds& bounds = problem.bounds();
  at = at.cwiseMax(bounds.low).cwiseMin(bounds.high);
  CurveLikelihood here = problem.likelihood(at);
  constexpr int kMostSteps = 200;
  for (int iteration = 0; iteration < kMostSteps; ++iteration) {
    std::vector<Eigen::Index> places;
    for (const Eigen::Index i : places_of(free)) {
      const bool is_pressed = (at(i) <= bounds.low(i) && here.gradient(i) < 0.0) ||
                              (at(i) >= bounds.high(i) && here.gradient(i) > 0.0);
      if (!is_pressed) {
        places.push_back(i);
      }
    }
    if (places.empty()) {
      break;
    }
    // In units of the curvatures, so that damping weighs all parameters alike.
    Eigen::MatrixXd information = -here.hessian(places, places);
    Eigen::VectorXd scale = information.diagonal().cwiseAbs().cwiseMax(1e-12).cwiseSqrt();
    information.array().colwise() /= scale.array();
    information.array().rowwise() /= scale.transpose().array();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(information);
    constexpr double kFlat = 1e-9;
    const Eigen::VectorXd curvatures = solver.eigenvalues().cwiseAbs().cwiseMax(kFlat);
    const Eigen::VectorXd gradient = here.gradient(places);
    const Eigen::VectorXd along = solver.eigenvectors().transpose() * gradient.cwiseQuotient(scale);
    const Eigen::VectorXd step =
        (solver.eigenvectors() * along.cwiseQuotient(curvatures)).cwiseQuotient(scale);
    bool moved = false;
    double travelled = 0.0;
    for (double length = 1.0; length > 1e-12; length *= 0.5) {
      CurveParameters next = at;
      for (std::size_t i = 0; i < places.size(); ++i) {
        next(places[i]) += length * step(static_cast<Eigen::Index>(i));
      }
      next = next.cwiseMax(bounds.low).cwiseMin(bounds.high);
      const CurveLikelihood there = problem.likelihood(next);
      if (std::isfinite(there.value) && there.value >= here.value - 1e-14 * std::abs(here.value)) {
        travelled = ((next - at).array() / (1.0 + at.array().abs())).abs().maxCoeff();
        moved = there.value > here.value || travelled > 0.0;
        at = next;
        here = there;
        break;
      }
    }
    if (!moved || travelled < 1e-14) {
      break;
    }
  }
  return {.at = at, .value = here.value};
}

struct Search {
  const Problem& problem;
  std::vector<Eigen::Index> places{};
  CurveParameters at = CurveParameters::Zero();
};

// BOBYQA needs no derivatives and keeps to the bounds. It is scaled to the range of the levels.
CurveMaximum bobyqa(const Problem& problem, const CurveParameters& start) {
  Search search{.problem = problem, .places = places_of(problem.free()), .at = start};
  const Bounds& bounds = problem.bounds();
  std::vector<double> point;
  std::vector<double> low;
  std::vector<double> high;
  std::vector<double> step;
  const double range = is_weibull(problem.model().shape)
                           ? start(0)
                           : problem.levels().back() - problem.levels().front();
  for (const Eigen::Index i : search.places) {
    low.push_back(bounds.low(i));
    high.push_back(bounds.high(i));
    const double inside = std::min(bounds.high(i), std::max(bounds.low(i), start(i)));
    point.push_back(inside);
    step.push_back(i == 0 ? 0.05 * range : (i == 1 ? 0.2 : 0.2 * (high.back() - low.back())));
  }
  nlopt::opt optimizer(nlopt::LN_BOBYQA, static_cast<unsigned>(point.size()));
  optimizer.set_lower_bounds(low);
  optimizer.set_upper_bounds(high);
  optimizer.set_initial_step(step);
  optimizer.set_max_objective(
      [](const std::vector<double>& x, std::vector<double>&, void* data) {
        auto& s = *static_cast<Search*>(data);
        CurveParameters at = s.at;
        for (std::size_t i = 0; i < x.size(); ++i) {
          at(s.places[i]) = x[i];
        }
        return s.problem.value(at);
      },
      &search);
  optimizer.set_xtol_rel(1e-6);
  optimizer.set_ftol_abs(1e-9);
  optimizer.set_maxeval(500);
  double value = -kUnbounded;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::roundoff_limited&) {
    // What it reached is the start of Newton's steps.
  }
  CurveParameters at = start;
  for (std::size_t i = 0; i < point.size(); ++i) {
    at(search.places[i]) = point[i];
  }
  return {.at = at, .value = problem.value(at)};
}

// Distinct good starts: the likelihood of a guessing observer has several maxima.
std::vector<CurveParameters> starts(const Problem& problem) {
  constexpr int kPositions = 41;
  constexpr std::size_t kMost = 6;
  const Bounds& bounds = problem.bounds();
  const double first = problem.levels().front();
  const double range = problem.levels().back() - first;
  const PsychometricModel& model = problem.model();
  const std::vector<double> gammas =
      model.gamma ? std::vector<double>{*model.gamma} : std::vector<double>{0.01, 0.1, 0.3};
  const std::vector<double> lambdas =
      model.lambda ? std::vector<double>{*model.lambda}
                   : std::vector<double>{0.05 * model.greatest_lambda, 0.6 * model.greatest_lambda};
  struct Start {
    CurveParameters at = CurveParameters::Zero();
    double place = 0.0;  // of α among the levels
    double value = 0.0;
  };
  std::vector<Start> all;
  for (int i = 0; i < kPositions; ++i) {
    const double place = first + range * i / (kPositions - 1);
    const double alpha = is_weibull(model.shape) ? std::exp(place) : place;
    for (const double less : {0.0, 0.15, 0.4, 0.7, 1.0, 1.4, 1.8, 2.2, 2.6, 3.0, 3.5, 4.0, 5.0}) {
      for (const double gamma : gammas) {
        for (const double lambda : lambdas) {
          const CurveParameters at(alpha, bounds.high(1) - less, gamma, lambda);
          all.push_back({.at = at, .place = place, .value = problem.value(at)});
        }
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Start& a, const Start& b) { return a.value > b.value; });
  std::vector<Start> kept;
  for (const Start& start : all) {
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Start& other) {
      return std::abs(start.place - other.place) > 3.0 * range / kPositions ||
             std::abs(start.at(1) - other.at(1)) > 0.8;
    });
    if (is_new) {
      kept.push_back(start);
    }
    if (kept.size() == kMost) {
      break;
    }
  }
  std::vector<CurveParameters> points;
  for (const Start& start : kept) {
    points.push_back(start.at);
  }
  return points;
}

struct AtBound {
  bool beta = false;
  bool gamma = false;
  bool lambda = false;

  int count() const { return int{beta} + int{gamma} + int{lambda}; }
};

struct Solution {
  CurveMaximum maximum{};
  AtBound at_bound{};
  Free free{};
};

Solution solve(const Problem& problem) {
  CurveMaximum best;
  for (const CurveParameters& start : starts(problem)) {
    const CurveMaximum found = newton(problem, bobyqa(problem, start).at, problem.free());
    if (found.value > best.value) {
      best = found;
    }
  }
  // A bound is taken where it is as likely: on it, no standard error would mean anything.
  const Bounds& bounds = problem.bounds();
  constexpr double kNear = 1e-4;
  constexpr double kAsLikely = 1e-9;
  const bool near_beta = bounds.high(1) - best.at(1) < kNear;
  const bool near_gamma = problem.free()[2] && best.at(2) < kNear;
  const bool near_lambda =
      problem.free()[3] && (best.at(3) < kNear || bounds.high(3) - best.at(3) < kNear);
  Solution answer{.maximum = best, .free = problem.free()};
  for (const bool beta : {false, true}) {
    for (const bool gamma : {false, true}) {
      for (const bool lambda : {false, true}) {
        const AtBound bound{.beta = beta, .gamma = gamma, .lambda = lambda};
        if ((beta && !near_beta) || (gamma && !near_gamma) || (lambda && !near_lambda) ||
            bound.count() <= answer.at_bound.count()) {
          continue;
        }
        CurveParameters start = best.at;
        Free free = problem.free();
        if (beta) {
          start(1) = bounds.high(1);
          free[1] = false;
        }
        if (gamma) {
          start(2) = 0.0;
          free[2] = false;
        }
        if (lambda) {
          start(3) = start(3) < 0.5 * bounds.high(3) ? 0.0 : bounds.high(3);
          free[3] = false;
        }
        const CurveMaximum found = newton(problem, start, free);
        if (found.value >= best.value - kAsLikely) {
          answer = {.maximum = found, .at_bound = bound, .free = free};
        }
      }
    }
  }
  return answer;
}

double saturated_log_likelihood(const std::vector<PsychometricBlock>& blocks) {
  double sum = 0.0;
  for (const PsychometricBlock& block : blocks) {
    const auto n = static_cast<double>(block.trials);
    const auto k = static_cast<double>(block.hits);
    sum += log_choose(n, k);
    sum += k > 0.0 ? k * std::log(k / n) : 0.0;
    sum += k < n ? (n - k) * std::log((n - k) / n) : 0.0;
  }
  return sum;
}

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
  const double dt_dF = 1.0 / standard_at(f.shape, t).d1;
  // x = α + t/β, or α·e^{t/β}
  const double x = f.inverse(performance);
  const double dx_dt = (is_weibull(f.shape) ? x : 1.0) / f.beta;
  CurveParameters gradient;
  gradient << (is_weibull(f.shape) ? x / f.alpha : 1.0), -dx_dt * t,
      dx_dt * dt_dF * (F - 1.0) / reach, dx_dt * dt_dF * F / reach;
  return gradient;
}

std::optional<PsychometricFit::Precision> precision_of(const Problem& problem,
                                                       const Solution& solution,
                                                       const PsychometricQuestion& question) {
  const std::vector<Eigen::Index> places = places_of(solution.free);
  const Eigen::MatrixXd information =
      -problem.likelihood(solution.maximum.at).hessian(places, places);
  const Eigen::LLT<Eigen::MatrixXd> factored(information);
  if (factored.info() != Eigen::Success) {
    return std::nullopt;
  }
  const auto size = static_cast<Eigen::Index>(places.size());
  const Eigen::MatrixXd covariance = factored.solve(Eigen::MatrixXd::Identity(size, size));
  const PsychometricFunction f = problem.function(solution.maximum.at);
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

// Where the profile of α has fallen by half the quantile of χ², on one side.
std::optional<double> profile_end(const Problem& problem, const Solution& solution,
                                  double signed_error, double fall) {
  Free others = problem.free();
  others[0] = false;
  const double alpha = solution.maximum.at(0);
  const auto missing = [&](double at) {
    if (is_weibull(problem.model().shape) && !(at > 0.0)) {
      return kUnbounded;
    }
    CurveParameters start = solution.maximum.at;
    start(0) = at;
    return solution.maximum.value - newton(problem, start, others).value - fall;
  };
  constexpr double kFurthest = 12.0;
  for (double errors = 1.0; errors < kFurthest; errors += 0.5) {
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

double PsychometricFunction::value(double x) const {
  return gamma + (1.0 - gamma - lambda) * standard_at(shape, argument(*this, x)).F;
}

double PsychometricFunction::slope(double x) const {
  const double dt_dx = is_weibull(shape) ? beta / x : beta;
  return (1.0 - gamma - lambda) * standard_at(shape, argument(*this, x)).d1 * dt_dx;
}

double PsychometricFunction::inverse(double performance) const {
  const double t = standard_quantile(shape, (performance - gamma) / (1.0 - gamma - lambda));
  return is_weibull(shape) ? alpha * std::exp(t / beta) : alpha + t / beta;
}

PsychometricJudgement judge(std::span<const PsychometricBlock> all,
                            const PsychometricModel& model) {
  const std::vector<PsychometricBlock> blocks = answered(all, model);
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
  if (levels_of(blocks, model.shape).size() < 2) {
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

PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model) {
  const Problem problem(blocks, model);
  const Solution solution = solve(problem);
  return {.function = problem.function(solution.maximum.at),
          .log_likelihood = solution.maximum.value,
          .beta_at_bound = solution.at_bound.beta};
}

PsychometricFit fit_psychometric(std::span<const PsychometricBlock> blocks,
                                 const PsychometricQuestion& question) {
  if (judge(blocks, question.model).status != PsychometricStatus::ok) {
    throw std::invalid_argument("blocks: these data have no likeliest function; ask judge first");
  }
  const double z = normal_limit(question.confidence);  // refuses improbable confidence
  const Problem problem(blocks, question.model);
  const Solution solution = solve(problem);
  PsychometricFit fit;
  fit.function = problem.function(solution.maximum.at);
  fit.log_likelihood = solution.maximum.value;
  fit.beta_at_bound = solution.at_bound.beta;
  fit.gamma_at_bound = solution.at_bound.gamma;
  fit.lambda_at_bound = solution.at_bound.lambda;
  const auto parameters = static_cast<double>(places_of(solution.free).size());
  fit.deviance = 2.0 * (saturated_log_likelihood(problem.blocks()) - fit.log_likelihood);
  fit.deviance_df = static_cast<double>(problem.blocks().size()) - parameters;
  fit.pearson = pearson(problem.blocks(), fit.function);
  fit.deviance_p = upper_tail(ChiSquaredStatistic{.value = fit.deviance, .df = fit.deviance_df});
  fit.threshold = fit.function.inverse(question.performance);
  if (fit.beta_at_bound) {
    return fit;
  }
  fit.precision = precision_of(problem, solution, question);
  if (fit.precision) {
    const double fall = 0.5 * z * z;
    fit.profile_low = profile_end(problem, solution, -fit.precision->alpha_se, fall);
    fit.profile_high = profile_end(problem, solution, fit.precision->alpha_se, fall);
  }
  return fit;
}

ThresholdBootstrap bootstrap_threshold(std::span<const PsychometricBlock> blocks,
                                       std::span<const std::vector<std::uint64_t>> resamples,
                                       const PsychometricQuestion& question) {
  ThresholdBootstrap answer;
  std::vector<double> found;
  for (const std::vector<std::uint64_t>& hits : resamples) {
    if (hits.size() != blocks.size()) {
      throw std::invalid_argument("resamples: a row has " + std::to_string(hits.size()) +
                                  " counts for " + std::to_string(blocks.size()) + " blocks");
    }
    std::vector<PsychometricBlock> resampled(blocks.begin(), blocks.end());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      resampled[i].hits = hits[i];
    }
    answer.thresholds.emplace_back();
    if (judge(resampled, question.model).status != PsychometricStatus::ok) {
      continue;
    }
    const PsychometricMaximum maximum = maximise_psychometric(resampled, question.model);
    answer.slopes_at_bound += maximum.beta_at_bound ? 1 : 0;
    const double threshold = maximum.function.inverse(question.performance);
    if (std::isfinite(threshold)) {
      answer.thresholds.back() = threshold;
      found.push_back(threshold);
    }
  }
  answer.valid = found.size();
  if (found.size() >= 2) {
    answer.standard_error = summary_of(found)->sd;
  }
  if (!found.empty()) {
    std::sort(found.begin(), found.end());
    const double outside = 0.5 * (1.0 - question.confidence);
    answer.percentile = {.low = quantile(found, outside), .high = quantile(found, 1.0 - outside)};
  }
  return answer;
}

}  // namespace asperity
