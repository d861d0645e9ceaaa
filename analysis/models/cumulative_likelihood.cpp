// The mode by Newton's method, with participants eliminated; the gradient includes the log determinant.

#include "analysis/models/cumulative_likelihood.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/matrix_place.h"

namespace asperity {
namespace {

/// The logistic function F at x with its density f and the derivative of the density.
struct LogisticAt {
  double below = 0.0;    // F(x)
  double density = 0.0;  // f(x)
  double slope = 0.0;    // f'(x) = f·(1 − 2F)
};
LogisticAt logistic_at(double x) {
  const double small = std::exp(-std::abs(x));
  const double part = 1.0 / (1.0 + small);
  LogisticAt at{.below = x >= 0.0 ? part : small * part, .density = small * part * part};
  at.slope = at.density * (1.0 - 2.0 * at.below);
  return at;
}

double log_logistic(double x) { return std::min(0.0, x) - std::log1p(std::exp(-std::abs(x))); }

/// ln P of a response, with a = θ_y − η, b = θ_{y−1} − η and Δ = θ_y − θ_{y−1}:
///
///   P = F(a) − F(b) = F(a)·F(−b)·(1 − e^−Δ),
///
/// without cancellation. In the lowest category F(−b) = 1, in the highest one F(a) = 1, and both
/// have no Δ.
double log_probability(std::size_t category, const OrdinalThresholds& thresholds, double eta) {
  const auto y = static_cast<Eigen::Index>(category);
  const bool has_upper = y < thresholds.at.size();
  const bool has_lower = y > 0;
  double sum = has_upper ? log_logistic(thresholds.at(y) - eta) : 0.0;
  if (has_lower) sum += log_logistic(eta - thresholds.at(y - 1));
  if (has_upper && has_lower) sum += thresholds.log_gap[category - 1];
  return sum;
}

/// The derivatives of ln P. Δ does not depend on η, hence ∂ln P/∂η = F(a) + F(b) − 1, and so on.
struct OrdinalTerm {
  double slope = 0.0;         // ∂/∂η
  double weight = 0.0;        // −∂²/∂η²
  double weight_slope = 0.0;  // ∂weight/∂η
  LogisticAt upper{};         // at a
  LogisticAt lower{};         // at b
  double gap_slope = 0.0;
};

OrdinalTerm ordinal_term(std::size_t category, const OrdinalThresholds& thresholds, double eta) {
  const auto y = static_cast<Eigen::Index>(category);
  const bool has_upper = y < thresholds.at.size();
  const bool has_lower = y > 0;
  OrdinalTerm term{.upper = {.below = 1.0}};
  if (has_upper) term.upper = logistic_at(thresholds.at(y) - eta);
  if (has_lower) term.lower = logistic_at(thresholds.at(y - 1) - eta);
  if (has_upper && has_lower) term.gap_slope = thresholds.gap_slope[category - 1];
  term.slope = term.upper.below + term.lower.below - 1.0;
  term.weight = term.upper.density + term.lower.density;
  term.weight_slope = -(term.upper.slope + term.lower.slope);
  return term;
}

}  // namespace

OrdinalThresholds::OrdinalThresholds(Eigen::VectorXd increasing) : at(std::move(increasing)) {
  for (Eigen::Index j = 1; j < at.size(); ++j) {
    log_gap.push_back(std::log(-std::expm1(at(j - 1) - at(j))));
    gap_slope.push_back(1.0 / std::expm1(at(j) - at(j - 1)));
  }
}

/// H⁻¹: its diagonal for the participants, and all of the rest.
struct OrdinalLikelihood::Inverse {
  Eigen::VectorXd of_participant{};
  Eigen::MatrixXd of_items{};
  Eigen::MatrixXd of_both{};
};

/// H = [A B; B' C] with diagonal A: the participants are eliminated, S = C − B'A⁻¹B remains, and
/// |H| = |A|·|S|.
struct OrdinalLikelihood::Curvature {
  Eigen::VectorXd a{};
  Eigen::MatrixXd scaled{};  // A⁻¹B
  CholeskyFactors remaining{};

  double log_determinant() const { return a.array().log().sum() + remaining.log_determinant(); }
  CrossedIntercepts solved(const CrossedIntercepts& right) const {
    CrossedIntercepts left{};
    left.v = remaining.solved(right.v - scaled.transpose() * right.u);
    left.u = right.u.cwiseQuotient(a) - scaled * left.v;
    return left;
  }
  Inverse inverse() const {
    Inverse made{.of_items = remaining.inverse()};
    made.of_both = -scaled * made.of_items;
    made.of_participant = a.cwiseInverse() - made.of_both.cwiseProduct(scaled).rowwise().sum();
    return made;
  }
};

OrdinalLikelihood::OrdinalLikelihood(std::span<const OrdinalResponse> responses,
                                     const CumulativeLinkModel& model)
    : responses_(responses), model_(model) {
  refuse_impossible();
  scale_ = (model.design.colwise().squaredNorm() / static_cast<double>(responses.size()))
               .cwiseSqrt()
               .transpose();
  design_ = model.design * scale_.cwiseInverse().asDiagonal();
  participant_.assign(responses.size(), 0);
  item_.assign(responses.size(), 0);
  for (std::size_t i = 0; i < responses.size(); ++i) {
    if (model.participants_vary) {
      participant_[i] = static_cast<Eigen::Index>(responses[i].participant);
    }
    if (model.items_vary) item_[i] = static_cast<Eigen::Index>(responses[i].item);
  }
  participants_ = *std::max_element(participant_.begin(), participant_.end()) + 1;
  items_ = *std::max_element(item_.begin(), item_.end()) + 1;
  if ((model.participants_vary && participants_ < 2) || (model.items_vary && items_ < 2)) {
    throw std::invalid_argument(
        "model: a factor with random intercepts has only one level; it must have at least 2");
  }
}

CrossedIntercepts OrdinalLikelihood::none() const {
  return {.u = Eigen::VectorXd::Zero(participants_), .v = Eigen::VectorXd::Zero(items_)};
}

double OrdinalLikelihood::value(const OrdinalParameters& at, CrossedIntercepts& intercepts) const {
  const double joint = to_mode(at, intercepts);
  return joint - 0.5 * curvature(at, intercepts).log_determinant();
}

Eigen::VectorXd OrdinalLikelihood::gradient(const OrdinalParameters& at,
                                            CrossedIntercepts& intercepts) const {
  to_mode(at, intercepts);
  Eigen::VectorXd made = Eigen::VectorXd::Zero(thresholds() + effects() + 2);
  const Curvature h = curvature(at, intercepts);
  const Inverse inverse = h.inverse();
  const Eigen::VectorXd fixed = design_ * at.beta;
  std::vector<OrdinalTerm> terms(responses_.size());
  std::vector<double> leverage(responses_.size());
  CrossedIntercepts pull = none();
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    terms[i] =
        ordinal_term(responses_[i].category, at.thresholds, predictor(fixed, at, intercepts, i));
    const Eigen::Index p = participant_[i];
    const Eigen::Index j = item_[i];
    leverage[i] = at.sigma_p * at.sigma_p * inverse.of_participant(p) +
                  2.0 * at.sigma_p * at.sigma_i * inverse.of_both(p, j) +
                  at.sigma_i * at.sigma_i * inverse.of_items(j, j);
    pull.u(p) += at.sigma_p * leverage[i] * terms[i].weight_slope;
    pull.v(j) += at.sigma_i * leverage[i] * terms[i].weight_slope;
  }
  const CrossedIntercepts q = h.solved(pull);
  Eigen::VectorXd of_eta(responses_.size());
  double& of_sigma_p = made(thresholds() + effects());
  double& of_sigma_i = made(thresholds() + effects() + 1);
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    const OrdinalTerm& term = terms[i];
    const Eigen::Index p = participant_[i];
    const Eigen::Index j = item_[i];
    const auto y = static_cast<Eigen::Index>(responses_[i].category);
    const double moved = at.sigma_p * q.u(p) + at.sigma_i * q.v(j);
    if (y < thresholds()) {
      made(y) += 1.0 - term.upper.below + term.gap_slope -
                 0.5 * (leverage[i] * term.upper.slope + moved * term.upper.density);
    }
    if (y > 0) {
      made(y - 1) += -term.lower.below - term.gap_slope -
                     0.5 * (leverage[i] * term.lower.slope + moved * term.lower.density);
    }
    const double direct =
        term.slope - 0.5 * leverage[i] * term.weight_slope + 0.5 * moved * term.weight;
    of_eta(static_cast<Eigen::Index>(i)) = direct;
    of_sigma_p +=
        intercepts.u(p) * direct - 0.5 * q.u(p) * term.slope -
        term.weight * (at.sigma_p * inverse.of_participant(p) + at.sigma_i * inverse.of_both(p, j));
    of_sigma_i +=
        intercepts.v(j) * direct - 0.5 * q.v(j) * term.slope -
        term.weight * (at.sigma_p * inverse.of_both(p, j) + at.sigma_i * inverse.of_items(j, j));
  }
  made.segment(thresholds(), effects()) = design_.transpose() * of_eta;
  return made;
}

double OrdinalLikelihood::predictor(const Eigen::VectorXd& fixed, const OrdinalParameters& at,
                                    const CrossedIntercepts& intercepts, std::size_t row) const {
  return fixed(static_cast<Eigen::Index>(row)) + at.sigma_p * intercepts.u(participant_[row]) +
         at.sigma_i * intercepts.v(item_[row]);
}

double OrdinalLikelihood::joint_density(const Eigen::VectorXd& fixed, const OrdinalParameters& at,
                                        const CrossedIntercepts& intercepts) const {
  double sum = -0.5 * (intercepts.u.squaredNorm() + intercepts.v.squaredNorm());
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    sum +=
        log_probability(responses_[i].category, at.thresholds, predictor(fixed, at, intercepts, i));
  }
  return sum;
}

/// Newton's method; the joint density is log-concave in the intercepts. Returns its logarithm.
double OrdinalLikelihood::to_mode(const OrdinalParameters& at,
                                  CrossedIntercepts& intercepts) const {
  const Eigen::VectorXd fixed = design_ * at.beta;
  double there = joint_density(fixed, at, intercepts);
  if (!model_.participants_vary && !model_.items_vary) return there;
  constexpr int kMostSteps = 100;
  constexpr double kClose = 1e-11;
  for (int step = 0; step < kMostSteps; ++step) {
    CrossedIntercepts slope{};
    const CrossedIntercepts move = curvature(at, intercepts, &slope).solved(slope);
    CrossedIntercepts next{};
    double value = there;
    double length = 1.0;
    for (; length > 1e-10; length *= 0.5) {  // a step can overshoot
      next = {.u = intercepts.u + length * move.u, .v = intercepts.v + length * move.v};
      value = joint_density(fixed, at, next);
      if (value >= there - 1e-12 * std::abs(there)) break;
    }
    intercepts = std::move(next);
    there = value;
    if (length * std::max(move.u.cwiseAbs().maxCoeff(), move.v.cwiseAbs().maxCoeff()) < kClose) {
      break;
    }
  }
  return there;
}

OrdinalLikelihood::Curvature OrdinalLikelihood::curvature(const OrdinalParameters& at,
                                                          const CrossedIntercepts& intercepts,
                                                          CrossedIntercepts* slope) const {
  const Eigen::VectorXd fixed = design_ * at.beta;
  Curvature h{.a = Eigen::VectorXd::Ones(participants_)};
  Eigen::VectorXd c = Eigen::VectorXd::Ones(items_);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(participants_, items_);
  if (slope != nullptr) *slope = {.u = -intercepts.u, .v = -intercepts.v};
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    const OrdinalTerm term =
        ordinal_term(responses_[i].category, at.thresholds, predictor(fixed, at, intercepts, i));
    h.a(participant_[i]) += at.sigma_p * at.sigma_p * term.weight;
    c(item_[i]) += at.sigma_i * at.sigma_i * term.weight;
    b(participant_[i], item_[i]) += at.sigma_p * at.sigma_i * term.weight;
    if (slope == nullptr) continue;
    slope->u(participant_[i]) += at.sigma_p * term.slope;
    slope->v(item_[i]) += at.sigma_i * term.slope;
  }
  h.scaled = h.a.cwiseInverse().asDiagonal() * b;
  h.remaining = CholeskyFactors(Eigen::MatrixXd(c.asDiagonal()) - b.transpose() * h.scaled);
  return h;
}

void OrdinalLikelihood::refuse_impossible() const {
  if (responses_.empty())
    throw std::invalid_argument("responses is empty; at least one response is needed");
  if (model_.categories < 2) {
    throw std::invalid_argument("categories is " + std::to_string(model_.categories) +
                                "; it must be at least 2");
  }
  const auto rows = static_cast<Eigen::Index>(responses_.size());
  if (model_.design.rows() != rows) {
    throw std::invalid_argument("design: the number of rows is " +
                                std::to_string(model_.design.rows()) +
                                "; it must be the number of responses, " + std::to_string(rows));
  }
  if (!model_.design.allFinite())
    throw std::invalid_argument("design: the value in " + place_not_finite(model_.design) +
                                " is not finite; all must be finite");
  Eigen::MatrixXd with_ones(rows, model_.design.cols() + 1);
  with_ones << Eigen::VectorXd::Ones(rows), model_.design;
  if (with_ones.colPivHouseholderQr().rank() < with_ones.cols()) {
    throw std::invalid_argument(
        "design: its columns and a column of ones (for the thresholds) are linearly dependent; "
        "omit those that follow from others");
  }
  for (const OrdinalResponse& one : responses_) {
    if (one.category >= model_.categories) {
      throw std::invalid_argument("responses: a category is " + std::to_string(one.category) +
                                  "; it must be less than the number of categories, " +
                                  std::to_string(model_.categories));
    }
  }
}

}  // namespace asperity
