// Adaptive Gauss–Hermite quadrature with exact derivatives.

#include "analysis/mixed_logit.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include "analysis/tail_probabilities.h"

namespace asperity {
namespace {

constexpr int kNodes = 61;
constexpr double kNoSpread = 1e-3;  // σ below it is 0
constexpr double kLogOfNoSpread = -40.0;  // ln σ of no spread at all
// One trial each says nothing of a spread: the likelihood is flat but for rounding.
constexpr double kNotFlat = 1e-8;

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
    throw std::invalid_argument("participants: a group is empty; a comparison needs two");
  }
  return groups;
}

// Nodes x and weights w·e^{x²} of Gauss–Hermite quadrature: the eigenvalues of the recurrence's
// matrix; the weight is √π times the square of the first component of the eigenvector, which at the
// outer nodes is too small to be exact, so it comes from the orthonormal functions instead:
// w·e^{x²} = 1/Σψ_k(x)², ψ_k the normalised Hermite functions.
struct Hermite {
  Eigen::ArrayXd nodes{};
  Eigen::ArrayXd log_weights{};  // of w·e^{x²}
};

Hermite hermite() {
  Eigen::VectorXd off_diagonal(kNodes - 1);
  for (int k = 1; k < kNodes; ++k) {
    off_diagonal(k - 1) = std::sqrt(0.5 * k);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(kNodes), off_diagonal,
                                Eigen::EigenvaluesOnly);
  Hermite rule{.nodes = solver.eigenvalues().array(), .log_weights = Eigen::ArrayXd(kNodes)};
  for (int i = 0; i < kNodes; ++i) {
    const double x = rule.nodes(i);
    double before = 0.0;
    double now = std::exp(-0.5 * x * x) / std::sqrt(std::sqrt(std::numbers::pi));
    double sum = now * now;
    for (int k = 1; k < kNodes; ++k) {
      const double next = std::sqrt(2.0 / k) * x * now - std::sqrt((k - 1.0) / k) * before;
      before = now;
      now = next;
      sum += now * now;
    }
    rule.log_weights(i) = -std::log(sum);
  }
  return rule;
}

// β₀, β₁, ln σ.
using Parameters = Eigen::Vector3d;

struct Likelihood {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

// The mode of k·η − n·ln(1 + e^η) − u²/2 with η = level + σ·u, and its curvature.
struct Mode {
  double u = 0.0;
  double scale = 1.0;
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

Mode mode_of(const Person& person) {
  double u = 0.0;
  double curvature = 1.0;
  for (int step = 0; step < 100; ++step) {
    const double p = logistic(person.level + person.sigma * u);
    const double slope = person.sigma * (person.hits - person.trials * p) - u;
    curvature = person.sigma * person.sigma * person.trials * p * (1.0 - p) + 1.0;
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
  return {.u = u, .scale = 1.0 / std::sqrt(curvature)};
}

Likelihood likelihood_of(std::span<const GroupedHits> participants, const Parameters& at,
                         const Hermite& rule) {
  Likelihood answer;
  const double sigma = std::exp(at(2));
  for (const GroupedHits& one : participants) {
    const double group = one.second_group ? 1.0 : 0.0;
    const Person person{.hits = static_cast<double>(one.count.hits),
                        .trials = static_cast<double>(one.count.trials),
                        .level = at(0) + at(1) * group,
                        .sigma = sigma};
    const Mode mode = mode_of(person);
    Eigen::ArrayXd u = mode.u + std::numbers::sqrt2 * mode.scale * rule.nodes;
    Eigen::ArrayXd terms(kNodes);
    for (int i = 0; i < kNodes; ++i) {
      terms(i) = person.log_density(u(i)) + rule.log_weights(i);
    }
    const double greatest = terms.maxCoeff();
    const Eigen::ArrayXd weights = (terms - greatest).exp();
    const double sum = weights.sum();
    answer.value +=
        greatest + std::log(sum) + std::log(std::numbers::sqrt2 * mode.scale) -
        0.5 * std::log(2.0 * std::numbers::pi) +
        log_choose(static_cast<double>(one.count.trials), static_cast<double>(one.count.hits));
    // ∇ ln∫f = E[s], ∇² ln∫f = E[h] + E[ss'] − E[s]E[s]', s and h the derivatives of ln f.
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (int i = 0; i < kNodes; ++i) {
      const double p = logistic(person.level + sigma * u(i));
      const double residual = person.hits - person.trials * p;
      const Eigen::Vector3d direction(1.0, group, sigma * u(i));  // dη
      const Eigen::Vector3d score = residual * direction;
      Eigen::Matrix3d h = -person.trials * p * (1.0 - p) * direction * direction.transpose();
      h(2, 2) += residual * sigma * u(i);  // d²η/d(ln σ)²
      mean += weights(i) / sum * score;
      second += weights(i) / sum * (h + score * score.transpose());
    }
    answer.gradient += mean;
    answer.hessian += second - mean * mean.transpose();
  }
  return answer;
}

struct Maximum {
  Parameters at = Parameters::Zero();
  Likelihood likelihood{};
};

// Newton over the parameters named free, damped where the surface is not concave.
Maximum maximise(std::span<const GroupedHits> participants, const Parameters& start,
                 const std::vector<int>& free, const Hermite& rule) {
  Maximum best{.at = start, .likelihood = likelihood_of(participants, start, rule)};
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
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(information);
    const double least = solver.eigenvalues()(0);
    constexpr double kFlat = 1e-6;
    if (least < kFlat) {
      information.diagonal().array() += kFlat - least + 1e-3 * std::abs(least);
    }
    const Eigen::VectorXd step = information.ldlt().solve(gradient);
    double length = 1.0;
    bool moved = false;
    constexpr double kLongest = 2.0;  // on the logit scale a step beyond it says nothing
    length = std::min(length, kLongest / std::max(kLongest, step.cwiseAbs().maxCoeff()));
    for (; length > 1e-10; length *= 0.5) {
      Parameters next = best.at;
      for (Eigen::Index i = 0; i < size; ++i) {
        next(free[static_cast<std::size_t>(i)]) += length * step(i);
      }
      Likelihood there = likelihood_of(participants, next, rule);
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
                       const std::vector<int>& free, const Hermite& rule) {
  Maximum best;
  best.likelihood.value = -std::numeric_limits<double>::infinity();
  for (const double sigma : {0.2, 0.7, 2.0}) {
    const Maximum found =
        maximise(participants, {level.intercept, level.second_group, std::log(sigma)}, free, rule);
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
  for (const GroupedHits& one : participants) {
    const double p = one.second_group ? p2 : p1;
    const double residual =
        static_cast<double>(one.count.hits) - static_cast<double>(one.count.trials) * p;
    (one.second_group ? squares_2 : squares_1) += residual * residual;
  }
  fit.cluster_standard_error = {
      .intercept = std::sqrt(squares_1) / w1,
      .second_group = std::sqrt(squares_1 / (w1 * w1) + squares_2 / (w2 * w2))};
  return fit;
}

std::optional<MixedLogit> mixed_logit(std::span<const GroupedHits> participants) {
  const std::optional<FixedLogit> fixed = fixed_logit(participants);
  if (!fixed) {
    return std::nullopt;
  }
  const Hermite rule = hermite();
  const Maximum full = best_of_starts(participants, fixed->beta, {0, 1, 2}, rule);
  const Likelihood without_spread = likelihood_of(
      participants, {fixed->beta.intercept, fixed->beta.second_group, kLogOfNoSpread}, rule);
  if (full.at(2) < std::log(kNoSpread) || full.likelihood.value < without_spread.value + kNotFlat) {
    return std::nullopt;
  }
  MixedLogit fit;
  fit.beta = {.intercept = full.at(0), .second_group = full.at(1)};
  fit.sigma = std::exp(full.at(2));
  fit.log_likelihood = full.likelihood.value;
  const Eigen::Matrix3d covariance = (-full.likelihood.hessian).inverse();
  fit.standard_error = {.intercept = std::sqrt(covariance(0, 0)),
                        .second_group = std::sqrt(covariance(1, 1))};
  const Maximum alike = best_of_starts(
      participants, {.intercept = fit.beta.intercept + 0.5 * fit.beta.second_group}, {0, 2}, rule);
  fit.likelihood_ratio = 2.0 * (full.likelihood.value - alike.likelihood.value);
  fit.p = upper_tail(ChiSquaredStatistic{.value = fit.likelihood_ratio, .df = 1.0});
  return fit;
}

}  // namespace asperity
