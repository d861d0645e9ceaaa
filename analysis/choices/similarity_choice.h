// Confusions taken apart into similarity of the stimuli and bias of the answers.

#pragma once

#include <optional>

#include <Eigen/Core>

#include "analysis/choices/confusion.h"

namespace asperity {

/// Luce's similarity choice model [Luce 1963]:
///
///   P(answer j | stimulus i) = b_j·η_ij / Σ_k b_k·η_ik,  η_ij = η_ji, η_ii = 1, Σb = 1.
///
/// It is the log-linear model of quasi-symmetry, so its maximum likelihood reproduces the sums of
/// rows, of columns and of every pair n_ij + n_ji: iterative proportional fitting, begun at the
/// symmetric table (which is in the model), scales to these in turn until no cell moves by 10⁻¹⁴ of
/// the trials, or 20 000 times. η and b are read from the fitted cells; η > 1 means that two
/// stimuli are taken for each other more often than for themselves, and is legal.
///
/// Where a pair was never confused or a stimulus never recognised, the maximum does not exist in
/// the interior: ½ is added to every cell, and `added` says so.
///
/// [Luce 1963] Luce: Detection and recognition.
struct SimilarityChoice {
  double added = 0.0;         ///< to every cell before the fit: 0 or ½
  double G2 = 0.0;            ///< deviance
  double X2 = 0.0;            ///< Pearson's statistic
  double df = 0.0;            ///< (m−1)(m−2)/2
  std::optional<double> p{};  ///< of G2
  /// Absent where the fit runs to the edge of the model: a fitted cell went to zero.
  struct Parameters {
    Eigen::MatrixXd similarity{};  ///< η
    Eigen::VectorXd bias{};        ///< b
  };
  std::optional<Parameters> parameters{};
};

/// Throws std::invalid_argument as confusion.h does.
SimilarityChoice similarity_choice(const ConfusionCounts& counts);

}  // namespace asperity
