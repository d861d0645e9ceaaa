// Declares the bump map model: a flat plate whose normal is perturbed by the slope of a texture.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a flat plate with the perturbed normal of [Ho 1999].
///
///   h'  = max(0, s·h(x, y) − min(s·h))      height [m], measured from the lowest place; s = `height_scale` [1]
///   M   = n − ∇h' + (∇h'·n)·n,  M̂ = M/|M|   perturbed normal [Max 1994]; here M = (−∂h'/∂x, −∂h'/∂y, 1)
///   d   = max(0, z_s + h_c − p_z)           depth under the face [m]
///   F   = k·[(d − K·h')·n + K·h'·M̂]         where d ≥ K·h'
///   F   = k·d·M̂                             where d < K·h'
///       − D                                 D the drag (force/friction.h) of F_n = F·n, the rendered normal force
///
/// h the height field [m], n = ẑ, k, μ the Material's stiffness [N/m] and friction [1], z_s the patch's plane, p_z the tip
/// [m], K = `depth_scale` [1], 0 to 1. `face = mean` (default): h_c = 0, the face is the plane z_s. `face = crest`: h_c =
/// s·(max h − min h), the plane z_s is the lowest place and the face is at the height of the highest one. Slopes are
/// derivatives with respect to the device's motion, so they include `motion_scale`. h' is limited to 0 because the
/// interpolated field can be lower than its lowest sample.
///
/// The two forces are equal at d = K·h', and |F| ≤ k·d: the force is continuous at contact and never exceeds that of the
/// plate. A light touch (d < K·h') is directed along M̂; with increasing depth the direction approaches n. K = 0 is the
/// plate. A sinusoid h = A·sin φ of slope a = 2πA/L has F_x/F_z = −a·cos φ at a light touch.
///
/// The force is not conservative. For a light touch of a sinusoid, the surface does the work k·(d₂ − d₁)·atan(a)·L/2π −
/// ½·k·(d₂² − d₁²)·(1 − 1/√(1 + a²)) on a tip that moves from the node φ = 0 to the crest at depth d₁ and back at d₂.
///
/// Limits: the plate itself stays flat, so the tip does not move over the bumps. A force along the surface pushes it out of
/// each bump, but there is no height to hold it in a valley.
///
/// [Ho 1999] Ho, Basdogan, Srinivasan: Efficient point-based rendering techniques for haptic display of virtual objects.
/// [Max 1994] Max, Becker: Bump shading for volume textures.
ForceModel bump_map_model();

}  // namespace asperity
