// Abilities of items from comparisons of two.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/choices/comparisons.h"
#include "analysis/choices/conditional_logit.h"

namespace asperity {

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
  /// The increase in the log odds of being chosen for the item presented first; nothing where it
  /// cannot be separated from the abilities.
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

/// Firth's estimate, which removes the first-order bias and is finite even where an item always wins: the
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

/// The terms of a paired comparison model in addition to the abilities.
struct PairTerms {
  bool order = false;  ///< an advantage α of the item that is presented first
  bool ties = false;   ///< ties as a third outcome; without it they are left out
};

/// A parameter on the log scale.
struct LogParameter {
  double value = 0.0;
  double standard_error = 0.0;
};

/// Observed against expected counts, the latter from the model, with a cell for each outcome of each
/// pair: of each ordered pair (first, second) with an order effect.
///
/// [Cochran 1954] Cochran: Some methods for strengthening the common χ² tests.
struct PairFit {
  double pearson = 0.0;  ///< X² = Σ (observed − expected)²/expected
  double deviance = 0.0;  ///< G² = 2·Σ observed·ln(observed/expected): against the saturated model
  std::size_t df = 0;     ///< pairs·(outcomes − 1) − parameters; of both
  double smallest_expected = 0.0;  ///< the smallest expected count
  double below_five = 0.0;         ///< the proportion of expected counts below 5
  /// Whether X² and G² are distributed approximately as χ² [Cochran 1954]: no expected count is below 1, and at most 20 %
  /// of them are below 5. Otherwise the p of neither is reliable.
  bool is_approximately_chi_squared() const noexcept {
    return smallest_expected >= 1.0 && below_five <= 0.2;
  }
};

/// The first item is preferred, the second is preferred, and they are tied with probabilities in the
/// proportions
///
///   exp((λ_first − λ_second + α)/2) : exp((λ_second − λ_first − α)/2) : ν
///
/// all λ, α and ln ν being log odds. With α = 0 and without ties it is the Bradley–Terry model, with
/// ties that of [Davidson 1970]. With both it is that of [Davidson 1977], who write
/// π_1 : γ·π_2 : ν'·√(π_1·π_2): γ = exp(−α) and ν' = ν·√γ. Abilities are determined up to a constant;
/// here their sum is 0.
///
/// [Davidson 1977] Davidson, Beaver: On extending the Bradley–Terry model to incorporate within-pair
/// order effects.
struct PairModel {
  Abilities abilities{};                ///< with the sum 0; the covariance is that of these values
  std::optional<LogParameter> order{};  ///< α
  std::optional<LogParameter> tie{};    ///< ln ν
  double log_likelihood = 0.0;          ///< without multinomial coefficients
  PairFit fit{};
  /// Likelihood-ratio statistic against equal abilities (with the same α and ν), K − 1 degrees of
  /// freedom.
  double equal_abilities = 0.0;
};

/// Why a paired comparison model has no finite maximum.
enum class PairProblem {
  never_compared,  ///< items that were compared at most among themselves
  never_lose,      ///< items that win every comparison with one of the others
  never_win,       ///< items that lose every comparison with one of the others
  no_ties,         ///< ties are a term, and there is none: ν = 0
  not_identified,  ///< the order effect cannot be separated from the abilities
  no_maximum,      ///< the likelihood grows without bound for another reason
};

/// A fit, or the problem with the items that it concerns (`blocked_items`; empty for the last three
/// problems).
struct PairAnswer {
  std::optional<PairModel> model{};
  PairProblem problem = PairProblem::no_maximum;
  std::vector<std::size_t> items{};
};

/// By maximum likelihood. A finite maximum requires that each set of items both wins and loses
/// against the rest [Ford 1957]; a tie counts as both, where ties are a term. Comparisons count as
/// independent, also those of one participant: `bradley_terry` has errors over participants. Throws
/// std::invalid_argument for fewer than two items, and as `count_comparisons` does.
///
/// [Ford 1957] Ford: Solution of a ranking problem from binary comparisons.
PairAnswer paired_model(std::span<const Comparison> comparisons, std::size_t items,
                        const PairTerms& terms = {});

/// λ_first − λ_second with its standard error, from the covariance of both.
struct AbilityPair {
  std::size_t first = 0;
  std::size_t second = 1;
};
LogParameter difference_of(const Abilities& abilities, const AbilityPair& pair);

}  // namespace asperity
