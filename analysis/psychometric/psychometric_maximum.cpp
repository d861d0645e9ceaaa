// BOBYQA from several starts, then Newton's method within the bounds; of equal maxima, one on a bound is preferred.

#include "analysis/psychometric/psychometric_maximum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlopt.hpp>

#include "analysis/numbers/dense.h"

namespace asperity {
namespace {

struct CurveSearch {
  const PsychometricLikelihood& data;
  std::vector<Eigen::Index> places{};
  CurveParameters at = CurveParameters::Zero();
};

// BOBYQA needs no derivatives and respects the bounds. Its first steps are scaled to the range of the levels.
CurveMaximum bobyqa(const PsychometricLikelihood& data, const CurveParameters& start) {
  CurveSearch search{.data = data, .places = places_of(data.free()), .at = start};
  const CurveBounds& bounds = data.bounds();
  std::vector<double> point;
  std::vector<double> low;
  std::vector<double> high;
  std::vector<double> step;
  const double range =
      is_weibull(data.model().shape) ? start(0) : data.levels().back() - data.levels().front();
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
      [](const std::vector<double>& x, std::vector<double>&, void* of) {
        auto& s = *static_cast<CurveSearch*>(of);
        CurveParameters at = s.at;
        for (std::size_t i = 0; i < x.size(); ++i) {
          at(s.places[i]) = x[i];
        }
        return s.data.value(at);
      },
      &search);
  optimizer.set_xtol_rel(1e-6);
  optimizer.set_ftol_abs(1e-9);
  optimizer.set_maxeval(500);
  double value = 0.0;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::roundoff_limited&) {
    // The point that it reached is good enough as the start of Newton's method.
  }
  CurveParameters at = start;
  for (std::size_t i = 0; i < point.size(); ++i) {
    at(search.places[i]) = point[i];
  }
  return {.at = at, .value = data.value(at)};
}

}  // namespace

CurveMaximum climb(const PsychometricLikelihood& data, CurveParameters at,
                   const FreeParameters& free) {
  const CurveBounds& bounds = data.bounds();
  at = at.cwiseMax(bounds.low).cwiseMin(bounds.high);
  CurveLikelihood here = data.likelihood(at);
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
    // Scaled by the curvatures, so that the smallest accepted one means the same for all parameters.
    Eigen::MatrixXd information = -here.hessian(places, places);
    Eigen::VectorXd scale = information.diagonal().cwiseAbs().cwiseMax(1e-12).cwiseSqrt();
    information.array().colwise() /= scale.array();
    information.array().rowwise() /= scale.transpose().array();
    const EigenAxes axes = eigen_axes(information);
    constexpr double kFlat = 1e-9;
    const Eigen::VectorXd curvatures = axes.values.cwiseAbs().cwiseMax(kFlat);
    const Eigen::VectorXd gradient = here.gradient(places);
    const Eigen::VectorXd along = axes.vectors.transpose() * gradient.cwiseQuotient(scale);
    const Eigen::VectorXd step =
        (axes.vectors * along.cwiseQuotient(curvatures)).cwiseQuotient(scale);
    bool moved = false;
    double travelled = 0.0;
    for (double length = 1.0; length > 1e-12; length *= 0.5) {
      CurveParameters next = at;
      for (std::size_t i = 0; i < places.size(); ++i) {
        next(places[i]) += length * step(static_cast<Eigen::Index>(i));
      }
      next = next.cwiseMax(bounds.low).cwiseMin(bounds.high);
      const CurveLikelihood there = data.likelihood(next);
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

CurveSolution greatest_likelihood(const PsychometricLikelihood& data, PsychometricStarts& starts) {
  CurveMaximum best;
  for (const CurveParameters& start : starts.best(data)) {
    const CurveMaximum found = climb(data, bobyqa(data, start).at, data.free());
    if (found.value > best.value) {
      best = found;
    }
  }
  // At a bound a standard error has no meaning, so that a maximum as good on the bound is preferred and the
  // parameter reported as not free.
  const CurveBounds& bounds = data.bounds();
  constexpr double kNear = 1e-4;
  constexpr double kAsLikely = 1e-9;
  const bool near_beta = bounds.high(1) - best.at(1) < kNear;
  const bool near_gamma = data.free()[2] && best.at(2) < kNear;
  const bool near_lambda =
      data.free()[3] && (best.at(3) < kNear || bounds.high(3) - best.at(3) < kNear);
  CurveSolution answer{.maximum = best, .free = data.free()};
  for (const bool beta : {false, true}) {
    for (const bool gamma : {false, true}) {
      for (const bool lambda : {false, true}) {
        const AtBound bound{.beta = beta, .gamma = gamma, .lambda = lambda};
        if ((beta && !near_beta) || (gamma && !near_gamma) || (lambda && !near_lambda) ||
            bound.count() <= answer.at_bound.count()) {
          continue;
        }
        CurveParameters start = best.at;
        FreeParameters free = data.free();
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
        const CurveMaximum found = climb(data, start, free);
        if (found.value >= best.value - kAsLikely) {
          answer = {.maximum = found, .at_bound = bound, .free = free};
        }
      }
    }
  }
  return answer;
}

bool is_increasing(const PsychometricLikelihood& data, const CurveMaximum& maximum) {
  constexpr double kNotGreater = 1e-6;  // a smaller gain cannot be distinguished from a slope of 0
  return maximum.value > data.constant() + kNotGreater;
}

PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model,
                                          PsychometricStarts& starts) {
  const PsychometricLikelihood data(blocks, model);
  const CurveSolution solution = greatest_likelihood(data, starts);
  const double log_likelihood = std::max(solution.maximum.value, data.constant());
  return {.function = data.function(solution.maximum.at),
          .log_likelihood = log_likelihood,
          .deviance = 2.0 * (data.saturated() - log_likelihood),
          .increases = is_increasing(data, solution.maximum),
          .beta_at_bound = solution.at_bound.beta};
}

PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model) {
  PsychometricStarts starts{};
  return maximise_psychometric(blocks, model, starts);
}

}  // namespace asperity
