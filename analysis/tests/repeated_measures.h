// Analysis of variance where every participant was measured in every cell.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"
#include "analysis/tests/t_test.h"

namespace asperity {

/// What each participant gave in each cell, replicates averaged.
///
/// Cells are the combinations of the within factors' levels, the last factor's running fastest.
/// There may be one between-participants factor.
struct RepeatedMeasures {
  Eigen::MatrixXd y{};                ///< participants × cells
  std::vector<std::size_t> levels{};  ///< of each within factor, at least 2 each
  std::vector<std::size_t> group{};   ///< of each participant; empty without a between factor
  std::size_t groups = 1;
};

/// With unequal groups the two differ in the effects within participants: type 3 tests the mean of
/// the groups' means, type 2 the mean of all participants.
enum class SumsOfSquares { type_2, type_3 };

/// One effect against its error.
///
/// With orthonormal contrasts C of the effect (a product of one matrix per factor), Z = Y·C and the
/// error matrix S = Z'Z about the groups' means: SS are traces, q the number of contrasts,
///
///   GG = tr(S)²/(q·tr(S²)),  HF = ((N' )·q·GG − 2)/(q·(f − q·GG)),  bound 1/q,
///
/// f the degrees of freedom of a single contrast's error, N' = f + 1 [Lecoutre 1991] or N
/// [Huynh 1976]; these agree without groups. p values of HF take the former, at most 1.
///
/// Mauchly's W = |S|/(tr(S)/q)^q, X² = −f·(1 − (2q² + q + 2)/(6qf))·ln W. Its p is given to first
/// order, to second order [Anderson 2003], and as R computes the second order: with the number of
/// cells where the formula has that of contrasts; not to be copied. With f < q W is not defined,
/// though GG is.
///
/// pes = SS/(SS + error), ges = SS/(SS + all errors) [Bakeman 2005]; `ges_observed` for a between
/// factor that was measured and not manipulated; ω² = (SS − df1·MSE)/(SS + error + MSE).
///
/// [Lecoutre 1991] Lecoutre: A correction for the ε̃ approximate test in repeated measures designs
/// with two or more independent groups. [Huynh 1976] Huynh, Feldt: Estimation of the Box correction.
/// [Anderson 2003] Anderson: An introduction to multivariate statistical analysis.
/// [Bakeman 2005] Bakeman: Recommended effect size statistics for repeated measures designs.
struct AnovaEffect {
  std::vector<std::size_t> within{};  ///< factors in it, ascending
  bool between = false;               ///< whether the between factor is in it
  double sum_of_squares = 0.0;
  double error_sum_of_squares = 0.0;
  double df1 = 0.0;
  double df2 = 0.0;
  std::optional<double> F{};
  std::optional<double> p{};
  std::optional<double> pes{};
  std::optional<double> ges{};
  std::optional<double> ges_observed{};  ///< with a between factor only
  std::optional<double> omega2{};
  /// With two contrasts or more.
  struct Sphericity {
    std::optional<double> gg{};
    double lower_bound = 0.0;
    std::optional<double> hf_lecoutre{};
    std::optional<double> hf_original{};
    std::optional<double> p_gg{};
    std::optional<double> p_hf{};
    std::optional<double> p_lower_bound{};
    struct Mauchly {
      double W = 0.0;
      double chi_squared = 0.0;
      double df = 0.0;
      std::optional<double> p_first_order{};
      std::optional<double> p_second_order{};
      std::optional<double> p_as_r{};
    };
    std::optional<Mauchly> mauchly{};
  };
  std::optional<Sphericity> sphericity{};
};

struct AnovaTable {
  /// Between, then within effects by number of factors, each followed by its interaction with the
  /// between factor.
  std::vector<AnovaEffect> effects{};
  double all_errors = 0.0;  ///< sum of squares of all error strata, the participants' included
};

/// Throws std::invalid_argument when `y` is no such table, a group is empty, or there are no more
/// participants than groups.
AnovaTable repeated_measures_anova(const RepeatedMeasures& data,
                                   SumsOfSquares type = SumsOfSquares::type_3);

/// Means of cells over the participants of one group (all without a between factor), with half
/// widths of t intervals: of the mean, and of the mean with the participants' own levels removed,
/// widened by √(J/(J−1)) for J cells [Cousineau 2005, Morey 2008], to compare cells by eye. No half
/// widths for a single participant.
///
/// [Cousineau 2005] Cousineau: Confidence intervals in within-subject designs. [Morey 2008] Morey:
/// Confidence intervals from normalized data: a correction to Cousineau (2005).
struct CellMeans {
  Eigen::VectorXd mean{};
  std::optional<Eigen::VectorXd> half_width{};
  std::optional<Eigen::VectorXd> within_half_width{};
};
CellMeans cell_means(const Eigen::MatrixXd& y, double confidence = 0.95);

/// Each participant's mean at each level of one within factor.
Eigen::MatrixXd marginal_means(const RepeatedMeasures& data, std::size_t factor);

/// Orthonormal polynomials of degree 1 to `degrees` on unequal levels, one per column, with
/// positive leading coefficients. Throws std::invalid_argument unless there are more different
/// levels than degrees.
Eigen::MatrixXd orthonormal_polynomials(const Eigen::VectorXd& levels, std::size_t degrees);

}  // namespace asperity
