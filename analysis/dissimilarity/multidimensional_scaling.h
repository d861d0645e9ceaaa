// Multidimensional scaling by majorisation: the configuration whose distances fit dissimilarities best.

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "analysis/dissimilarity/dissimilarity.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// The dissimilarities δ of pairs of m items, and how much each of them counts. A pair that was not judged has the
/// weight 0.
struct WeightedDissimilarities {
  Dissimilarities values{};   ///< δ, symmetric
  Eigen::MatrixXd weights{};  ///< w, symmetric and at least 0; empty: 1 for every pair
};

/// Which function of the dissimilarities the distances are compared with.
enum class ScalingLevel {
  ratio,  ///< b·δ: metric scaling
  /// Any nondecreasing function, by isotonic regression: non-metric scaling. Pairs with equal dissimilarities may have
  /// different disparities (Kruskal's primary approach to ties).
  ordinal,
};

/// SMACOF [DeLeeuw 1977] [Borg 2005]. With d_ij the Euclidean distances of the configuration X and d̂_ij the
/// disparities (functions of δ_ij as ScalingLevel states), it decreases Σ w·(d̂ − d)². For fixed disparities the stress is majorised by a
/// quadratic function of X that touches it at the current configuration Y (Cauchy–Schwarz: d_ij(X)·d_ij(Y) ≥
/// (x_i − x_j)·(y_i − y_j)), whose minimum is
///
///     X = V⁺·B(Y)·Y,   b_ij = −w_ij·d̂_ij/d_ij(Y),   b_ii = −Σ_j≠i b_ij,   v_ij = −w_ij,   v_ii = Σ_j≠i w_ij,
///
/// so that no step increases the stress. Steps are repeated until the stress changes by less than 10⁻¹².
///
/// Stress-1 [Kruskal 1964] = √(Σ w·(d − d̂)²/Σ w·d²), with the disparities that minimise it. 0 is a perfect fit. It does not depend
/// on the unit of δ.
///
/// The stress has local minima: the smallest of several starts is returned, the first of which is classical scaling and
/// the others random. In one dimension minima are so many that the smallest may be missed.
///
/// [DeLeeuw 1977] de Leeuw: Applications of convex analysis to multidimensional scaling.
/// [Borg 2005] Borg, Groenen: Modern Multidimensional Scaling, chapters 8 and 9.
/// [Kruskal 1964] Kruskal: Multidimensional scaling by optimizing goodness of fit to a nonmetric hypothesis.
struct Configuration {
  /// m × R, centred, along its principal axes in descending order of their variance; the largest coordinate of an axis is
  /// positive. Of the ratio level in the unit of δ, of the ordinal one with a mean square distance of 1. Otherwise
  /// rotation, reflection and position cannot be interpreted.
  Eigen::MatrixXd points{};
  double stress_1 = 0.0;
  bool converged = true;  ///< otherwise the limit of steps ended the fit
};

struct ScalingQuestion {
  Eigen::Index dimensions = 2;
  ScalingLevel level = ScalingLevel::ordinal;
  std::size_t random_starts = 20;
};

/// Throws std::invalid_argument for impossible dissimilarities or weights, for dimensions that are not below the number
/// of items, where the judged pairs do not connect all items, and where all dissimilarities are 0.
Configuration scaled(const WeightedDissimilarities& given, const ScalingQuestion& question = {},
                     const Random& random = Random(kSeedOfTests));

/// From a start of m × R alone, for data that resemble those that the start was fitted to.
Configuration scaled_from(const Eigen::MatrixXd& start, const WeightedDissimilarities& given,
                          ScalingLevel level);

/// The points of a Shepard diagram: a row per judged pair, by ascending dissimilarity.
struct ShepardPoint {
  Eigen::Index first = 0;
  Eigen::Index second = 0;
  double dissimilarity = 0.0;
  double distance = 0.0;
  double disparity = 0.0;  ///< d̂, that minimises the stress-1 of these distances
};
std::vector<ShepardPoint> shepard_diagram(const WeightedDissimilarities& given,
                                          const Eigen::MatrixXd& points, ScalingLevel level);

/// Whether pairs with a weight connect all items, so that a configuration exists.
bool connects_all_items(const Eigen::MatrixXd& weights);

/// The number of items for R dimensions below which non-metric configurations are poorly determined: 4·R + 1
/// [Kruskal 1978].
///
/// [Kruskal 1978] Kruskal, Wish: Multidimensional Scaling.
constexpr Eigen::Index items_for(Eigen::Index dimensions) { return 4 * dimensions + 1; }

/// The Euclidean distances of the rows.
Dissimilarities distances_between(const Eigen::MatrixXd& points);

/// The same configuration, centred, along its principal axes, with the signs of Configuration::points.
Eigen::MatrixXd along_principal_axes(const Eigen::MatrixXd& points);

}  // namespace asperity
