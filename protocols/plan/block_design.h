// Declares the design of a discrimination block in one sentence, as a methods section states it.

#pragma once

#include <optional>

#include "analysis/words/phrase.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// The slope of a Weibull function of the increment that expected standard errors assume: that of increment
/// discrimination, about 1.3, which is lower than that of detection.
inline constexpr double kIncrementSlope = 1.3;

/// The smallest standard error of the common logarithm of a threshold that a block allows: 1/√I of the Cramér–Rao bound,
/// with the slope kIncrementSlope, the guess rate of the design and a lapse rate of 0.02 known.
///
/// I is the Fisher information about log10 α of a Weibull function of the difference from the standard,
///
///   I = Σ (∂ψ/∂log10 α)²/(ψ·(1 − ψ)),  ∂ψ/∂log10 α = −ln 10·β·(1 − γ − λ)·F′(t),
///
/// summed over the trials of one combination of the other factors; with a procedure its mean over 5 to 200 simulated sets
/// of tracks. α is the geometric mean of the smallest and the largest difference. Nothing where the block does not
/// measure performance by choices of a surface, or has levels below the standard.
std::optional<double> least_threshold_error(const Protocol::Block& block);

/// The task of a discrimination block and how its surfaces are presented, as a methods section states it: "two-interval forced
/// choice, one surface after the other", "same–different task, side by side".
Phrase presentation_text(const Protocol::Block& block);

/// "3-down/1-up staircase (79.4 %), 60 trials × 2 interleaved tracks", "constant stimuli, 60 trials". Requires a
/// procedure.
Phrase procedure_text(const Protocol::Block& block);

/// "two-interval forced choice, one surface after the other, 3-down/1-up staircase (79.4 %), 60 trials × 2 interleaved tracks,
/// about 22 min; standard error of the log10 threshold at least 0.09 (β = 1.3)"; empty for a block of another kind.
/// `plan` is an example plan of the protocol.
Phrase design_of(const Protocol& protocol, const Protocol::Block& block, const Plan& plan);

}  // namespace asperity
