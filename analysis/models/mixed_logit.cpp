// The likelihood by the trapezoidal rule, with exact derivatives.

#include "analysis/models/mixed_logit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Cholesky>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kNoSpread = 1e-3;        // σ below it is 0
constexpr double kLogOfNoSpread = -40.0;  // ln σ of no spread at all
constexpr double kNotFlat = 1e-8;         // less is rounding

double logistic(double x) {
  return x >= 0.0 ? 1.0 / (1.0 + std::exp(-x)) : std::exp(x) / (1.0 + std::exp(x));
}

// ln(1 + eˣ)
double soft_plus(double x) {
  return x > 0.0 ? x + std::log1p(std::exp(-x)) : std::log1p(std::exp(x));
}

struct Groups {
  HitCount first{};
  HitCount second{};
};

Groups groups_of(std::span<const GroupedHits> participants) {
  Groups groups;
  for (const GroupedHits& one : participants) {
    static_cast<void>(proportion(one.count));  // refuses impossible counts
    HitCount& group = one.second_group ? groups.second : groups.first;
    group.hits += one.count.hits;
    group.trials += one.count.trials;
  }
  if (groups.first.trials == 0 || groups.second.trials == 0) {
    throw std::invalid_argument("participants: a group is empty; a comparison needs two groups");
  }
  return groups;
}

// β₀, β₁, ln σ.
using Parameters = Eigen::Vector3d;

struct Likelihood {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

struct Person {
  double hits = 0.0;
  double trials = 0.0;
  double level = 0.0;
  double sigma = 1.0;

  double log_density(double u) const {
    const double eta = level + sigma * u;
    return hits * eta - trials * soft_plus(eta) - 0.5 * u * u;
  }
};

// Of ln f = k·η − n·ln(1 + e^η) − u²/2 with η = level + σ·u.
double mode_of(const Person& person) {
  double u = 0.0;
  for (int step = 0; step < 100; ++step) {
    const double p = logistic(person.level + person.sigma * u);
    const double slope = person.sigma * (person.hits - person.trials * p) - u;
    const double curvature = person.sigma * person.sigma * person.trials * p * (1.0 - p) + 1.0;
    double move = slope / curvature;
    // Concave, but far away Newton's step can overshoot.
    while (person.log_density(u + move) < person.log_density(u) && std::abs(move) > 1e-12) {
      move *= 0.5;
    }
    u += move;
    if (std::abs(move) < 1e-13) {
      break;
    }
  }
  return u;
}

// The distance of the nodes of the trapezoidal rule. For an integrand f that is analytic where
// |Im u| < d its error is about e^{−2πd/h}·∫|f(x ± id)|dx. f has poles at Im(σu) = ±π. At
// Im(σu) = θ its first factor is at most cos(θ/2)^{−n} times as large as on the real axis: near the
// poles for few trials n, and at θ = O(1/√n) for many, h leaves an error near 10⁻¹³, whatever σ.
double step_of(const Person& person) {
  return std::min({0.4, 0.3 / person.sigma, 1.2 / (person.sigma * std::sqrt(person.trials))});
}

// One participant's integral and its derivatives: ∇ ln∫f = E[s], ∇² ln∫f = E[h] + E[ss'] − E[s]E[s]'
// with s and h the derivatives of ln f.
Likelihood likelihood_of_person(const Person& person, double second_group) {
  constexpr double kNegligible = -40.0;  // of a term's logarithm below the largest
  const double middle = mode_of(person);
  const double largest = person.log_density(middle);
  const double step = step_of(person);
  double sum = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const auto add = [&](double u) {  // whether the term counts
    const double log_weight = person.log_density(u) - largest;
    if (log_weight < kNegligible) return false;
    const double weight = std::exp(log_weight);
    const double p = logistic(person.level + person.sigma * u);
    const double residual = person.hits - person.trials * p;
    const Eigen::Vector3d direction(1.0, second_group, person.sigma * u);  // dη
    const Eigen::Vector3d score = residual * direction;
    Eigen::Matrix3d h = -person.trials * p * (1.0 - p) * direction * direction.transpose();
    h(2, 2) += residual * person.sigma * u;  // d²η/d(ln σ)²
    sum += weight;
    mean += weight * score;
    second += weight * (h + score * score.transpose());
    return true;
  };
  // ln f is concave: beyond the first negligible term all are.
  for (int i = 0; add(middle + i * step); ++i) {
  }
  for (int i = 1; add(middle - i * step); ++i) {
  }
  mean /= sum;
  second /= sum;
  return {.value = largest + std::log(sum * step) - 0.5 * std::log(2.0 * std::numbers::pi) +
                   log_choose(person.trials, person.hits),
          .gradient = mean,
          .hessian = second - mean * mean.transpose()};
}

Likelihood likelihood_of(std::span<const GroupedHits> participants, const Parameters& at) {
  Likelihood answer;
  for (const GroupedHits& one : participants) {
    const double group = one.second_group ? 1.0 : 0.0;
    const Likelihood own = likelihood_of_person({.hits = static_cast<double>(one.count.hits),
                                                 .trials = static_cast<double>(one.count.trials),
                                                 .level = at(0) + at(1) * group,
                                                 .sigma = std::exp(at(2))},
                                                group);
    answer.value += own.value;
    answer.gradient += own.gradient;
    answer.hessian += own.hessian;
  }
  return answer;
}

struct Maximum {
  Parameters at = Parameters::Zero();
  Likelihood likelihood{};
};

// Newton over the parameters named free, damped where the surface is not concave.
Maximum maximise(std::span<const GroupedHits> participants, const Parameters& start,
                 const std::vector<int>& free) {
  Maximum best{.at = start, .likelihood = likelihood_of(participants, start)};
  const auto size = static_cast<Eigen::Index>(free.size());
  constexpr int kMostSteps = 200;
  for (int iteration = 0; iteration < kMostSteps; ++iteration) {
    Eigen::VectorXd gradient(size);
    Eigen::MatrixXd information(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      gradient(i) = best.likelihood.gradient(free[static_cast<std::size_t>(i)]);
      for (Eigen::Index j = 0; j < size; ++j) {
        information(i, j) = -best.likelihood.hessian(free[static_cast<std::size_t>(i)],
                                                     free[static_cast<std::size_t>(j)]);
      }
    }
    const double least = eigen_axes(information).values(0);
    constexpr double kFlat = 1e-6;
    if (least < kFlat) {
      information.diagonal().array() += kFlat - least + 1e-3 * std::abs(least);
    }
    const Eigen::VectorXd step = SymmetricFactors(information).solved(gradient);
    double length = 1.0;
    bool moved = false;
    constexpr double kLongest = 2.0;  // on the logit scale a step beyond it says nothing
    length = std::min(length, kLongest / std::max(kLongest, step.cwiseAbs().maxCoeff()));
    for (; length > 1e-10; length *= 0.5) {
      Parameters next = best.at;
      for (Eigen::Index i = 0; i < size; ++i) {
        next(free[static_cast<std::size_t>(i)]) += length * step(i);
      }
      Likelihood there = likelihood_of(participants, next);
      if (std::isfinite(there.value) &&
          there.value >= best.likelihood.value - 1e-13 * std::abs(best.likelihood.value)) {
        best = {.at = next, .likelihood = there};
        moved = true;
        break;
      }
    }
    if (!moved || length * step.cwiseAbs().maxCoeff() < 1e-12 || best.at(2) < std::log(1e-6)) {
      break;
    }
  }
  return best;
}

// The likelihood may have two maxima in σ, one of them at 0.
Maximum best_of_starts(std::span<const GroupedHits> participants, const LogitCoefficients& level,
                       const std::vector<int>& free) {
  Maximum best;
  best.likelihood.value = -std::numeric_limits<double>::infinity();
  for (const double sigma : {0.2, 0.7, 2.0}) {
    const Maximum found =
        maximise(participants, {level.intercept, level.second_group, std::log(sigma)}, free);
    if (found.likelihood.value > best.likelihood.value) {
      best = found;
    }
  }
  return best;
}

}  // namespace

std::optional<FixedLogit> fixed_logit(std::span<const GroupedHits> participants) {
  const Groups groups = groups_of(participants);
  const auto is_mixed = [](const HitCount& c) { return c.hits > 0 && c.hits < c.trials; };
  if (!is_mixed(groups.first) || !is_mixed(groups.second)) {
    return std::nullopt;
  }
  // Two groups and two coefficients: the shares are fitted exactly.
  const double p1 = proportion(groups.first);
  const double p2 = proportion(groups.second);
  const double w1 = static_cast<double>(groups.first.trials) * p1 * (1.0 - p1);
  const double w2 = static_cast<double>(groups.second.trials) * p2 * (1.0 - p2);
  FixedLogit fit;
  fit.beta.intercept = std::log(p1 / (1.0 - p1));
  fit.beta.second_group = std::log(p2 / (1.0 - p2)) - fit.beta.intercept;
  fit.standard_error = {.intercept = std::sqrt(1.0 / w1),
                        .second_group = std::sqrt(1.0 / w1 + 1.0 / w2)};
  double squares_1 = 0.0;
  double squares_2 = 0.0;
  std::size_t in_second = 0;
  for (const GroupedHits& one : participants) {
    const double p = one.second_group ? p2 : p1;
    const double residual =
        static_cast<double>(one.count.hits) - static_cast<double>(one.count.trials) * p;
    (one.second_group ? squares_2 : squares_1) += residual * residual;
    in_second += one.second_group ? 1 : 0;
  }
  if (in_second == 1) {
    squares_2 = std::numeric_limits<double>::quiet_NaN();
  }
  if (participants.size() - in_second == 1) {
    squares_1 = std::numeric_limits<double>::quiet_NaN();
  }
  fit.cluster_standard_error = {
      .intercept = std::sqrt(squares_1) / w1,
      .second_group = std::sqrt(squares_1 / (w1 * w1) + squares_2 / (w2 * w2))};
  return fit;
}

std::variant<MixedLogit, NoMixedLogit> mixed_logit(std::span<const GroupedHits> participants) {
  const std::optional<FixedLogit> fixed = fixed_logit(participants);
  if (!fixed) {
    return NoMixedLogit::separated;
  }
  const auto some = [&](const auto& holds) {
    return std::any_of(participants.begin(), participants.end(),
                       [&holds](const GroupedHits& one) { return holds(one.count); });
  };
  if (!some([](const HitCount& c) { return c.trials > 1; })) {
    return NoMixedLogit::flat;
  }
  if (!some([](const HitCount& c) { return c.hits > 0 && c.hits < c.trials; })) {
    return NoMixedLogit::unbounded_spread;
  }
  const Maximum full = best_of_starts(participants, fixed->beta, {0, 1, 2});
  const Likelihood without_spread = likelihood_of(
      participants, {fixed->beta.intercept, fixed->beta.second_group, kLogOfNoSpread});
  if (full.at(2) < std::log(kNoSpread) || full.likelihood.value < without_spread.value + kNotFlat) {
    return NoMixedLogit::no_spread;
  }
  const Eigen::LLT<Eigen::Matrix3d> information(-full.likelihood.hessian);
  if (information.info() != Eigen::Success) {
    return NoMixedLogit::flat;
  }
  const Eigen::Matrix3d covariance = information.solve(Eigen::Matrix3d::Identity());
  MixedLogit fit;
  fit.beta = {.intercept = full.at(0), .second_group = full.at(1)};
  fit.sigma = std::exp(full.at(2));
  fit.log_likelihood = full.likelihood.value;
  fit.standard_error = {.intercept = std::sqrt(covariance(0, 0)),
                        .second_group = std::sqrt(covariance(1, 1))};
  const Maximum alike = best_of_starts(
      participants, {.intercept = fit.beta.intercept + 0.5 * fit.beta.second_group}, {0, 2});
  fit.likelihood_ratio = 2.0 * (full.likelihood.value - alike.likelihood.value);
  fit.p = upper_tail(ChiSquaredStatistic{.value = fit.likelihood_ratio, .df = 1.0});
  return fit;
}

}  // namespace asperity
