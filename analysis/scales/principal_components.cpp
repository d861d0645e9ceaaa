// Eigenvectors of correlations, parallel analysis, and components corrected for the participants' deviations.

#include "analysis/scales/principal_components.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/matrix_place.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "analysis/tests/t_test.h"

namespace asperity {
namespace {

void refuse_impossible_table(const TableSize& size) {
  if (size.rows < 3 || size.columns < 2) {
    throw std::invalid_argument("values has the size " + std::to_string(size.rows) + " × " +
                                std::to_string(size.columns) +
                                "; at least 3 rows and 2 columns are needed");
  }
}

/// Mean 0 and variance 1 (divisor n − 1) in every column, none of which is constant.
Eigen::MatrixXd standardised(const Eigen::MatrixXd& values) {
  Eigen::MatrixXd z = values.rowwise() - values.colwise().mean();
  const Eigen::RowVectorXd sd =
      (z.colwise().squaredNorm() / static_cast<double>(values.rows() - 1)).cwiseSqrt();
  for (Eigen::Index column = 0; column < z.cols(); ++column) z.col(column) /= sd(column);
  return z;
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& z) {
  Eigen::MatrixXd r = z.transpose() * z / static_cast<double>(z.rows() - 1);
  r.diagonal().setOnes();
  return r;
}

double sign_of_largest(const Eigen::VectorXd& loadings) {
  constexpr double kEqual = 1e-9;
  const double largest = loadings.cwiseAbs().maxCoeff();
  for (const double loading : loadings) {
    if (std::abs(loading) >= (1.0 - kEqual) * largest) return loading < 0.0 ? -1.0 : 1.0;
  }
  return 1.0;
}

}  // namespace

std::optional<Eigen::Index> constant_column(const Eigen::MatrixXd& values) {
  // Equal numbers that were computed in different ways differ by rounding.
  constexpr double kRounding = 1e-13;
  for (Eigen::Index column = 0; column < values.cols(); ++column) {
    const auto of = values.col(column);
    if (of.maxCoeff() - of.minCoeff() <= kRounding * of.cwiseAbs().maxCoeff()) return column;
  }
  return std::nullopt;
}

std::optional<PrincipalComponents> principal_components(const Eigen::MatrixXd& values) {
  refuse_impossible_table({.rows = values.rows(), .columns = values.cols()});
  if (!values.allFinite())
    throw std::invalid_argument("values: the value in " + place_not_finite(values) +
                                " is not finite; all must be finite");
  if (constant_column(values)) return std::nullopt;
  const Eigen::MatrixXd z = standardised(values);
  const EigenAxes axes = eigen_axes(correlations(z));
  const Eigen::Index p = values.cols();
  const auto scales = static_cast<double>(p);
  PrincipalComponents answer{.eigenvalues = axes.values.reverse()};
  Eigen::MatrixXd directions = axes.vectors.rowwise().reverse();
  constexpr double kOnlyRounding = 1e-12;
  for (Eigen::Index component = 0; component < p; ++component) {
    if (answer.eigenvalues(component) <= kOnlyRounding * scales) {
      answer.eigenvalues(component) = 0.0;
      directions.col(component).setZero();
    }
    directions.col(component) *= sign_of_largest(directions.col(component));
  }
  answer.proportion = answer.eigenvalues / scales;
  answer.loadings = directions * answer.eigenvalues.cwiseSqrt().asDiagonal();
  answer.scores = z * directions;
  return answer;
}

Eigen::VectorXd eigenvalues_of_noise(const TableSize& size, Random random) {
  refuse_impossible_table(size);
  Eigen::MatrixXd noise(size.rows, size.columns);
  for (Eigen::Index row = 0; row < size.rows; ++row) {
    for (Eigen::Index column = 0; column < size.columns; ++column) {
      noise(row, column) = random.normal();
    }
  }
  return eigenvalues(correlations(standardised(noise))).reverse();
}

ParallelAnalysis parallel_analysis(const Eigen::VectorXd& eigenvalues, Eigen::Index rows,
                                   const ParallelQuestion& question, Random random) {
  std::vector<Eigen::VectorXd> of_noise{};
  of_noise.reserve(question.data_sets);
  for (std::size_t i = 0; i < question.data_sets; ++i) {
    of_noise.push_back(eigenvalues_of_noise({.rows = rows, .columns = eigenvalues.size()},
                                            random.split(static_cast<std::uint64_t>(i))));
  }
  return compared_with_noise(eigenvalues, of_noise, question.percentile);
}

ParallelAnalysis compared_with_noise(const Eigen::VectorXd& eigenvalues,
                                     std::span<const Eigen::VectorXd> of_noise, double percentile) {
  if (of_noise.empty())
    throw std::invalid_argument("of_noise is empty; at least one data set is needed");
  if (!(percentile > 0.0 && percentile < 1.0)) {
    throw std::invalid_argument("percentile is " + number_text(percentile) +
                                "; it must lie between 0 and 1");
  }
  for (const Eigen::VectorXd& one : of_noise) {
    if (one.size() != eigenvalues.size()) {
      throw std::invalid_argument(
          "of_noise: a data set has " + counted(one.size(), "component", "components") +
          "; the number must be that of the eigenvalues, " + std::to_string(eigenvalues.size()));
    }
  }
  ParallelAnalysis answer{.limits = Eigen::VectorXd::Zero(eigenvalues.size()),
                          .means = Eigen::VectorXd::Zero(eigenvalues.size()),
                          .data_sets = of_noise.size()};
  std::vector<double> sorted(of_noise.size());
  for (Eigen::Index component = 0; component < eigenvalues.size(); ++component) {
    std::transform(of_noise.begin(), of_noise.end(), sorted.begin(),
                   [component](const Eigen::VectorXd& one) { return one(component); });
    std::sort(sorted.begin(), sorted.end());
    double sum = 0.0;
    for (const double one : sorted) sum += one;
    answer.means(component) = sum / static_cast<double>(sorted.size());
    answer.limits(component) = quantile(sorted, percentile);
  }
  for (Eigen::Index component = 0; component < eigenvalues.size(); ++component) {
    if (!(eigenvalues(component) > answer.limits(component))) break;
    ++answer.retained;
  }
  return answer;
}

Eigen::MatrixXd mean_table(std::span<const Eigen::MatrixXd> participants) {
  if (participants.empty())
    throw std::invalid_argument("participants is empty; at least one participant is needed");
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(participants[0].rows(), participants[0].cols());
  Eigen::MatrixXd n = total;
  for (const Eigen::MatrixXd& own : participants) {
    if (own.rows() != total.rows() || own.cols() != total.cols()) {
      throw std::invalid_argument(
          "participants: the tables differ in size; all must have the same");
    }
    for (Eigen::Index cell = 0; cell < own.size(); ++cell) {
      const double rating = own.data()[cell];
      if (std::isnan(rating)) continue;
      total.data()[cell] += rating;
      n.data()[cell] += 1.0;
    }
  }
  return total.cwiseQuotient(n);  // 0/0 is NaN
}

namespace {

/// Of a matrix of correlations that need not be positive semidefinite.
struct ComponentParts {
  Eigen::VectorXd proportion{};
  Eigen::MatrixXd loadings{};
};

/// The correlations of the items' means without the deviations of the participants; nothing where these explain all variance of
/// a scale.
std::optional<Eigen::MatrixXd> corrected_correlations(
    std::span<const Eigen::MatrixXd> participants) {
  const Eigen::MatrixXd means = mean_table(participants);
  const Eigen::RowVectorXd of_scales = means.colwise().mean();
  const Eigen::MatrixXd centred = means.rowwise() - of_scales;
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(means.cols(), means.cols());
  for (const Eigen::MatrixXd& own : participants) {
    const Eigen::MatrixXd rest =
        (own - means).rowwise() - (own.colwise().mean() - of_scales).eval();
    products += rest.transpose() * rest;
  }
  const auto n = static_cast<double>(participants.size());
  const auto items = static_cast<double>(means.rows());
  const Eigen::MatrixXd covariances =
      (centred.transpose() * centred - products / ((n - 1.0) * n)) / (items - 1.0);
  const Eigen::VectorXd variances = covariances.diagonal();
  if (!(variances.minCoeff() > 0.0)) return std::nullopt;
  const Eigen::VectorXd scale = variances.cwiseSqrt().cwiseInverse();
  return Eigen::MatrixXd(scale.asDiagonal() * covariances * scale.asDiagonal());
}

std::optional<ComponentParts> corrected_parts(std::span<const Eigen::MatrixXd> participants) {
  const std::optional<Eigen::MatrixXd> r = corrected_correlations(participants);
  if (!r) return std::nullopt;
  const EigenAxes axes = eigen_axes(*r);
  const Eigen::VectorXd values = axes.values.reverse();
  Eigen::MatrixXd directions = axes.vectors.rowwise().reverse();
  for (Eigen::Index component = 0; component < directions.cols(); ++component) {
    directions.col(component) *= sign_of_largest(directions.col(component));
  }
  return ComponentParts{.proportion = values / static_cast<double>(values.size()),
                        .loadings = directions * values.cwiseMax(0.0).cwiseSqrt().asDiagonal()};
}

double logit(double proportion) { return std::log(proportion / (1.0 - proportion)); }
double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// From the statistic of all and those without one participant each, on a scale without limits.
/// `back`: from that scale to the one of the answer.
std::optional<ComponentEstimate> jackknifed(double of_all, const std::vector<double>& without_one,
                                            double confidence, double (*back)(double)) {
  const auto n = static_cast<double>(without_one.size());
  std::vector<double> pseudo_values{};
  for (const double one : without_one) pseudo_values.push_back(n * of_all - (n - 1.0) * one);
  if (!std::all_of(pseudo_values.begin(), pseudo_values.end(),
                   [](double one) { return std::isfinite(one); })) {
    return std::nullopt;
  }
  const OneSampleT t = one_sample_t(pseudo_values, {.confidence = confidence});
  if (!t.test) return std::nullopt;
  const double half = 0.5 * (t.test->interval.high - t.test->interval.low);
  return ComponentEstimate{.corrected = back(of_all),
                           .interval = {.low = back(of_all - half), .high = back(of_all + half)}};
}

}  // namespace

std::optional<CorrectedComponents> corrected_components(
    std::span<const Eigen::MatrixXd> participants, double confidence) {
  if (participants.size() < kFewestForCorrection) return std::nullopt;
  refuse_impossible_table(
      {.rows = participants.front().rows(), .columns = participants.front().cols()});
  for (const Eigen::MatrixXd& own : participants) {
    if (own.hasNaN()) return std::nullopt;
  }
  const std::optional<ComponentParts> of_all = corrected_parts(participants);
  if (!of_all) return std::nullopt;
  std::vector<ComponentParts> without_one{};
  for (std::size_t left_out = 0; left_out < participants.size(); ++left_out) {
    std::vector<Eigen::MatrixXd> others(participants.begin(), participants.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    std::optional<ComponentParts> found = corrected_parts(others);
    if (!found) return std::nullopt;
    for (Eigen::Index component = 0; component < found->loadings.cols(); ++component) {
      if (found->loadings.col(component).dot(of_all->loadings.col(component)) < 0.0) {
        found->loadings.col(component) *= -1.0;
      }
    }
    without_one.push_back(*std::move(found));
  }
  const Eigen::Index p = of_all->loadings.cols();
  CorrectedComponents answer{};
  std::vector<double> others(without_one.size());
  for (Eigen::Index component = 0; component < p; ++component) {
    std::transform(without_one.begin(), without_one.end(), others.begin(),
                   [component](const auto& one) { return logit(one.proportion(component)); });
    answer.proportions.push_back(
        jackknifed(logit(of_all->proportion(component)), others, confidence, logistic));
  }
  for (Eigen::Index scale = 0; scale < p; ++scale) {
    auto& of_scale = answer.loadings.emplace_back();
    for (Eigen::Index component = 0; component < p; ++component) {
      std::transform(without_one.begin(), without_one.end(), others.begin(),
                     [&](const auto& one) { return std::atanh(one.loadings(scale, component)); });
      of_scale.push_back(jackknifed(std::atanh(of_all->loadings(scale, component)), others,
                                    confidence, [](double x) { return std::tanh(x); }));
    }
  }
  return answer;
}

}  // namespace asperity
