// Newton within, BOBYQA and Newton outside.

#include "analysis/models/crossed_binomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <nlopt.hpp>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kNoVariance = 1e-3;    // σ below it is 0
constexpr double kMostVariance = 30.0;  // σ and |β| beyond it: the probabilities are 0 and 1

/// ln of the probability of a response with its first derivative and negative second one.
struct ResponseTerm {
  double value = 0.0;
  double slope = 0.0;
  double weight = 0.0;
};

// ln Φ(x), and φ(x)/Φ(x); far below 0 by the first terms of their series.
struct NormalLog {
  double value = 0.0;
  double ratio = 0.0;
};
NormalLog normal_log(double x) {
  if (x > -30.0) {
    const double below = normal_below(x);
    return {.value = std::log(below), .ratio = normal_density(x) / below};
  }
  const double square = 1.0 / (x * x);
  return {.value = -0.5 * x * x - std::log(-x) - 0.5 * std::log(2.0 * std::numbers::pi) - square,
          .ratio = -x / (1.0 - square + 3.0 * square * square)};
}

ResponseTerm response_term(const HitCount& count, double eta, BinomialLink link) {
  const auto hits = static_cast<double>(count.hits);
  const auto misses = static_cast<double>(count.trials - count.hits);
  if (link == BinomialLink::logit) {
    const double small = std::exp(-std::abs(eta));
    const double p = eta >= 0.0 ? 1.0 / (1.0 + small) : small / (1.0 + small);
    const double rest = std::log1p(small);
    return {.value = -hits * (std::max(0.0, -eta) + rest) - misses * (std::max(0.0, eta) + rest),
            .slope = hits - (hits + misses) * p,
            .weight = (hits + misses) * small / ((1.0 + small) * (1.0 + small))};
  }
  const NormalLog hit = normal_log(eta);
  const NormalLog miss = normal_log(-eta);
  return {
      .value = hits * hit.value + misses * miss.value,
      .slope = hits * hit.ratio - misses * miss.ratio,
      .weight = hits * hit.ratio * (hit.ratio + eta) + misses * miss.ratio * (miss.ratio - eta)};
}

class CrossedLikelihood final {
 public:
  CrossedLikelihood(std::span<const CrossedHits> responses, const CrossedModel& model)
      : responses_(responses), model_(model) {
    if (responses.empty() || model.design.rows() != static_cast<Eigen::Index>(responses.size()) ||
        model.design.cols() < 1) {
      throw std::invalid_argument(
          "design has the size " + std::to_string(model.design.rows()) + " × " +
          std::to_string(model.design.cols()) + " and the number of responses is " +
          std::to_string(responses.size()) +
          "; design must have one row per response and at least one column");
    }
    if (!model.participants_vary && !model.items_vary) {
      throw std::invalid_argument(
          "model: neither participants nor items have random intercepts; give at least one of them "
          "random intercepts");
    }
    if (integrates() && model.participants_vary && model.items_vary) {
      throw std::invalid_argument(
          "model: quadrature requires that either participants or items have random intercepts; "
          "take Laplace's approximation for both");
    }
    if (model.design.colPivHouseholderQr().rank() < model.design.cols()) {
      throw std::invalid_argument(
          "design: the columns are linearly dependent; omit those that follow from others");
    }
    for (const CrossedHits& one : responses) {
      static_cast<void>(proportion(one.count));  // refuses impossible counts
      participants_ = std::max(participants_, static_cast<Eigen::Index>(one.participant) + 1);
      items_ = std::max(items_, static_cast<Eigen::Index>(one.item) + 1);
      constant_ +=
          log_choose(static_cast<double>(one.count.trials), static_cast<double>(one.count.hits));
    }
  }

  /// The intercepts at the mode, with ln L.
  struct Mode {
    Eigen::VectorXd u{};
    Eigen::VectorXd v{};
    double log_likelihood = 0.0;
  };

  Mode mode(const Eigen::VectorXd& beta, double sigma_p, double sigma_i) const {
    const Eigen::VectorXd fixed = model_.design * beta;
    Mode at{.u = Eigen::VectorXd::Zero(participants_), .v = Eigen::VectorXd::Zero(items_)};
    double value = joint(fixed, sigma_p, sigma_i, at);
    constexpr int kMostSteps = 100;
    for (int step = 0; step < kMostSteps; ++step) {
      const NewtonStep newton = newton_step(fixed, sigma_p, sigma_i, at);
      double length = 1.0;
      Mode next = at;
      double there = value;
      for (; length > 1e-10; length *= 0.5) {  // concave, but a step can overshoot
        next.u = at.u + length * newton.u;
        next.v = at.v + length * newton.v;
        there = joint(fixed, sigma_p, sigma_i, next);
        if (there >= value - 1e-12 * std::abs(value)) break;
      }
      at.u = next.u;
      at.v = next.v;
      value = there;
      const double moved =
          length * std::max(newton.u.cwiseAbs().maxCoeff(), newton.v.cwiseAbs().maxCoeff());
      if (moved < 1e-11) break;
    }
    at.log_likelihood =
        constant_ + value - 0.5 * newton_step(fixed, sigma_p, sigma_i, at).log_determinant;
    if (integrates()) at.log_likelihood += beyond_laplace(fixed, sigma_p, sigma_i, at);
    return at;
  }

  /// Whether these intercepts and effects predict every response on its own side of one half.
  bool separates(const Eigen::VectorXd& beta, double sigma_p, double sigma_i) const {
    const Mode at = mode(beta, sigma_p, sigma_i);
    const Eigen::VectorXd fixed = model_.design * beta;
    for (std::size_t i = 0; i < responses_.size(); ++i) {
      const CrossedHits& one = responses_[i];
      const double eta = predictor(fixed, sigma_p, sigma_i, at, i);
      if (one.count.hits > 0 && eta <= 0.0) return false;
      if (one.count.hits < one.count.trials && eta >= 0.0) return false;
    }
    return true;
  }

 private:
  bool integrates() const { return model_.likelihood == MarginalLikelihood::quadrature; }

  /// What Laplace's approximation lacks: with h the logarithm of an intercept's integrand, û its mode and a = −h''(û), the sum
  /// over the intercepts of ln(√(a/2π)·∫exp(h(u) − h(û))du), by the trapezoidal rule from û.
  double beyond_laplace(const Eigen::VectorXd& fixed, double sigma_p, double sigma_i,
                        const Mode& at) const {
    const bool of_participants = model_.participants_vary;
    const double sigma = of_participants ? sigma_p : sigma_i;
    const Eigen::VectorXd& modes = of_participants ? at.u : at.v;
    std::vector<std::vector<std::size_t>> rows(static_cast<std::size_t>(modes.size()));
    for (std::size_t i = 0; i < responses_.size(); ++i) {
      rows[of_participants ? responses_[i].participant : responses_[i].item].push_back(i);
    }
    double sum = 0.0;
    for (std::size_t group = 0; group < rows.size(); ++group) {
      const double mode = modes(static_cast<Eigen::Index>(group));
      const auto log_integrand = [&](double u) {
        double value = -0.5 * u * u;
        for (const std::size_t row : rows[group]) {
          value += response_term(responses_[row].count,
                                 fixed(static_cast<Eigen::Index>(row)) + sigma * u, model_.link)
                       .value;
        }
        return value;
      };
      double curvature = 1.0;
      for (const std::size_t row : rows[group]) {
        curvature +=
            sigma * sigma *
            response_term(responses_[row].count,
                          fixed(static_cast<Eigen::Index>(row)) + sigma * mode, model_.link)
                .weight;
      }
      // A quarter of the standard deviation, and of the interval of u in which a probability passes from 0 to 1.
      const double step_length = 0.25 / std::max(std::sqrt(curvature), 1.0 + sigma);
      constexpr double kNegligible = -30.0;
      const double highest = log_integrand(mode);
      double ordinates = 1.0;
      for (const double side : {-1.0, 1.0}) {
        for (int step = 1;; ++step) {
          const double u = mode + side * step_length * step;
          const double fall = log_integrand(u) - highest;
          if (!(fall > kNegligible)) break;
          ordinates += std::exp(fall);
        }
      }
      sum += std::log(step_length * std::sqrt(curvature / (2.0 * std::numbers::pi)) * ordinates);
    }
    return sum;
  }

  struct NewtonStep {
    Eigen::VectorXd u{};
    Eigen::VectorXd v{};
    double log_determinant = 0.0;
  };

  double predictor(const Eigen::VectorXd& fixed, double sigma_p, double sigma_i, const Mode& at,
                   std::size_t row) const {
    const CrossedHits& one = responses_[row];
    return fixed(static_cast<Eigen::Index>(row)) +
           sigma_p * at.u(static_cast<Eigen::Index>(one.participant)) +
           sigma_i * at.v(static_cast<Eigen::Index>(one.item));
  }

  // ln f without its constants.
  double joint(const Eigen::VectorXd& fixed, double sigma_p, double sigma_i, const Mode& at) const {
    double sum = -0.5 * (at.u.squaredNorm() + at.v.squaredNorm());
    for (std::size_t i = 0; i < responses_.size(); ++i) {
      sum +=
          response_term(responses_[i].count, predictor(fixed, sigma_p, sigma_i, at, i), model_.link)
              .value;
    }
    return sum;
  }

  // With H = [A B; B' C], A diagonal: the participants are eliminated, S = C − B'A⁻¹B remains, and
  // |H| = |A|·|S|.
  NewtonStep newton_step(const Eigen::VectorXd& fixed, double sigma_p, double sigma_i,
                         const Mode& at) const {
    Eigen::VectorXd slope_u = -at.u;
    Eigen::VectorXd slope_v = -at.v;
    Eigen::VectorXd a = Eigen::VectorXd::Ones(participants_);
    Eigen::VectorXd c = Eigen::VectorXd::Ones(items_);
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(participants_, items_);
    for (std::size_t i = 0; i < responses_.size(); ++i) {
      const CrossedHits& one = responses_[i];
      const auto p = static_cast<Eigen::Index>(one.participant);
      const auto j = static_cast<Eigen::Index>(one.item);
      const ResponseTerm term =
          response_term(one.count, predictor(fixed, sigma_p, sigma_i, at, i), model_.link);
      slope_u(p) += sigma_p * term.slope;
      slope_v(j) += sigma_i * term.slope;
      a(p) += sigma_p * sigma_p * term.weight;
      c(j) += sigma_i * sigma_i * term.weight;
      b(p, j) += sigma_p * sigma_i * term.weight;
    }
    const Eigen::MatrixXd scaled = a.cwiseInverse().asDiagonal() * b;
    const Eigen::MatrixXd remaining = Eigen::MatrixXd(c.asDiagonal()) - b.transpose() * scaled;
    const CholeskyFactors factor(remaining);
    NewtonStep step{};
    step.v = factor.solved(slope_v - scaled.transpose() * slope_u);
    step.u = slope_u.cwiseQuotient(a) - scaled * step.v;
    step.log_determinant = a.array().log().sum() + factor.log_determinant();
    return step;
  }

  std::span<const CrossedHits> responses_{};
  const CrossedModel& model_;
  Eigen::Index participants_ = 0;
  Eigen::Index items_ = 0;
  double constant_ = 0.0;
};

/// β, then those of σ_p and σ_i that are estimated.
class OuterProblem final {
 public:
  OuterProblem(const CrossedLikelihood& likelihood, const CrossedModel& model)
      : likelihood_(likelihood), model_(model) {}

  Eigen::Index effects() const { return model_.design.cols(); }
  Eigen::Index size() const {
    return effects() + (model_.participants_vary ? 1 : 0) + (model_.items_vary ? 1 : 0);
  }
  double sigma_p(const Eigen::VectorXd& at) const {
    return model_.participants_vary ? at(effects()) : 0.0;
  }
  double sigma_i(const Eigen::VectorXd& at) const {
    return model_.items_vary ? at(size() - 1) : 0.0;
  }
  double value(const Eigen::VectorXd& at) const {
    return likelihood_.mode(at.head(effects()), sigma_p(at), sigma_i(at)).log_likelihood;
  }

 private:
  const CrossedLikelihood& likelihood_;
  const CrossedModel& model_;
};

Eigen::VectorXd searched(const OuterProblem& problem, const Eigen::VectorXd& start) {
  const auto size = static_cast<std::size_t>(problem.size());
  std::vector<double> low(size, -kMostVariance);
  std::fill(low.begin() + problem.effects(), low.end(), 0.0);
  std::vector<double> point(start.begin(), start.end());
  nlopt::opt optimizer(nlopt::LN_BOBYQA, static_cast<unsigned>(size));
  optimizer.set_lower_bounds(low);
  optimizer.set_upper_bounds(std::vector<double>(size, kMostVariance));
  optimizer.set_initial_step(0.3);
  optimizer.set_max_objective(
      [](const std::vector<double>& x, std::vector<double>&, void* data) {
        return static_cast<const OuterProblem*>(data)->value(
            Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
      },
      const_cast<OuterProblem*>(&problem));
  optimizer.set_xtol_rel(1e-7);
  optimizer.set_ftol_abs(1e-10);
  optimizer.set_maxeval(3000);
  double value = 0.0;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::roundoff_limited&) {
    // What it reached is the start of Newton's steps.
  }
  return Eigen::Map<const Eigen::VectorXd>(point.data(), problem.size());
}

struct Derivatives {
  Eigen::VectorXd gradient{};
  Eigen::MatrixXd hessian{};
};

// By differences of the fourth order; σ stays above 2h, where this is asked.
Derivatives derivatives(const OuterProblem& problem, const Eigen::VectorXd& at, double h) {
  const Eigen::Index size = at.size();
  constexpr std::array<double, 4> kPlaces{-2.0, -1.0, 1.0, 2.0};
  constexpr std::array<double, 4> kFirst{1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0};
  constexpr std::array<double, 4> kSecond{-1.0 / 12.0, 16.0 / 12.0, 16.0 / 12.0, -1.0 / 12.0};
  const double centre = problem.value(at);
  Derivatives found{.gradient = Eigen::VectorXd::Zero(size),
                    .hessian = Eigen::MatrixXd::Zero(size, size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    found.hessian(i, i) = -30.0 / 12.0 * centre / (h * h);
    for (std::size_t s = 0; s < kPlaces.size(); ++s) {
      Eigen::VectorXd there = at;
      there(i) += kPlaces[s] * h;
      const double value = problem.value(there);
      found.gradient(i) += kFirst[s] * value / h;
      found.hessian(i, i) += kSecond[s] * value / (h * h);
    }
    for (Eigen::Index j = 0; j < i; ++j) {
      for (std::size_t s = 0; s < kPlaces.size(); ++s) {
        for (std::size_t t = 0; t < kPlaces.size(); ++t) {
          Eigen::VectorXd there = at;
          there(i) += kPlaces[s] * h;
          there(j) += kPlaces[t] * h;
          found.hessian(i, j) += kFirst[s] * kFirst[t] * problem.value(there) / (h * h);
        }
      }
      found.hessian(j, i) = found.hessian(i, j);
    }
  }
  return found;
}

// Whether each group of responses has only hits or only misses.
template <typename Group>
bool all_alike(std::span<const CrossedHits> responses, const Group& group_of) {
  std::vector<HitCount> sums{};
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const std::size_t group = group_of(i);
    if (group >= sums.size()) sums.resize(group + 1);
    sums[group].hits += responses[i].count.hits;
    sums[group].trials += responses[i].count.trials;
  }
  return std::all_of(sums.begin(), sums.end(),
                     [](const HitCount& sum) { return sum.hits == 0 || sum.hits == sum.trials; });
}

bool is_indicator(const Eigen::MatrixXd& design, Eigen::Index column) {
  return ((design.col(column).array() == 0.0) || (design.col(column).array() == 1.0)).all();
}

// Whether the responses of a level of a condition, which is a 1 in its column of the design, or those of the reference
// level, are all hits or all misses. Covariates cannot prevent that the coefficient of such a level is infinite.
bool is_separated_by_a_level(std::span<const CrossedHits> responses,
                             const Eigen::MatrixXd& design) {
  const auto rows = static_cast<Eigen::Index>(responses.size());
  const auto all_alike_where = [&](const auto& is_of_level) {
    HitCount sum{};
    for (Eigen::Index row = 0; row < rows; ++row) {
      if (!is_of_level(row)) continue;
      sum.hits += responses[static_cast<std::size_t>(row)].count.hits;
      sum.trials += responses[static_cast<std::size_t>(row)].count.trials;
    }
    return sum.trials > 0 && (sum.hits == 0 || sum.hits == sum.trials);
  };
  Eigen::VectorXd levels = Eigen::VectorXd::Zero(rows);  // in how many levels a response is
  for (Eigen::Index column = 0; column < design.cols(); ++column) {
    if (!is_indicator(design, column)) continue;
    if (all_alike_where([&](Eigen::Index row) { return design(row, column) == 1.0; })) return true;
    if (column > 0) levels += design.col(column);
  }
  // The cell of the reference levels of two factors has no coefficient of its own.
  const bool has_one_factor = levels.maxCoeff() <= 1.0;
  return has_one_factor && all_alike_where([&](Eigen::Index row) { return levels(row) == 0.0; });
}

// The same model with covariates that have the mean 0 and the variance 1, whatever their units: bounds and differences of
// the search are for coefficients of the order of 1. With x'_j = (x_j − m_j)/s_j, β = `back`·β': β_j = β'_j/s_j, and
// β_0 = β'_0 − Σ m_j·β'_j/s_j.
struct StandardisedModel {
  CrossedModel model{};
  Eigen::MatrixXd back{};
};
StandardisedModel with_standardised_covariates(const CrossedModel& model) {
  StandardisedModel made{
      .model = model, .back = Eigen::MatrixXd::Identity(model.design.cols(), model.design.cols())};
  const auto rows = static_cast<double>(model.design.rows());
  for (Eigen::Index column = 1; column < model.design.cols(); ++column) {
    if (is_indicator(model.design, column)) continue;
    const double mean = model.design.col(column).mean();
    const double deviation =
        std::sqrt((model.design.col(column).array() - mean).square().sum() / rows);
    if (!(deviation > 0.0)) continue;  // not a model, which the likelihood refuses
    made.model.design.col(column) = (model.design.col(column).array() - mean) / deviation;
    made.back(column, column) = 1.0 / deviation;
    made.back(0, column) = -mean / deviation;
  }
  return made;
}

bool is_separated(std::span<const CrossedHits> responses, const CrossedModel& model,
                  const CrossedLikelihood& likelihood) {
  if (is_separated_by_a_level(responses, model.design)) return true;
  if (model.participants_vary &&
      all_alike(responses, [&](std::size_t i) { return responses[i].participant; })) {
    return true;
  }
  if (model.items_vary && all_alike(responses, [&](std::size_t i) { return responses[i].item; })) {
    return true;
  }
  // Intercepts that may be as large as they like find a division where there is one.
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model.design.cols());
  return likelihood.separates(none, model.participants_vary ? kMostVariance : 0.0,
                              model.items_vary ? kMostVariance : 0.0);
}

CrossedProblem boundary(bool participants, bool items) {
  if (participants && items) return CrossedProblem::no_variance;
  return participants ? CrossedProblem::no_participant_variance : CrossedProblem::no_item_variance;
}

}  // namespace

CrossedAnswer crossed_fit(std::span<const CrossedHits> responses, const CrossedModel& given) {
  const auto [model, back] = with_standardised_covariates(given);
  const CrossedLikelihood likelihood(responses, model);
  if (is_separated(responses, model, likelihood)) return {};
  const OuterProblem problem(likelihood, model);
  Eigen::VectorXd at{};
  double value = -std::numeric_limits<double>::infinity();
  for (const double sigma : {0.3, 1.0}) {
    Eigen::VectorXd start = Eigen::VectorXd::Zero(problem.size());
    start.tail(problem.size() - problem.effects()).setConstant(sigma);
    const Eigen::VectorXd found = searched(problem, start);
    if (problem.value(found) > value) {
      at = found;
      value = problem.value(found);
    }
  }
  if (at.cwiseAbs().maxCoeff() > 0.9 * kMostVariance) return {};
  constexpr double kDifference = 1e-3;
  const bool no_p =
      model.participants_vary && problem.sigma_p(at) < 2.0 * kDifference + kNoVariance;
  const bool no_i = model.items_vary && problem.sigma_i(at) < 2.0 * kDifference + kNoVariance;
  if (no_p || no_i) return {.problem = boundary(no_p, no_i)};
  Derivatives found = derivatives(problem, at, kDifference);
  constexpr int kSharpenings = 4;
  for (int step = 0; step < kSharpenings; ++step) {
    const Eigen::VectorXd move = SymmetricFactors(found.hessian).solved(found.gradient);
    if (!(move.cwiseAbs().maxCoeff() < 0.05)) break;  // no maximum near: judged below
    at -= move;
    found = derivatives(problem, at, kDifference);
  }
  const CholeskyFactors information(-found.hessian);
  if (!information.is_positive_definite() || !(found.gradient.cwiseAbs().maxCoeff() < 1e-4)) {
    return {};
  }
  const Eigen::MatrixXd covariance = information.inverse();
  const Eigen::MatrixXd of_effects =
      back * covariance.topLeftCorner(problem.effects(), problem.effects()) * back.transpose();
  return {.fit = CrossedFit{.beta = back * at.head(problem.effects()),
                            .standard_error = of_effects.diagonal().cwiseSqrt(),
                            .sigma_participants = problem.sigma_p(at),
                            .sigma_items = problem.sigma_i(at),
                            .log_likelihood = problem.value(at)}};
}

double crossed_log_likelihood(std::span<const CrossedHits> responses, const CrossedModel& model,
                              const CrossedFit& at) {
  return CrossedLikelihood(responses, model)
      .mode(at.beta, at.sigma_participants, at.sigma_items)
      .log_likelihood;
}

SampledError intercept_error(const CrossedFit& fit, std::size_t participants, std::size_t items) {
  double variance = fit.standard_error(0) * fit.standard_error(0);
  double df = std::numeric_limits<double>::infinity();
  const auto add = [&](const char* argument, double sigma, std::size_t intercepts) {
    if (sigma == 0.0 && intercepts < 2) return;
    if (intercepts < 2) {
      throw std::invalid_argument(std::string(argument) + ": there are " +
                                  std::to_string(intercepts) +
                                  " random intercepts with a variance above 0; pass at least 2");
    }
    const auto k = static_cast<double>(intercepts);
    variance += sigma * sigma / (k * (k - 1.0));
    df = std::min(df, k - 1.0);
  };
  add("participants", fit.sigma_participants, participants);
  add("items", fit.sigma_items, items);
  return {.standard_error = std::sqrt(variance), .df = df};
}

}  // namespace asperity
