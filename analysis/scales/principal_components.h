// Which dimensions several scales share: principal components of their correlations.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"
#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

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

/// The components of the items' true means, that is, of means over all participants of whom N are a sample. The items are fixed:
/// intervals do not generalise to other items.
///
/// The components of observed means are biased: the deviations of the participants add the covariances W/N to those of the
/// means, W being the mean products of participants × items
///
///   W_jk = Σ_p Σ_i d_pij·d_pik/((I − 1)·(N − 1)),  d_pij = x_pij − x̄_·ij − x̄_p·j + x̄_··j
///
/// so that correlations, the first proportion and loadings are too small. Here the components are those of the correlations of
/// S − W/N, with the covariances S of the observed means over the I items (the estimate of the items' variance components).
/// Intervals are by the jackknife over participants [Efron 1982]: with θ the statistic of all participants and θ₍ᵢ₎ that without
/// participant i, the pseudo-values ψᵢ = N·θ − (N − 1)·θ₍ᵢ₎ have the standard deviation s, and the limits are θ ∓ t·s/√N with
/// N − 1 degrees of freedom. θ is ln(p/(1 − p)) of a proportion p and artanh of a loading, so that limits remain possible values.
///
/// Components without a participant are reflected so that their loadings have a positive inner product with those of all. They
/// are not rotated to each other: components whose eigenvalues are close change places, and have wide intervals.
///
/// [Efron 1982] Efron: The jackknife, the bootstrap and other resampling plans. SIAM, chapters 2 and 3.
struct ComponentEstimate {
  double corrected = 0.0;
  ConfidenceInterval interval{};
};
struct CorrectedComponents {
  /// By component; nothing where a proportion is not between 0 and 1 for all participants or without one.
  std::vector<std::optional<ComponentEstimate>> proportions{};
  /// By scale and component, [scale][component]; nothing where a loading is not between −1 and 1, or is 0 in an empty component.
  std::vector<std::vector<std::optional<ComponentEstimate>>> loadings{};
};
constexpr std::size_t kFewestForCorrection = 5;
/// `participants`: a table of items × scales each, NaN where there is no rating. Nothing with fewer than kFewestForCorrection
/// participants, where a rating is missing, and where the participants' deviations explain all variance of the means of a scale.
/// Throws std::invalid_argument for tables of different sizes, and for impossible ones as `principal_components` does.
std::optional<CorrectedComponents> corrected_components(
    std::span<const Eigen::MatrixXd> participants, double confidence = 0.95);
/// The mean over participants of each cell, over those who have it; NaN where none has.
Eigen::MatrixXd mean_table(std::span<const Eigen::MatrixXd> participants);

}  // namespace asperity
