// Distances from confusions, eigenvectors of them, and joins.

#include "analysis/dissimilarity/dissimilarity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/dense.h"

namespace asperity {
namespace {

Eigen::MatrixXd conditional_probabilities(const ConfusionCounts& counts) {
  refuse_impossible_counts(counts);
  const Eigen::ArrayXXd more = counts.array() + 0.5;
  const Eigen::ArrayXd rows = more.rowwise().sum();
  return (more.colwise() / rows).matrix();
}

void refuse_impossible_matrix(const Dissimilarities& d) {
  if (d.rows() != d.cols() || d.rows() < 2) {
    throw std::invalid_argument("dissimilarities has the size " + std::to_string(d.rows()) + " × " +
                                std::to_string(d.cols()) +
                                "; it must be a square matrix with at least 2 rows");
  }
  if (!d.allFinite() || d.minCoeff() < 0.0 || d.diagonal().maxCoeff() > 0.0 || d != d.transpose()) {
    throw std::invalid_argument(
        "dissimilarities has an invalid value; it must be finite, symmetric, at least 0, and 0 on "
        "the diagonal");
  }
}

std::vector<double> pairs_of(const Eigen::MatrixXd& matrix) {
  std::vector<double> pairs;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    for (Eigen::Index i = j + 1; i < matrix.rows(); ++i) {
      pairs.push_back(matrix(i, j));
    }
  }
  return pairs;
}

// Distances that are equal but for rounding have no spread to correlate with.
bool are_all_equal(const std::vector<double>& numbers) {
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  constexpr double kRounding = 1e-13;
  return *greatest - *least <= kRounding * *greatest;
}

std::optional<double> correlation(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const std::vector<double> pairs_a = pairs_of(a);
  const std::vector<double> pairs_b = pairs_of(b);
  if (are_all_equal(pairs_a) || are_all_equal(pairs_b)) {
    return std::nullopt;
  }
  const auto n = static_cast<Eigen::Index>(pairs_a.size());
  const Eigen::Map<const Eigen::ArrayXd> x(pairs_a.data(), n);
  const Eigen::Map<const Eigen::ArrayXd> y(pairs_b.data(), n);
  const Eigen::ArrayXd dx = x - x.mean();
  const Eigen::ArrayXd dy = y - y.mean();
  return (dx * dy).sum() / std::sqrt(dx.square().sum() * dy.square().sum());
}

struct Sizes {
  double first = 1.0;
  double second = 1.0;
};

double joined_distance(Linkage linkage, const Sizes& sizes, double from_first, double from_second) {
  switch (linkage) {
    case Linkage::average:
      return (sizes.first * from_first + sizes.second * from_second) / (sizes.first + sizes.second);
    case Linkage::complete:
      return std::max(from_first, from_second);
    case Linkage::single:
      return std::min(from_first, from_second);
  }
  throw std::invalid_argument("linkage is not a Linkage; it must be average, complete or single");
}

}  // namespace

Dissimilarities shepard_dissimilarities(const ConfusionCounts& counts) {
  const Eigen::MatrixXd p = conditional_probabilities(counts);
  Dissimilarities d = Dissimilarities::Zero(p.rows(), p.cols());
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      d(i, j) = std::max(0.0, -0.5 * std::log(p(i, j) * p(j, i) / (p(i, i) * p(j, j))));
      d(j, i) = d(i, j);
    }
  }
  return d;
}

Dissimilarities linear_dissimilarities(const ConfusionCounts& counts) {
  const Eigen::MatrixXd p = conditional_probabilities(counts);
  Dissimilarities d = Dissimilarities::Zero(p.rows(), p.cols());
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      d(i, j) = 1.0 - (p(i, j) + p(j, i)) / 2.0;
      d(j, i) = d(i, j);
    }
  }
  return d;
}

ClassicalScaling classical_scaling(const Dissimilarities& dissimilarities,
                                   Eigen::Index dimensions) {
  refuse_impossible_matrix(dissimilarities);
  const Eigen::Index m = dissimilarities.rows();
  if (dimensions < 1 || dimensions > m) {
    throw std::invalid_argument("dimensions is " + std::to_string(dimensions) +
                                "; it must lie between 1 and the number of items, " +
                                std::to_string(m));
  }
  const Eigen::MatrixXd centre = Eigen::MatrixXd::Identity(m, m) -
                                 Eigen::MatrixXd::Constant(m, m, 1.0 / static_cast<double>(m));
  const Eigen::MatrixXd squares = dissimilarities.cwiseAbs2();
  const EigenAxes axes = eigen_axes(-0.5 * centre * squares * centre);
  ClassicalScaling answer{.eigenvalues = axes.values.reverse(),
                          .points = Eigen::MatrixXd::Zero(m, dimensions)};
  double shown = 0.0;
  for (Eigen::Index axis = 0; axis < dimensions; ++axis) {
    const double eigenvalue = answer.eigenvalues(axis);
    if (eigenvalue > 0.0) {
      answer.points.col(axis) = std::sqrt(eigenvalue) * axes.vectors.col(m - 1 - axis);
      shown += eigenvalue;
    }
  }
  const double of_absolute = answer.eigenvalues.cwiseAbs().sum();
  const double of_positive = answer.eigenvalues.cwiseMax(0.0).sum();
  if (of_absolute > 0.0) {
    answer.fit_of_absolute = shown / of_absolute;
  }
  if (of_positive > 0.0) {
    answer.fit_of_positive = shown / of_positive;
  }
  constexpr double kApart = 1e-6;
  answer.plane_is_unique = answer.eigenvalues(0) - answer.eigenvalues(1) > kApart &&
                           (m < 3 || answer.eigenvalues(1) - answer.eigenvalues(2) > kApart);
  return answer;
}

Tree agglomerate(const Dissimilarities& dissimilarities, Linkage linkage) {
  refuse_impossible_matrix(dissimilarities);
  const Eigen::Index m = dissimilarities.rows();
  Eigen::MatrixXd d = dissimilarities;
  // A cluster goes by its lowest item.
  std::vector<std::vector<Eigen::Index>> members(static_cast<std::size_t>(m));
  for (Eigen::Index i = 0; i < m; ++i) {
    members[static_cast<std::size_t>(i)] = {i};
  }
  Tree tree{.cophenetic = Eigen::MatrixXd::Zero(m, m)};
  for (Eigen::Index joins = 1; joins < m; ++joins) {
    Eigen::Index first = 0;
    Eigen::Index second = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index j = i + 1; j < m; ++j) {
        if (!members[static_cast<std::size_t>(i)].empty() &&
            !members[static_cast<std::size_t>(j)].empty() && d(i, j) < nearest) {
          nearest = d(i, j);
          first = i;
          second = j;
        }
      }
    }
    auto& kept = members[static_cast<std::size_t>(first)];
    auto& joined = members[static_cast<std::size_t>(second)];
    for (const Eigen::Index a : kept) {
      for (const Eigen::Index b : joined) {
        tree.cophenetic(a, b) = nearest;
        tree.cophenetic(b, a) = nearest;
      }
    }
    const Sizes sizes{.first = static_cast<double>(kept.size()),
                      .second = static_cast<double>(joined.size())};
    for (Eigen::Index other = 0; other < m; ++other) {
      if (other != first) {
        d(first, other) = joined_distance(linkage, sizes, d(first, other), d(second, other));
        d(other, first) = d(first, other);
      }
    }
    kept.insert(kept.end(), joined.begin(), joined.end());
    joined.clear();
    tree.joins.push_back({.first = static_cast<std::size_t>(first),
                          .second = static_cast<std::size_t>(second),
                          .height = nearest});
  }
  tree.cophenetic_correlation = correlation(tree.cophenetic, dissimilarities);
  return tree;
}

}  // namespace asperity
