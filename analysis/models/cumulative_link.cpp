// Newton's method on the gradient of the likelihood.

#include "analysis/models/cumulative_link.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/models/cumulative_likelihood.h"
#include "analysis/numbers/dense.h"

namespace asperity {
namespace {

/// The parameters that are estimated as one vector: θ, β, and those of σ that vary.
class OrdinalProblem final {
 public:
  OrdinalProblem(const OrdinalLikelihood& likelihood, bool participants, bool items)
      : likelihood_(likelihood), participants_(participants), items_(items) {}

  Eigen::Index coefficients() const { return likelihood_.thresholds() + likelihood_.effects(); }
  Eigen::Index size() const { return coefficients() + (participants_ ? 1 : 0) + (items_ ? 1 : 0); }

  OrdinalParameters place(const Eigen::VectorXd& at) const {
    return {.thresholds = OrdinalThresholds(at.head(likelihood_.thresholds())),
            .beta = at.segment(likelihood_.thresholds(), likelihood_.effects()),
            .sigma_p = participants_ ? at(coefficients()) : 0.0,
            .sigma_i = items_ ? at(size() - 1) : 0.0};
  }

  /// −∞ where the thresholds do not increase.
  double value(const Eigen::VectorXd& at, CrossedIntercepts& intercepts) const {
    for (Eigen::Index j = 1; j < likelihood_.thresholds(); ++j) {
      if (!(at(j) > at(j - 1))) return -std::numeric_limits<double>::infinity();
    }
    return likelihood_.value(place(at), intercepts);
  }

  Eigen::VectorXd slope(const Eigen::VectorXd& at, CrossedIntercepts& intercepts) const {
    const Eigen::VectorXd all = likelihood_.gradient(place(at), intercepts);
    Eigen::VectorXd own(size());
    own.head(coefficients()) = all.head(coefficients());
    if (participants_) own(coefficients()) = all(coefficients());
    if (items_) own(size() - 1) = all(coefficients() + 1);
    return own;
  }

  enum class Accuracy { search, result };
  /// −∂²ln L by central differences of the gradient, of the second order for a search and of the fourth
  /// for a result.
  Eigen::MatrixXd information(const Eigen::VectorXd& at, const CrossedIntercepts& intercepts,
                              Accuracy accuracy) const {
    double narrowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 1; j < likelihood_.thresholds(); ++j) {
      narrowest = std::min(narrowest, at(j) - at(j - 1));
    }
    const double h = std::min(1e-3, narrowest / 8.0);  // thresholds stay in order
    const auto difference = [&](Eigen::Index i, double step) -> Eigen::VectorXd {
      Eigen::VectorXd there = at;
      CrossedIntercepts near = intercepts;
      there(i) = at(i) + step;
      const Eigen::VectorXd after = slope(there, near);
      there(i) = at(i) - step;
      return (after - slope(there, near)) / (2.0 * step);
    };
    Eigen::MatrixXd made(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      made.col(i) = -difference(i, h);
      if (accuracy == Accuracy::search) continue;
      made.col(i) = (4.0 * made.col(i) + difference(i, 2.0 * h)) / 3.0;
    }
    return 0.5 * (made + made.transpose());
  }

 private:
  const OrdinalLikelihood& likelihood_;
  bool participants_ = false;
  bool items_ = false;
};

struct LinkMaximum {
  Eigen::VectorXd at{};
  double value = 0.0;
  Eigen::MatrixXd information{};
};

/// Beyond it the intercepts of participants decide their responses.
constexpr double kMostSigma = 30.0;
/// σ below it is 0: the likelihood is even in σ, so that a maximum at 0 is found as a number near it.
constexpr double kNoSigma = 1e-3;
/// The information of a coefficient in units of its scaled column; it falls to 0 where one is infinite.
constexpr double kLeastInformation = 1e-7;

struct LinkSearch {
  std::optional<LinkMaximum> maximum{};  // nothing where the search does not end at one
  bool unbounded = false;                // because σ grew beyond all bounds
};

/// Newton's method. Where ln L is not concave, a step is taken by the absolute values of the
/// eigenvalues, which is uphill. Without random intercepts ln L is concave everywhere, and only an
/// infinite coefficient has no information.
LinkSearch search_from(const OrdinalProblem& problem, Eigen::VectorXd at,
                       CrossedIntercepts intercepts) {
  constexpr int kMostSteps = 200;
  constexpr double kLongestStep = 2.0;
  constexpr double kClose = 1e-8;
  constexpr double kSaddle = 1e-4;
  constexpr double kOffSaddle = 0.1;
  double value = problem.value(at, intercepts);
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd slope = problem.slope(at, intercepts);
    const EigenAxes information =
        eigen_axes(problem.information(at, intercepts, OrdinalProblem::Accuracy::search));
    if (!information.has_converged || !slope.allFinite()) return {};
    const Eigen::VectorXd curved = information.values.cwiseAbs().cwiseMax(0.1 * kLeastInformation);
    Eigen::VectorXd move =
        information.vectors * (information.vectors.transpose() * slope).cwiseQuotient(curved);
    const double far = move.cwiseAbs().maxCoeff();
    const bool concave = information.values.minCoeff() > kLeastInformation;
    if (!concave && problem.size() == problem.coefficients()) return {};
    if (concave && far < kClose * (1.0 + at.cwiseAbs().maxCoeff())) {
      at += move;
      value = problem.value(at, intercepts);
      return {.maximum = LinkMaximum{.at = at,
                                     .value = value,
                                     .information = problem.information(
                                         at, intercepts, OrdinalProblem::Accuracy::result)}};
    }
    if (!concave && far < kSaddle) {  // σ = 0 where the likelihood grows on both sides of it
      at.tail(at.size() - problem.coefficients()).array() += kOffSaddle;
      value = problem.value(at, intercepts);
      continue;
    }
    if (far > kLongestStep) move *= kLongestStep / far;
    double length = 1.0;
    CrossedIntercepts there = intercepts;
    double next = problem.value(at + move, there);
    // A sufficient gain, but for rounding: a step from σ to −σ has none.
    const double promised = 1e-4 * slope.dot(move);
    const double rounding = 1e-13 * std::abs(value);
    while (!(next >= value + length * promised - rounding) && length > 1e-10) {
      length *= 0.5;
      there = intercepts;
      next = problem.value(at + length * move, there);
    }
    at += length * move;
    value = next;
    intercepts = std::move(there);
    if (at.tail(at.size() - problem.coefficients()).cwiseAbs().sum() > kMostSigma) {
      return {.unbounded = true};
    }
  }
  return {};
}

/// The fit of the fixed effects alone, from the thresholds that the proportions of categories have.
std::optional<LinkMaximum> fixed_maximum(const OrdinalLikelihood& likelihood,
                                         std::span<const std::size_t> counts) {
  const OrdinalProblem problem(likelihood, false, false);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(problem.size());
  double all = 0.0;
  for (const std::size_t count : counts) all += static_cast<double>(count);
  double below = 0.0;
  for (Eigen::Index j = 0; j < likelihood.thresholds(); ++j) {
    below += static_cast<double>(counts[static_cast<std::size_t>(j)]);
    start(j) = std::log(below / (all - below));
  }
  return search_from(problem, start, likelihood.none()).maximum;
}

CumulativeLinkProblem boundary_problem(bool participants, bool items) {
  if (participants && items) return CumulativeLinkProblem::no_variance;
  return participants ? CumulativeLinkProblem::no_participant_variance
                      : CumulativeLinkProblem::no_item_variance;
}

CumulativeLinkFit fit_at(const OrdinalLikelihood& likelihood, const OrdinalProblem& problem,
                         const LinkMaximum& maximum, std::size_t responses) {
  const OrdinalParameters place = problem.place(maximum.at);
  const Eigen::Index size = problem.coefficients();
  Eigen::VectorXd units = Eigen::VectorXd::Ones(size);  // of scaled columns in those of the design
  units.tail(likelihood.effects()) = likelihood.scale().cwiseInverse();
  const Eigen::MatrixXd covariance = SymmetricFactors(maximum.information).inverse();
  return {
      .thresholds = place.thresholds.at,
      .beta = place.beta.cwiseQuotient(likelihood.scale()),
      .sigma_participants = std::abs(place.sigma_p),
      .sigma_items = std::abs(place.sigma_i),
      .covariance = units.asDiagonal() * covariance.topLeftCorner(size, size) * units.asDiagonal(),
      .log_likelihood = maximum.value,
      .parameters = static_cast<std::size_t>(problem.size()),
      .responses = responses};
}

}  // namespace

Eigen::VectorXd CumulativeLinkFit::threshold_standard_error() const {
  return covariance.diagonal().head(thresholds.size()).cwiseSqrt();
}

Eigen::VectorXd CumulativeLinkFit::standard_error() const {
  return covariance.diagonal().tail(beta.size()).cwiseSqrt();
}

CumulativeLinkAnswer cumulative_link_fit(std::span<const OrdinalResponse> responses,
                                         const CumulativeLinkModel& model) {
  const OrdinalLikelihood likelihood(responses, model);
  std::vector<std::size_t> counts(model.categories);
  for (const OrdinalResponse& one : responses) ++counts[one.category];
  if (const auto unused = std::find(counts.begin(), counts.end(), 0U); unused != counts.end()) {
    return {.problem = CumulativeLinkProblem::unused_category,
            .unused_category = static_cast<std::size_t>(unused - counts.begin())};
  }
  const std::optional<LinkMaximum> fixed = fixed_maximum(likelihood, counts);
  // Concave: only an infinite coefficient keeps Newton's method from the maximum.
  if (!fixed) return {.problem = CumulativeLinkProblem::separated};
  const OrdinalProblem problem(likelihood, model.participants_vary, model.items_vary);
  if (problem.size() == problem.coefficients()) {
    return {.fit = fit_at(likelihood, problem, *fixed, responses.size())};
  }
  std::optional<LinkMaximum> best{};
  bool unbounded = false;
  for (const double sigma : {0.5, 1.5}) {
    Eigen::VectorXd start = Eigen::VectorXd::Constant(problem.size(), sigma);
    start.head(problem.coefficients()) = fixed->at;
    LinkSearch search = search_from(problem, start, likelihood.none());
    unbounded = unbounded || search.unbounded;
    if (search.maximum && (!best || search.maximum->value > best->value)) {
      best = std::move(search.maximum);
    }
  }
  // A likelihood that grows with σ without bound exceeds every local maximum in the end.
  if (unbounded) return {.problem = CumulativeLinkProblem::unbounded_variance};
  if (!best) return {.problem = CumulativeLinkProblem::not_converged};
  CumulativeLinkFit fit = fit_at(likelihood, problem, *best, responses.size());
  const bool no_p = model.participants_vary && fit.sigma_participants < kNoSigma;
  const bool no_i = model.items_vary && fit.sigma_items < kNoSigma;
  if (no_p || no_i) return {.problem = boundary_problem(no_p, no_i)};
  return {.fit = std::move(fit)};
}

double cumulative_link_log_likelihood(std::span<const OrdinalResponse> responses,
                                      const CumulativeLinkModel& model,
                                      const CumulativeLinkFit& at) {
  const OrdinalLikelihood likelihood(responses, model);
  if (at.thresholds.size() != likelihood.thresholds() || at.beta.size() != likelihood.effects()) {
    throw std::invalid_argument(
        "at: the number of thresholds is " + std::to_string(at.thresholds.size()) +
        " and that of effects is " + std::to_string(at.beta.size()) +
        "; they must be those of the model, " + std::to_string(likelihood.thresholds()) + " and " +
        std::to_string(likelihood.effects()));
  }
  for (Eigen::Index j = 1; j < at.thresholds.size(); ++j) {
    if (!(at.thresholds(j) > at.thresholds(j - 1))) {
      throw std::invalid_argument(
          "at: its thresholds do not increase; they must be in ascending order");
    }
  }
  CrossedIntercepts intercepts = likelihood.none();
  return likelihood.value({.thresholds = OrdinalThresholds(at.thresholds),
                           .beta = at.beta.cwiseProduct(likelihood.scale()),
                           .sigma_p = model.participants_vary ? at.sigma_participants : 0.0,
                           .sigma_i = model.items_vary ? at.sigma_items : 0.0},
                          intercepts);
}

WaldTest wald_test(const CumulativeLinkFit& fit, std::size_t effect) {
  const auto index = static_cast<Eigen::Index>(effect);
  if (index >= fit.beta.size()) {
    throw std::invalid_argument("effect is " + std::to_string(effect) + "; it must be below " +
                                std::to_string(fit.beta.size()));
  }
  const double z = fit.beta(index) / fit.standard_error()(index);
  return {.z = z, .p = 2.0 * normal_below(-std::abs(z))};
}

ChiSquaredStatistic likelihood_ratio(const CumulativeLinkFit& smaller,
                                     const CumulativeLinkFit& larger) {
  if (smaller.responses != larger.responses ||
      smaller.thresholds.size() != larger.thresholds.size()) {
    throw std::invalid_argument(
        "smaller and larger are fitted to different responses; fit both to the same ones");
  }
  if (larger.parameters <= smaller.parameters) {
    throw std::invalid_argument(
        "larger: the number of parameters is " + std::to_string(larger.parameters) +
        "; it must exceed that of the smaller model, " + std::to_string(smaller.parameters));
  }
  const double gain = larger.log_likelihood - smaller.log_likelihood;
  constexpr double kRounding = 1e-7;
  if (gain < -kRounding * (1.0 + std::abs(smaller.log_likelihood))) {
    throw std::invalid_argument(
        "larger: its likelihood is below that of the smaller model; larger must contain the "
        "effects of smaller");
  }
  return {.value = std::max(0.0, 2.0 * gain),
          .df = static_cast<double>(larger.parameters - smaller.parameters)};
}

}  // namespace asperity
