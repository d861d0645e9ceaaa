// Majorisation of stress, and the disparities between its steps.

#include "analysis/dissimilarity/multidimensional_scaling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/isotonic_regression.h"

namespace asperity {
namespace {

struct JudgedPair {
  Eigen::Index i = 0;
  Eigen::Index j = 0;
  double delta = 0.0;
  double weight = 0.0;
};

void refuse_impossible_weights(const WeightedDissimilarities& given) {
  const Eigen::MatrixXd& w = given.weights;
  if (w.size() == 0) return;
  if (w.rows() != given.values.rows() || w.cols() != given.values.cols() || !w.allFinite() ||
      w.minCoeff() < 0.0 || w != w.transpose()) {
    throw std::invalid_argument(
        "weights must be finite, symmetric, at least 0, and as many as dissimilarities");
  }
}

Eigen::MatrixXd all_weights(const WeightedDissimilarities& given) {
  Eigen::MatrixXd w = given.weights.size() > 0
                          ? given.weights
                          : Eigen::MatrixXd::Ones(given.values.rows(), given.values.cols());
  w.diagonal().setZero();
  return w;
}

/// By ascending dissimilarity.
std::vector<JudgedPair> judged_pairs(const Dissimilarities& values,
                                     const Eigen::MatrixXd& weights) {
  std::vector<JudgedPair> pairs{};
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < values.cols(); ++j) {
      if (weights(i, j) > 0.0)
        pairs.push_back({.i = i, .j = j, .delta = values(i, j), .weight = weights(i, j)});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const JudgedPair& a, const JudgedPair& b) { return a.delta < b.delta; });
  return pairs;
}

/// Stress-1 and its disparities for given distances of the pairs, which are in ascending order of dissimilarity. Its loops use pointers
/// and its memory is kept: a permutation test calls it millions of times.
class Disparities {
 public:
  Disparities(const std::vector<JudgedPair>& pairs, ScalingLevel level)
      : pairs_(pairs),
        level_(level),
        fitted_(pairs.size()),
        order_(pairs.size()),
        ordered_(pairs.size()),
        weights_(pairs.size()),
        regression_(pairs.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t first = 0; first < pairs.size();) {
      std::size_t end = first + 1;
      while (end < pairs.size() && pairs[end].delta == pairs[first].delta) ++end;
      if (end > first + 1) ties_.push_back({.first = first, .end = end});
      first = end;
    }
  }

  const std::vector<double>& fitted() const { return fitted_; }
  /// Σ w·d̂².
  double square() const { return square_; }

  double fit(const std::vector<double>& distances) {
    switch (level_) {
      case ScalingLevel::ratio:
        fit_ratio(distances);
        break;
      case ScalingLevel::ordinal:
        fit_order(distances);
        break;
    }
    const std::size_t number = pairs_.size();
    const JudgedPair* const pairs = pairs_.data();
    const double* const d = distances.data();
    const double* const fitted = fitted_.data();
    double residual = 0.0;
    double total = 0.0;
    double square = 0.0;
    for (std::size_t p = 0; p < number; ++p) {
      const double difference = d[p] - fitted[p];
      residual += pairs[p].weight * difference * difference;
      total += pairs[p].weight * d[p] * d[p];
      square += pairs[p].weight * fitted[p] * fitted[p];
    }
    square_ = square;
    return total > 0.0 ? std::sqrt(residual / total) : 1.0;
  }

 private:
  /// b = Σ w·δ·d/Σ w·δ², the least squares of d on δ.
  void fit_ratio(const std::vector<double>& distances) {
    double product = 0.0;
    double square = 0.0;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      product += pairs_[p].weight * pairs_[p].delta * distances[p];
      square += pairs_[p].weight * pairs_[p].delta * pairs_[p].delta;
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) fitted_[p] = product / square * pairs_[p].delta;
  }

  /// Ties of δ are put in the order of their distances, so that the regression never pools them only for being equal. The order
  /// of the last distances is nearly that of the next ones.
  void fit_order(const std::vector<double>& distances) {
    const auto is_before = [&distances](std::size_t a, std::size_t b) {
      return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
    };
    for (const Tie& tie : ties_) {
      const auto first = order_.begin() + static_cast<std::ptrdiff_t>(tie.first);
      const auto end = order_.begin() + static_cast<std::ptrdiff_t>(tie.end);
      if (!std::is_sorted(first, end, is_before)) std::sort(first, end, is_before);
    }
    const std::size_t number = order_.size();
    const std::size_t* const order = order_.data();
    const JudgedPair* const pairs = pairs_.data();
    const double* const d = distances.data();
    double* const ordered = ordered_.data();
    double* const weights = weights_.data();
    for (std::size_t k = 0; k < number; ++k) {
      ordered[k] = d[order[k]];
      weights[k] = pairs[order[k]].weight;
    }
    regression_.fit(ordered_, weights_, ordered_);
    double* const fitted = fitted_.data();
    for (std::size_t k = 0; k < number; ++k) fitted[order[k]] = ordered[k];
  }

  struct Tie {
    std::size_t first = 0;
    std::size_t end = 0;
  };

  const std::vector<JudgedPair>& pairs_;
  ScalingLevel level_;
  double square_ = 0.0;
  std::vector<double> fitted_;
  std::vector<std::size_t> order_;
  std::vector<double> ordered_;
  std::vector<double> weights_;
  std::vector<Tie> ties_{};
  IsotonicRegression regression_;
};

/// The coordinates of m items on a number of axes that is known to the compiler (2 or 3) or Eigen::Dynamic.
template <int kAxes>
using Points = Eigen::Matrix<double, Eigen::Dynamic, kAxes,
                             kAxes == Eigen::Dynamic ? static_cast<int>(Eigen::ColMajor)
                                                     : static_cast<int>(Eigen::RowMajor)>;

template <int kAxes>
void find_distances(const std::vector<JudgedPair>& pairs, const Points<kAxes>& points,
                    std::vector<double>& distances) {
  const std::size_t number = pairs.size();
  const JudgedPair* const pair = pairs.data();
  const double* const x = points.data();
  double* const d = distances.data();
  const Eigen::Index axes = points.cols();
  const Eigen::Index next_item = points.rowStride();
  const Eigen::Index next_axis = points.colStride();
  for (std::size_t p = 0; p < number; ++p) {
    const double* const first = x + pair[p].i * next_item;
    const double* const second = x + pair[p].j * next_item;
    double square = 0.0;
    for (Eigen::Index axis = 0; axis < axes; ++axis) {
      const double apart = first[axis * next_axis] - second[axis * next_axis];
      square += apart * apart;
    }
    d[p] = square;
  }
  Eigen::Map<Eigen::ArrayXd> all(d, static_cast<Eigen::Index>(number));
  all = all.sqrt();
}

std::vector<double> distances_of_pairs(const std::vector<JudgedPair>& pairs,
                                       const Eigen::MatrixXd& points) {
  std::vector<double> distances(pairs.size());
  find_distances<Eigen::Dynamic>(pairs, points, distances);
  return distances;
}

/// V⁺ = (V + 11ᵀ/m)⁻¹ − 11ᵀ/m, for a V whose null space is that of the constant vectors alone.
Eigen::MatrixXd inverse_of_weights(const Eigen::MatrixXd& weights) {
  const Eigen::Index m = weights.rows();
  Eigen::MatrixXd v = -weights;
  v.diagonal() = weights.rowwise().sum();
  const Eigen::MatrixXd constant = Eigen::MatrixXd::Constant(m, m, 1.0 / static_cast<double>(m));
  return SymmetricFactors(v + constant).inverse() - constant;
}

/// One fit: its configuration Y, and the steps to the next ones.
template <int kAxes>
class Descent {
 public:
  Descent(const std::vector<JudgedPair>& pairs, const Eigen::MatrixXd& inverse,
          const Eigen::MatrixXd& start)
      : pairs_(pairs),
        inverse_(inverse),
        points_(start),
        pulled_(start.rows(), start.cols()),
        pulls_(pairs.size()),
        distances_(pairs.size()) {
    find_distances<kAxes>(pairs_, points_, distances_);
  }

  const Points<kAxes>& points() const { return points_; }
  const std::vector<double>& distances() const { return distances_; }

  /// V⁺·B(Y)·Y, with the disparities multiplied by the factor.
  void step(const std::vector<double>& disparities, double factor) {
    pull(disparities, factor);
    multiply();
    find_distances<kAxes>(pairs_, points_, distances_);
  }

 private:
  void pull(const std::vector<double>& disparities, double factor) {
    const std::size_t number = pairs_.size();
    const JudgedPair* const pair = pairs_.data();
    const double* const disparity = disparities.data();
    const double* const d = distances_.data();
    double* const b = pulls_.data();
    for (std::size_t p = 0; p < number; ++p) b[p] = pair[p].weight * factor * disparity[p] / d[p];
    const Eigen::Index axes = points_.cols();
    const Eigen::Index next_item = points_.rowStride();
    const Eigen::Index next_axis = points_.colStride();
    const double* const x = points_.data();
    pulled_.setZero();
    double* const by = pulled_.data();
    for (std::size_t p = 0; p < number; ++p) {
      if (!(d[p] > 0.0)) continue;
      const Eigen::Index first = pair[p].i * next_item;
      const Eigen::Index second = pair[p].j * next_item;
      for (Eigen::Index axis = 0; axis < axes; ++axis) {
        const Eigen::Index offset = axis * next_axis;
        const double pull = b[p] * (x[first + offset] - x[second + offset]);
        by[first + offset] += pull;
        by[second + offset] -= pull;
      }
    }
  }

  /// With two or three axes, Eigen takes as long to prepare the product as to compute it. The order of the sums is Eigen's.
  void multiply() {
    if constexpr (kAxes == Eigen::Dynamic) {
      points_.noalias() = inverse_ * pulled_;
    } else {
      const Eigen::Index items = points_.rows();
      const double* const by = pulled_.data();
      for (Eigen::Index i = 0; i < items; ++i) {
        const double* const row = inverse_.data() + i;
        std::array<double, kAxes> sum{};
        for (Eigen::Index k = 0; k < items; ++k) {
          for (std::size_t axis = 0; axis < kAxes; ++axis)
            sum[axis] += row[k * items] * by[k * kAxes + static_cast<Eigen::Index>(axis)];
        }
        std::copy(sum.begin(), sum.end(), points_.data() + i * kAxes);
      }
    }
  }

  const std::vector<JudgedPair>& pairs_;
  const Eigen::MatrixXd& inverse_;
  Points<kAxes> points_;
  Points<kAxes> pulled_;
  std::vector<double> pulls_;
  std::vector<double> distances_;
};

/// The fit of one set of pairs from any start.
class Majorisation {
 public:
  Majorisation(const Dissimilarities& values, const Eigen::MatrixXd& weights, ScalingLevel level)
      : pairs_(judged_pairs(values, weights)),
        inverse_(inverse_of_weights(weights)),
        level_(level) {
    for (const JudgedPair& pair : pairs_) square_ += pair.weight * pair.delta * pair.delta;
    if (!(square_ > 0.0)) {
      throw std::invalid_argument(
          "dissimilarities: all judged pairs have the dissimilarity 0; at least one must be above "
          "0");
    }
    for (const JudgedPair& pair : pairs_) weight_ += pair.weight;
  }

  struct Limits {
    std::size_t steps = 0;
    double change = 0.0;
  };
  Configuration from(const Eigen::MatrixXd& start, const Limits& limits) const {
    switch (start.cols()) {
      case 2:
        return descended<2>(start, limits);
      case 3:
        return descended<3>(start, limits);
      default:
        return descended<Eigen::Dynamic>(start, limits);
    }
  }

  /// In the unit that Configuration::points states.
  void finish(Configuration& made) const {
    const std::vector<double> distances = distances_of_pairs(pairs_, made.points);
    double of_distances = 0.0;
    double product = 0.0;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      of_distances += pairs_[p].weight * distances[p] * distances[p];
      product += pairs_[p].weight * pairs_[p].delta * distances[p];
    }
    const double factor =
        level_ == ScalingLevel::ratio ? product / of_distances : std::sqrt(weight_ / of_distances);
    made.points = along_principal_axes(factor * made.points);
  }

 private:
  /// The disparities are brought to Σ w·d̂² = Σ w before each step: without that, their regression on the distances would shrink
  /// the configuration towards a point.
  template <int kAxes>
  Configuration descended(const Eigen::MatrixXd& start, const Limits& limits) const {
    Disparities disparities(pairs_, level_);
    Descent<kAxes> descent(pairs_, inverse_, start);
    Configuration made{.stress_1 = disparities.fit(descent.distances()), .converged = false};
    for (std::size_t taken = 0; taken < limits.steps; ++taken) {
      const double square = disparities.square();
      descent.step(disparities.fitted(), square > 0.0 ? std::sqrt(weight_ / square) : 1.0);
      const double stress = disparities.fit(descent.distances());
      const double change = made.stress_1 - stress;
      made.stress_1 = stress;
      if (std::abs(change) < limits.change) {
        made.converged = true;
        break;
      }
    }
    made.points = descent.points();
    return made;
  }

  std::vector<JudgedPair> pairs_{};
  Eigen::MatrixXd inverse_{};
  ScalingLevel level_ = ScalingLevel::ordinal;
  double square_ = 0.0;
  double weight_ = 0.0;
};

/// Pairs without a judgement get the shortest way over judged ones, which is what their distance cannot exceed.
Dissimilarities completed(const Dissimilarities& values, const Eigen::MatrixXd& weights) {
  Dissimilarities d = values;
  const Eigen::Index m = d.rows();
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j) {
      if (i != j && !(weights(i, j) > 0.0)) d(i, j) = std::numeric_limits<double>::infinity();
    }
  }
  for (Eigen::Index over = 0; over < m; ++over) {
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index j = 0; j < m; ++j) {
        if (!(weights(i, j) > 0.0) && i != j) d(i, j) = std::min(d(i, j), d(i, over) + d(over, j));
      }
    }
  }
  // Rounding of the two directions of a sum may differ.
  return d.cwiseMin(d.transpose());
}

constexpr Majorisation::Limits kSearch{.steps = 400, .change = 1e-8};
constexpr Majorisation::Limits kFinal{.steps = 50'000, .change = 1e-13};
constexpr Majorisation::Limits kFromNear{.steps = 1000, .change = 1e-8};

}  // namespace

bool connects_all_items(const Eigen::MatrixXd& weights) {
  const Eigen::Index m = weights.rows();
  std::vector<bool> is_reached(static_cast<std::size_t>(m));
  std::vector<Eigen::Index> next{0};
  if (m > 0) is_reached[0] = true;
  std::size_t reached = 0;
  while (!next.empty()) {
    const Eigen::Index item = next.back();
    next.pop_back();
    ++reached;
    for (Eigen::Index other = 0; other < m; ++other) {
      if (!(weights(item, other) > 0.0) || is_reached[static_cast<std::size_t>(other)]) continue;
      is_reached[static_cast<std::size_t>(other)] = true;
      next.push_back(other);
    }
  }
  return reached == static_cast<std::size_t>(m);
}

Dissimilarities distances_between(const Eigen::MatrixXd& points) {
  Dissimilarities d = Dissimilarities::Zero(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      d(i, j) = (points.row(i) - points.row(j)).norm();
      d(j, i) = d(i, j);
    }
  }
  return d;
}

Eigen::MatrixXd along_principal_axes(const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd centred = points.rowwise() - points.colwise().mean();
  const EigenAxes axes = eigen_axes(centred.transpose() * centred);
  Eigen::MatrixXd turned = centred * axes.vectors.rowwise().reverse();
  for (Eigen::Index axis = 0; axis < turned.cols(); ++axis) {
    Eigen::Index largest = 0;
    turned.col(axis).cwiseAbs().maxCoeff(&largest);
    if (turned(largest, axis) < 0.0) turned.col(axis) *= -1.0;
  }
  return turned;
}

Configuration scaled(const WeightedDissimilarities& given, const ScalingQuestion& question,
                     const Random& random) {
  refuse_impossible_weights(given);
  const Eigen::MatrixXd weights = all_weights(given);
  const Eigen::Index m = given.values.rows();
  if (question.dimensions < 1 || question.dimensions >= m) {
    throw std::invalid_argument("dimensions is " + std::to_string(question.dimensions) +
                                "; it must be at least 1 and below the number of items, " +
                                std::to_string(m));
  }
  if (!connects_all_items(weights)) {
    throw std::invalid_argument(
        "weights: the judged pairs do not connect all items; judge further pairs");
  }
  // Refuses impossible dissimilarities, too.
  const Eigen::MatrixXd classical =
      classical_scaling(completed(given.values, weights), question.dimensions).points;
  const Majorisation fit(given.values, weights, question.level);
  // A coordinate that is 0 for all items stays 0 in every step.
  Random spread = random.split("spread of a flat start");
  Eigen::MatrixXd first = classical;
  const double reach = std::max(classical.cwiseAbs().maxCoeff(), 1e-3);
  for (Eigen::Index axis = 0; axis < first.cols(); ++axis) {
    if (first.col(axis).cwiseAbs().maxCoeff() > 0.0) continue;
    for (Eigen::Index i = 0; i < m; ++i) first(i, axis) = 0.1 * reach * spread.normal();
  }
  Configuration best = fit.from(first, kSearch);
  for (std::size_t start = 0; start < question.random_starts; ++start) {
    Random draws = random.split(static_cast<std::uint64_t>(start));
    Eigen::MatrixXd points(m, question.dimensions);
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index axis = 0; axis < points.cols(); ++axis) points(i, axis) = draws.normal();
    }
    Configuration made = fit.from(points, kSearch);
    if (made.stress_1 < best.stress_1 - 1e-9) best = std::move(made);
  }
  best = fit.from(best.points, kFinal);
  fit.finish(best);
  return best;
}

Configuration scaled_from(const Eigen::MatrixXd& start, const WeightedDissimilarities& given,
                          ScalingLevel level) {
  refuse_impossible_weights(given);
  const Majorisation fit(given.values, all_weights(given), level);
  Configuration made = fit.from(start, kFromNear);
  fit.finish(made);
  return made;
}

std::vector<ShepardPoint> shepard_diagram(const WeightedDissimilarities& given,
                                          const Eigen::MatrixXd& points, ScalingLevel level) {
  refuse_impossible_weights(given);
  const std::vector<JudgedPair> pairs = judged_pairs(given.values, all_weights(given));
  const std::vector<double> distances = distances_of_pairs(pairs, points);
  Disparities disparities(pairs, level);
  disparities.fit(distances);
  std::vector<ShepardPoint> diagram{};
  diagram.reserve(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    diagram.push_back({.first = pairs[p].i,
                       .second = pairs[p].j,
                       .dissimilarity = pairs[p].delta,
                       .distance = distances[p],
                       .disparity = disparities.fitted()[p]});
  }
  return diagram;
}

}  // namespace asperity
