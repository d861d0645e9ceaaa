// Which dimensions several scales share: principal components of their correlations.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/random.h"
#include "analysis/seed_of_tests.h"

namespace asperity {

/// The principal components of the correlation matrix R of p scales (columns) on which n items (rows)
/// have values: R = V·Λ·Vᵀ with the eigenvalues λ_1 ≥ … ≥ λ_p ≥ 0 in Λ and orthonormal columns in V.
/// Scales may have different units; all results are dimensionless. Σλ = p, and the components
/// restore R = L·Lᵀ.
///
/// Signs of components are arbitrary; here the loading of the largest absolute value is positive (the
/// first one where several are equal to within 10⁻⁹). Components with equal eigenvalues are an
/// arbitrary basis of their space.
///
/// Source: I. T. Jolliffe: Principal Component Analysis, second edition. Springer, 2002, chapter 2.
struct PrincipalComponents {
  Eigen::VectorXd eigenvalues{};  ///< λ, decreasing; those that only rounding keeps from 0 are 0
  Eigen::VectorXd proportion{};   ///< λ/p: of the variance of all scales
  /// p × p, L = V·√Λ: correlation of a scale (row) with a component (column); 0 where λ is 0.
  Eigen::MatrixXd loadings{};
  /// n × p: Z·V of the standardised values Z (divisor n − 1). The scores of a component have the mean 0
  /// and the variance λ; those of different components are uncorrelated.
  Eigen::MatrixXd scores{};
};

/// The first column that has no variance, for which correlations are not defined.
std::optional<Eigen::Index> constant_column(const Eigen::MatrixXd& values);

/// Nothing where a column is constant. Throws std::invalid_argument for fewer than three rows, fewer
/// than two columns, and a value that is not finite.
std::optional<PrincipalComponents> principal_components(const Eigen::MatrixXd& values);

/// The eigenvalues, decreasing, of the correlation matrix of independent standard normal numbers, drawn
/// row by row. Throws as `principal_components` does.
struct TableSize {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
};
Eigen::VectorXd eigenvalues_of_noise(const TableSize& size, Random random);

/// Parallel analysis: a component is retained if its eigenvalue exceeds what the same component of
/// unrelated scales exceeds with probability 1 − `percentile`, and if all components before it are
/// retained (J. L. Horn: A rationale and test for the number of factors in factor analysis.
/// Psychometrika 30(2), 179–185, 1965, with the mean; the 95th percentile after L. W. Glorfeld: An
/// improvement on Horn's parallel analysis methodology. Educational and Psychological Measurement
/// 55(3), 377–393, 1995).
struct ParallelAnalysis {
  Eigen::VectorXd limits{};  ///< the percentile (type 7) of each component, over the data sets
  Eigen::VectorXd means{};
  std::size_t data_sets = 0;
  std::size_t retained = 0;
};

struct ParallelQuestion {
  std::size_t data_sets = 1000;
  double percentile = 0.95;  ///< in (0, 1)
};

/// For p observed eigenvalues (decreasing) of n rows. Data set i draws from `random.split(i)`, and
/// results do not depend on the order in which data sets are computed: `eigenvalues_of_noise` may be
/// called for each of them in any order by any number of jobs, and `compared_with_noise` has the same
/// bits.
ParallelAnalysis parallel_analysis(const Eigen::VectorXd& eigenvalues, Eigen::Index rows,
                                   const ParallelQuestion& question = {},
                                   Random random = Random(kSeedOfTests));
/// From the eigenvalues of the data sets. Throws std::invalid_argument for none, for other numbers of
/// components than observed, and for an impossible percentile.
ParallelAnalysis compared_with_noise(const Eigen::VectorXd& eigenvalues,
                                     std::span<const Eigen::VectorXd> of_noise,
                                     double percentile = 0.95);

/// Intervals of the components of mean ratings, from participants drawn with replacement. The items are fixed: the
/// intervals generalise to other participants, not to other items.
///
/// The components of each draw are those of its mean table, each reflected so that its loadings have a positive inner
/// product with those of the data (M. E. Timmerman, H. A. L. Kiers, A. K. Smilde: Estimating confidence intervals for
/// principal component loadings: A comparison between the bootstrap and asymptotic results. British Journal of Mathematical
/// and Statistical Psychology 60(2), 295–314, 2007). They are not rotated to each other: components whose eigenvalues are
/// close change places between draws, and have wide intervals. Limits are percentiles (quantiles of type 7).
struct ComponentIntervals {
  Eigen::VectorXd proportion_low{};
  Eigen::VectorXd proportion_high{};
  Eigen::MatrixXd loadings_low{};  ///< as PrincipalComponents::loadings
  Eigen::MatrixXd loadings_high{};
  std::size_t valid = 0;  ///< draws in which every cell has a rating and no scale is constant
};
struct ComponentResampling {
  std::size_t draws = 2000;
  double confidence = 0.95;
};
/// `participants`: a table of items × scales each, NaN where there is no rating. Nothing with fewer than two
/// participants, where the components of all of them are not defined, and where less than nine tenths of the draws are
/// valid. Throws std::invalid_argument for tables of different sizes, and as `principal_components` does.
std::optional<ComponentIntervals> component_intervals(std::span<const Eigen::MatrixXd> participants,
                                                      const ComponentResampling& resampling = {},
                                                      const Random& random = Random(kSeedOfTests));
/// The mean over participants of each cell, over those who have it; NaN where none has.
Eigen::MatrixXd mean_table(std::span<const Eigen::MatrixXd> participants);

}  // namespace asperity
