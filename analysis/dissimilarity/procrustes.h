// Whether two configurations of the same items agree: Procrustes rotation, and its permutation test.

#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// The symmetric Procrustes comparison of two configurations X and Y of the same m items (rows), whose numbers of
/// dimensions may differ. Both are centred and scaled to a sum of squares of 1; Y is rotated, reflected and scaled so that
/// the sum of squared distances to X is least, which is 1 − r² with r = Σσ, the sum of the singular values of XᵀY
/// [Gower 1975]. r² does not depend on which of the two is rotated.
///
/// [Gower 1975] Gower: Generalized Procrustes analysis.
struct Procrustes {
  double r_squared = 0.0;
  /// Y in the frame and unit of X: centred on X's centroid, rotated, reflected and scaled by least squares.
  Eigen::MatrixXd fitted{};
};
/// Nothing where all points of a configuration coincide. Throws std::invalid_argument where the numbers of items
/// differ.
std::optional<Procrustes> procrustes(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y);

/// PROTEST [Jackson 1995]: P(r ≥ the observed one) when the items of Y are permuted at random, the observed order among
/// the permutations. Of m! orders, random ones are drawn.
///
/// [Jackson 1995] Jackson: PROTEST: a PROcrustean randomization TEST of community environment concordance.
struct Protest {
  double r_squared = 0.0;
  double p = 1.0;
  std::size_t drawn = 0;
};
std::optional<Protest> protest(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y,
                               std::size_t draws = 9999, Random random = Random(kSeedOfTests));

/// The direction in a configuration along which a property y of the items increases: the multiple regression of y on the
/// coordinates [Chang 1969]. R² is its coefficient of determination, and p that of random permutations of the property.
///
/// [Chang 1969] Chang, Carroll: How to use PROFIT, a computer program for property fitting by optimizing nonlinear or linear correlation.
struct PropertyFit {
  Eigen::VectorXd direction{};  ///< of length 1, in the frame of the configuration
  double r_squared = 0.0;
  double p = 1.0;
  std::size_t drawn = 0;
};
/// Nothing where the property is constant, and where items are fewer than dimensions + 2.
std::optional<PropertyFit> property_fit(const Eigen::MatrixXd& points,
                                        const Eigen::VectorXd& property, std::size_t draws = 9999,
                                        Random random = Random(kSeedOfTests));

}  // namespace asperity
