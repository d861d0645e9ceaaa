// How unlike stimuli are, from their confusions; maps and trees of it.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/choices/confusion.h"

namespace asperity {

/// Symmetric, zero on the diagonal, nothing negative. Every function on dissimilarities throws
/// std::invalid_argument unless they are so and of at least two items.
using Dissimilarities = Eigen::MatrixXd;

/// Both of the counts plus ½, as conditional probabilities p_ij of answer j to stimulus i.
/// Shepard's max(0, −½·ln(p_ij·p_ji/(p_ii·p_jj))) [Shepard 1957]: what is confused more often than
/// recognised would be nearer than itself, and stands at 0.
Dissimilarities shepard_dissimilarities(const ConfusionCounts& counts);
/// 1 − (p_ij + p_ji)/2.
Dissimilarities linear_dissimilarities(const ConfusionCounts& counts);

/// Classical scaling [Torgerson 1952]: eigenvalues and -vectors of −½·J·D²·J, J = I − 11ᵀ/m.
/// Signs and rotation of the map mean nothing; compare its distances only. Negative eigenvalues
/// say that no map shows the dissimilarities exactly.
///
/// [Shepard 1957] Shepard: Stimulus and response generalization.
/// [Torgerson 1952] Torgerson: Multidimensional scaling: I. Theory and method.
struct ClassicalScaling {
  Eigen::VectorXd eigenvalues{};  ///< decreasing
  /// m × `dimensions`; a coordinate whose eigenvalue is not positive is 0
  Eigen::MatrixXd points{};
  /// Σ of the positive among the first `dimensions` eigenvalues, over Σ|λ| and over Σmax(λ, 0).
  /// Absent where all eigenvalues are 0.
  std::optional<double> fit_of_absolute{};
  std::optional<double> fit_of_positive{};
  /// Whether the first three eigenvalues differ: where they do not, the plane is arbitrary.
  bool plane_is_unique = false;
};
/// Throws std::invalid_argument for less than one dimension and for more than items.
ClassicalScaling classical_scaling(const Dissimilarities& dissimilarities,
                                   Eigen::Index dimensions = 2);

/// What a joined cluster's distance to another is: mean over all pairs of members, the greatest, or
/// the least.
enum class Linkage { average, complete, single };

/// A tree by agglomeration: the nearest two clusters join, again and again; distances follow from
/// Lance and Williams' recurrence. Of equally near pairs the one with the lowest first and then the
/// lowest second index joins, so the tree of tied dissimilarities is one of several.
struct Tree {
  struct Join {
    std::size_t first = 0;  ///< an item of either cluster, the lowest
    std::size_t second = 0;
    double height = 0.0;
  };
  std::vector<Join> joins{};     ///< m − 1, in order
  Eigen::MatrixXd cophenetic{};  ///< height at which two items first stand together
  /// Pearson's correlation of cophenetic with original distances; absent where either are all
  /// equal.
  std::optional<double> cophenetic_correlation{};
};
Tree agglomerate(const Dissimilarities& dissimilarities, Linkage linkage);

}  // namespace asperity
