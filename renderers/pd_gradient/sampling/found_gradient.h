// δ and ∇δ from what the loops over samples found.

#pragma once

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// Depth, slope and lever of the hard maximum. A configuration in which nothing overlaps leaves a
/// one-sided difference, two leave none. `deepest_m` is that sample, in the frame.
Penetration gradient_of(const ElevenMaxima& found, const DifferenceSteps& steps,
                        const glm::dvec3& deepest_m) noexcept;

/// Depth, slope and lever of the smooth maximum: the derivatives of the reference, with sums for means.
Penetration gradient_of(const WeightedSums& sums, const SmoothMaximum& law, double cell_m,
                        const glm::dvec3& deepest_m) noexcept;

}  // namespace asperity
