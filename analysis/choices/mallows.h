// How far assignments are from chance, as one number.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// Mallows' model of permutations π of m items with the Hamming distance [Fligner 1986]: with F(π)
/// right items, P(π) ∝ exp(θ·F(π)). θ = 0 is chance. The likelihood is largest where the expected F
/// is the observed mean; θ is −∞ where nothing was ever right and ∞ where all was, and then there is
/// no fit beside it.
///
/// [Fligner 1986] Fligner, Verducci: Distance based ranking models.
struct MallowsFit {
  double theta = 0.0;
  struct Finite {
    double standard_error = 0.0;    ///< 1/√(n·Var_θ F)
    double likelihood_ratio = 0.0;  ///< against θ = 0; chi-squared with 1 degree of freedom
    ConfidenceInterval interval{};  ///< by profile: where the likelihood ratio is still allowed
  };
  std::optional<Finite> finite{};
};

/// `right`: the number of right items of each assignment of `items` items. Throws
/// std::invalid_argument for no assignment, more right than items, and items outside 1 to 12.
MallowsFit mallows_fit(std::span<const std::size_t> right, std::size_t items,
                       double confidence = 0.95);

}  // namespace asperity
