// Newton's method; the log likelihood is concave.

#include "analysis/choices/conditional_logit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/number_text.h"

namespace asperity {

void ChoiceData::add(double count, std::span<const Term> terms) {
  if (strata_.empty())
    throw std::logic_error("no stratum has begun; call begin_stratum before add");
  counts_.push_back(count);
  for (const Term& term : terms) {
    terms_.push_back(term);
    parameters_ = std::max(parameters_, term.parameter + 1);
  }
  ends_.push_back(terms_.size());
}

ChoiceData::Range ChoiceData::stratum(std::size_t index) const {
  return {.begin = strata_[index],
          .end = index + 1 < strata_.size() ? strata_[index + 1] : counts_.size()};
}

ChoiceData::Range ChoiceData::terms(std::size_t alternative) const {
  return {.begin = alternative == 0 ? 0 : ends_[alternative - 1], .end = ends_[alternative]};
}

double ChoiceData::utility(std::size_t alternative, const Eigen::VectorXd& coefficients) const {
  const Range range = terms(alternative);
  double utility = 0.0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    utility += terms_[i].weight * coefficients(static_cast<Eigen::Index>(terms_[i].parameter));
  }
  return utility;
}

double ChoiceData::largest_log_likelihood() const {
  double sum = 0.0;
  for (std::size_t index = 0; index < strata_.size(); ++index) {
    const Range range = stratum(index);
    double all = 0.0;
    for (std::size_t a = range.begin; a < range.end; ++a) all += counts_[a];
    for (std::size_t a = range.begin; a < range.end; ++a) {
      if (counts_[a] > 0.0) sum += counts_[a] * std::log(counts_[a] / all);
    }
  }
  return sum;
}

double ChoiceData::log_likelihood(const Eigen::VectorXd& coefficients) const {
  double sum = 0.0;
  std::vector<double> utilities{};
  for (std::size_t index = 0; index < strata_.size(); ++index) {
    const Range range = stratum(index);
    utilities.clear();
    for (std::size_t a = range.begin; a < range.end; ++a) {
      utilities.push_back(utility(a, coefficients));
    }
    const double most = *std::max_element(utilities.begin(), utilities.end());
    double all = 0.0;
    for (const double one : utilities) all += std::exp(one - most);
    for (std::size_t a = range.begin; a < range.end; ++a) {
      if (counts_[a] > 0.0) {
        sum += counts_[a] * (utilities[a - range.begin] - most - std::log(all));
      }
    }
  }
  return sum;
}

ChoiceData::Slopes ChoiceData::slopes(const Eigen::VectorXd& coefficients,
                                      std::span<const std::size_t> clusters) const {
  const auto size = static_cast<Eigen::Index>(parameters_);
  Slopes at{.score = Eigen::VectorXd::Zero(size), .information = Eigen::MatrixXd::Zero(size, size)};
  if (!clusters.empty()) {
    const std::size_t most = *std::max_element(clusters.begin(), clusters.end());
    at.scores = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(most) + 1, size);
    at.informations.assign(most + 1, Eigen::MatrixXd::Zero(size, size));
  }
  std::vector<double> weights{};
  Eigen::VectorXd mean(size);
  Eigen::VectorXd score(size);
  // The information of a stratum goes to its cluster, and from there to the sum.
  const auto information_of = [&](std::size_t index) -> Eigen::MatrixXd& {
    return clusters.empty() ? at.information : at.informations[clusters[index]];
  };
  for (std::size_t index = 0; index < strata_.size(); ++index) {
    const Range range = stratum(index);
    double most = -std::numeric_limits<double>::infinity();
    double chosen = 0.0;
    weights.clear();
    for (std::size_t a = range.begin; a < range.end; ++a) {
      weights.push_back(utility(a, coefficients));
      most = std::max(most, weights.back());
      chosen += counts_[a];
    }
    double all = 0.0;
    for (double& weight : weights) {
      weight = std::exp(weight - most);
      all += weight;
    }
    const double log_all = most + std::log(all);
    mean.setZero();
    score.setZero();
    Eigen::MatrixXd& information = information_of(index);
    for (std::size_t a = range.begin; a < range.end; ++a) {
      const double p = weights[a - range.begin] / all;
      if (counts_[a] > 0.0) {
        at.log_likelihood += counts_[a] * (utility(a, coefficients) - log_all);
      }
      const Range own = terms(a);
      for (std::size_t i = own.begin; i < own.end; ++i) {
        const auto row = static_cast<Eigen::Index>(terms_[i].parameter);
        mean(row) += p * terms_[i].weight;
        score(row) += counts_[a] * terms_[i].weight;
        for (std::size_t j = own.begin; j < own.end; ++j) {
          information(row, static_cast<Eigen::Index>(terms_[j].parameter)) +=
              chosen * p * terms_[i].weight * terms_[j].weight;
        }
      }
    }
    score -= chosen * mean;
    at.score += score;
    information -= chosen * mean * mean.transpose();
    if (!clusters.empty()) {
      at.scores.row(static_cast<Eigen::Index>(clusters[index])) += score.transpose();
    }
  }
  for (const Eigen::MatrixXd& own : at.informations) at.information += own;
  return at;
}

std::optional<ConditionalLogit> conditional_logit(const ChoiceData& data) {
  constexpr int kMostSteps = 100;
  constexpr double kTooFar = 40.0;  // no data tell a chance of e⁻⁴⁰ from none
  constexpr double kSingular = 1e-13;
  const auto size = static_cast<Eigen::Index>(data.parameters());
  if (size == 0) return std::nullopt;
  ConditionalLogit fit{.coefficients = Eigen::VectorXd::Zero(size)};
  for (int step = 0; step < kMostSteps; ++step) {
    const ChoiceData::Slopes at = data.slopes(fit.coefficients);
    const SymmetricFactors information(at.information);
    const Eigen::VectorXd pivots = information.pivots();
    if (!(pivots.minCoeff() > kSingular * pivots.maxCoeff())) return std::nullopt;
    const Eigen::VectorXd move = information.solved(at.score);
    const double far = move.cwiseAbs().maxCoeff();
    // Newton's error is squared by a step: after one of 10⁻⁸ nothing is left to gain.
    if (far < 1e-8 * (1.0 + fit.coefficients.cwiseAbs().maxCoeff())) {
      fit.coefficients += move;
      const ChoiceData::Slopes top = data.slopes(fit.coefficients);
      fit.covariance = SymmetricFactors(top.information).inverse();
      fit.log_likelihood = top.log_likelihood;
      return fit;
    }
    // Near the top a whole step is right, and the gain may drown in the rounding of a long sum.
    constexpr double kNear = 1e-3;
    double length = 1.0;
    while (far > kNear && length > 1e-9 &&
           !(data.log_likelihood(fit.coefficients + length * move) >= at.log_likelihood)) {
      length *= 0.5;
    }
    fit.coefficients += length * move;
    if (fit.coefficients.cwiseAbs().maxCoeff() > kTooFar) return std::nullopt;
  }
  return std::nullopt;
}

Eigen::MatrixXd clustered_covariance(const ConditionalLogit& fit, const ChoiceData& data,
                                     std::span<const std::size_t> clusters) {
  if (clusters.size() != data.strata()) {
    throw std::invalid_argument("clusters has " + counted(clusters.size(), "entry", "entries") +
                                ", and data has " + counted(data.strata(), "stratum", "strata") +
                                "; clusters must have one entry per stratum");
  }
  const Eigen::MatrixXd scores = data.slopes(fit.coefficients, clusters).scores;
  return fit.covariance * (scores.transpose() * scores) * fit.covariance;
}

std::vector<ClusteredError> clustered_errors(const ConditionalLogit& fit, const ChoiceData& data,
                                             std::span<const std::size_t> clusters,
                                             const Eigen::MatrixXd& combinations) {
  if (clusters.size() != data.strata()) {
    throw std::invalid_argument("clusters has " + counted(clusters.size(), "entry", "entries") +
                                ", and data has " + counted(data.strata(), "stratum", "strata") +
                                "; clusters must have one entry per stratum");
  }
  if (std::set<std::size_t>(clusters.begin(), clusters.end()).size() < kFewestClusters) return {};
  const ChoiceData::Slopes at = data.slopes(fit.coefficients, clusters);
  const EigenAxes axes = eigen_axes(fit.covariance);
  const Eigen::MatrixXd root =  // V^½
      axes.vectors * axes.values.cwiseSqrt().asDiagonal() * axes.vectors.adjoint();
  const Eigen::MatrixXd directions = root * combinations.transpose();
  const Eigen::Index rows = combinations.rows();
  Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(rows);  // Σℓ_g²
  // With b_g = M_g·a_g and q_g = a_g'b_g: tr Γ = Σ(q_g − |b_g|²), and, because the sum of all
  // (b_g'b_k)² is the square of the Frobenius norm of Σb_g·b_g',
  // tr Γ² = |Σb_g·b_g'|² + Σ(q_g² − 2·q_g·|b_g|²).
  Eigen::RowVectorXd trace = Eigen::RowVectorXd::Zero(rows);
  Eigen::RowVectorXd trace_of_square = Eigen::RowVectorXd::Zero(rows);
  std::vector<Eigen::MatrixXd> outer(static_cast<std::size_t>(rows),
                                     Eigen::MatrixXd::Zero(root.rows(), root.cols()));
  for (std::size_t g = 0; g < at.informations.size(); ++g) {
    const EigenAxes m = eigen_axes(root * at.informations[g] * root);
    // A cluster that alone determines a direction (h = 1) shows no differences along it.
    constexpr double kAlone = 1.0 - 1e-9;
    const Eigen::VectorXd factors =
        m.values.unaryExpr([](double h) { return h < kAlone ? 1.0 / std::sqrt(1.0 - h) : 0.0; });
    const Eigen::MatrixXd turned = m.vectors.transpose() * directions;
    const Eigen::MatrixXd adjusted = m.vectors * factors.asDiagonal() * turned;  // a_g
    const Eigen::MatrixXd weighted =
        m.vectors * m.values.cwiseProduct(factors).asDiagonal() * turned;  // b_g
    const Eigen::RowVectorXd score = at.scores.row(static_cast<Eigen::Index>(g)) * root;
    squares += (score * adjusted).cwiseAbs2();
    const Eigen::RowVectorXd q = adjusted.cwiseProduct(weighted).colwise().sum();
    const Eigen::RowVectorXd norms = weighted.colwise().squaredNorm();
    trace += q - norms;
    trace_of_square += q.cwiseProduct(q - 2.0 * norms);
    for (Eigen::Index c = 0; c < rows; ++c) {
      outer[static_cast<std::size_t>(c)] += weighted.col(c) * weighted.col(c).transpose();
    }
  }
  std::vector<ClusteredError> errors{};
  for (Eigen::Index c = 0; c < rows; ++c) {
    // Participants who respond alike have no spread but for rounding.
    constexpr double kOnlyRounding = 1e-20;
    const bool has_spread = squares(c) > kOnlyRounding * directions.col(c).squaredNorm();
    const double of_square = trace_of_square(c) + outer[static_cast<std::size_t>(c)].squaredNorm();
    errors.push_back({.standard_error = has_spread ? std::sqrt(squares(c)) : 0.0,
                      .df = trace(c) * trace(c) / of_square});
  }
  return errors;
}

}  // namespace asperity
