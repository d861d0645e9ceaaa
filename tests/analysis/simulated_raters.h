// Raters whose judgements follow the distances of a known configuration.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "analysis/dissimilarity/rated_dissimilarities.h"
#include "analysis/numbers/random.h"

namespace asperity {

/// A rater judges (d/d_max)^p + ε on a scale from 0 to 1, d being the distances of the configuration after the axes were
/// stretched by √w. ln w of every axis ~ N(0, weight_log_sd²) and ln p ~ N(0, power_log_sd²) are properties of a rater;
/// ε ~ N(0, noise²) is that of a judgement, which cannot leave the scale.
struct SimulatedRaters {
  std::size_t number = 10;
  double weight_log_sd = 0.25;
  double power_log_sd = 0.25;
  double noise = 0.2;
  bool guess = false;  ///< a uniform number on the scale instead
};

/// Uniformly distributed in a square.
inline Eigen::MatrixXd drawn_plane(Eigen::Index items, Random random) {
  Eigen::MatrixXd points(items, 2);
  for (Eigen::Index i = 0; i < items; ++i) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) points(i, axis) = 2.0 * random.uniform() - 1.0;
  }
  return points;
}

inline std::vector<RatedPairs> judged_by(const SimulatedRaters& raters,
                                         const Eigen::MatrixXd& points, const Random& random) {
  const double largest = distances_between(points).maxCoeff();
  std::vector<RatedPairs> made{};
  for (std::size_t s = 0; s < raters.number; ++s) {
    Random draws = random.split(static_cast<std::uint64_t>(s));
    const double power = std::exp(raters.power_log_sd * draws.normal());
    Eigen::MatrixXd stretched = points;
    for (Eigen::Index axis = 0; axis < points.cols(); ++axis)
      stretched.col(axis) *= std::sqrt(std::exp(raters.weight_log_sd * draws.normal()));
    const Dissimilarities distances = distances_between(stretched);
    RatedPairs own{.values = Dissimilarities::Zero(points.rows(), points.rows())};
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      for (Eigen::Index j = i + 1; j < points.rows(); ++j) {
        const double felt = std::pow(distances(i, j) / largest, power);
        own.values(i, j) = raters.guess
                               ? draws.uniform()
                               : std::clamp(felt + raters.noise * draws.normal(), 0.0, 1.0);
        own.values(j, i) = own.values(i, j);
      }
    }
    made.push_back(std::move(own));
  }
  return made;
}

}  // namespace asperity
