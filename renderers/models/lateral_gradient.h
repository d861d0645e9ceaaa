// Declares the lateral gradient model: texture as a force along the surface, proportional to its slope.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a flat plate whose texture exerts a lateral force only, down the slope.
///
///   w   = max(0, z_s − p_z)                penetration of the flat plate [m]
///   F_n = k·w                              k the Material's stiffness [N/m]
///   F_x = −K·q·∂h/∂x,  F_y = −K·q·∂h/∂y    h the height field [m], K = `gain_N` [N]
///   F   = F_n·n + (F_x, F_y, 0) − D                D the drag of the friction (force/friction.h)
///
/// `law = constant` (default): q = 1, the law of the source, in which the force along the surface does not depend on the
/// normal force; in the first 0.1 mm of depth q = s(w/0.1 mm) (contact_fade.h), so that contact begins without a step. `law =
/// force`: q = F_n/(1 N), so that the texture is felt in proportion to the normal force. Friction takes F_n from the plate
/// in both.
///
/// A sinusoid h = A·sin(2πx/L) pushes with at most F_max = K·2πA/L. Slopes are derivatives with respect to the device's
/// motion, so they include `motion_scale`.
///
/// Deeper than 0.1 mm and without friction the force of `constant` is −∇(½·k·w² + K·h), so a closed path does no work. A hand
/// that touches down at one height and lifts off at another gains or loses K times their difference: K·h is not the work
/// of the 0.1 mm, which would take a normal force of 1.5·K·h/0.1 mm. The force of `force` is no
/// gradient: on a tip that moves from h₁ to h₂ at depth w₁ and back at w₂, the surface does the work K·k·(w₂ − w₁)·(h₂ −
/// h₁)/(1 N).
///
/// Limits: with `constant` the force along the surface rises by up to 1.5·K·|∇h|/(0.1 mm) in each metre of depth, 4.7 kN/m
/// for K = 1 N on a slope of 0.31.
///
/// [Minsky 1995] Minsky: Computational haptics: the Sandpaper system for synthesizing texture for a
/// force-feedback display.
ForceModel lateral_gradient_model();

}  // namespace asperity
