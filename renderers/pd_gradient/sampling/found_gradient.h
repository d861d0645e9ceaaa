// Declares the conversion of the sample loops' results to δ and ∇δ.

#pragma once

#include <glm/vec3.hpp>

#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/sampling/penetration.h"

namespace asperity {

/// The depth, slope and lever of the hard maximum. If one of the two configurations has no overlap, the difference is
/// one-sided; if both have none, it is 0. `deepest_m` is the deepest sample, in the frame.
Penetration gradient_of(const ElevenMaxima& found, const DifferenceSteps& steps,
                        const glm::dvec3& deepest_m) noexcept;

/// The depth, slope and lever of the smooth maximum: the derivatives of the reference, with sums for means.
Penetration gradient_of(const WeightedSums& sums, const SmoothMaximum& law, double cell_m,
                        const glm::dvec3& deepest_m) noexcept;

}  // namespace asperity
