// Declares the drop point of a tip: the spacing of a texture from which on the tip reaches the ground.

#pragma once

#include <optional>

#include "renderers/offline/offset_surface.h"
#include "renderers/offline/roughness_stroke.h"

namespace asperity {

/// The drop point: the smallest spacing at which a ball of radius R reaches the ground between two neighbouring elements,
/// midway between them on a line through both. Estimates of roughness through a probe are greatest near it
/// [Klatzky 2003, Unger 2008]: below it the ball rides on the elements, above it the ground is felt between them.
///
/// With flanks of the height h that rise at the angle α, a ball on the ground has its centre R above it and touches a
/// flank at the height R·(1 − cos α). Where that is at most h, half of the gap between the feet of the flanks must be at
/// least R·tan(α/2), the length of a tangent from the foot to the ball. Otherwise h < R, and half of the gap between the
/// tops must be at least √(2Rh − h²), half of the ball's chord at the height h:
///
///   grating (top t, flank f)      s = t + 2f + 2R·tan(α/2)   or   s = t + 2√(2Rh − h²);   tan α = h/f
///   cones (top d_t, base d_b)     s = d_b + 2R·tan(α/2)      or   s = d_t + 2√(2Rh − h²);   tan α = 2h/(d_b − d_t)
///   sinusoid (amplitude A)        s = 2π·√(A·R): the trough's radius of curvature, (s/2π)²/A, is R
///
/// The jitter of cones moves single neighbours apart and together; this is the spacing without it. Lengths in metres.
///
/// nullopt for other kinds, for a relief, for a mesh in place of the tip, and for a tip that is a point.
std::optional<double> drop_point_m(const SpacedTexture& texture, const RigidTip& tip);

}  // namespace asperity
