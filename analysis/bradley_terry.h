// Abilities of items from comparisons of two.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/conditional_logit.h"

namespace asperity {

/// One comparison, items by number.
struct Comparison {
  std::size_t participant = 0;
  std::size_t first = 0;  ///< presented first
  std::size_t second = 0;
  std::optional<std::size_t> winner{};  ///< nothing for a tie
  std::size_t times = 1;                ///< how often the participant judged so
};

/// How often each of K items won against each other one, and how often they tied.
struct Comparisons {
  Eigen::MatrixXd wins{};  ///< (winner, loser)
  Eigen::MatrixXd ties{};  ///< symmetric: each tie stands in both places
};

/// Throws std::invalid_argument for an item beyond K, one compared with itself, and a winner that
/// was not compared.
Comparisons count_comparisons(std::span<const Comparison> comparisons, std::size_t items);

/// Abilities λ with P(i before j) = 1/(1 + exp(λ_j − λ_i)) [Bradley 1952]. The first item has λ = 0;
/// `covariance` is K × K with zeros for it. Differences do not depend on that choice.
///
/// [Bradley 1952] Bradley, Terry: Rank analysis of incomplete block designs: the method of paired
/// comparisons.
struct Abilities {
  Eigen::VectorXd value{};
  Eigen::MatrixXd covariance{};

  Eigen::VectorXd standard_error() const;
  /// The same scale with its mean at 0.
  Abilities about_mean() const;
  /// exp(λ)/Σ exp(λ).
  Eigen::VectorXd worth() const;
};

/// K × K: takes values to the same with their mean at 0.
Eigen::MatrixXd centring(Eigen::Index items);

struct BradleyTerry {
  Abilities abilities{};
  Abilities clustered{};  ///< the same; their covariance with participants as clusters (CR0)
  /// Of `abilities.about_mean()`, participants as clusters; empty for too few (`clustered_errors`).
  std::vector<ClusteredError> centred_errors{};
  double deviance = 0.0;          ///< against a probability for each pair
  std::size_t df = 0;             ///< compared pairs − (K − 1)
  double likelihood_ratio = 0.0;  ///< against equal abilities, K − 1 degrees of freedom
  /// The log odds that being presented first adds; nothing where it cannot be told from abilities.
  struct Order {
    double advantage = 0.0;
    double standard_error = 0.0;
    double likelihood_ratio = 0.0;  ///< against none, 1 degree of freedom
  };
  std::optional<Order> order{};
};

/// Ties are left out. Nothing unless the wins connect every item with every other in both directions
/// (`strongly_connected`).
std::optional<BradleyTerry> bradley_terry(std::span<const Comparison> comparisons,
                                          std::size_t items);

/// Firth's estimate, which takes the first-order bias away and is finite whoever wins always: the
/// likelihood times √det(information) [Firth 1993]. Nothing unless the comparisons connect all items.
///
/// [Firth 1993] Firth: Bias reduction of maximum likelihood estimates.
std::optional<Abilities> firth_bradley_terry(const Comparisons& counts);

/// With ties: i before j, j before i and a tie in the proportions π_i : π_j : ν·√(π_i·π_j), π = exp λ
/// [Davidson 1970]. Ties do not move the abilities of equal items apart as half a win would not, but
/// they do say that two items are close.
///
/// [Davidson 1970] Davidson: On extending the Bradley–Terry model to accommodate ties in paired
/// comparison experiments.
struct Davidson {
  Abilities abilities{};
  double log_tie = 0.0;  ///< ln ν
  double log_tie_standard_error = 0.0;
  double deviance = 0.0;
  std::size_t df = 0;  ///< 2·compared pairs − K
};
/// Nothing without ties, and where bradley_terry has nothing.
std::optional<Davidson> davidson(const Comparisons& counts);

/// How consistent one person is who judged every pair of K ≥ 3 items once without ties, from the
/// wins of each item [Kendall 1940]: the number of circular triads (A before B before C before A)
/// and ζ, 1 for none and 0 for as many as possible.
///
/// [Kendall 1940] Kendall, Babington Smith: On the method of paired comparisons.
struct Consistency {
  double circular_triads = 0.0;
  double zeta = 1.0;
};
Consistency consistency(std::span<const std::size_t> wins);

}  // namespace asperity
