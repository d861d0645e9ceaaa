// Declares the lateral gradient model: texture as a force along the surface, proportional to its slope.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a flat plate whose texture exerts a lateral force only, down the slope.
///
///   w   = max(0, z_s − p_z)                penetration of the flat plate [m]
///   F_n = k·w                              k the Material's stiffness [N/m]
///   F_x = −K·∂h/∂x,  F_y = −K·∂h/∂y        in contact (w > 0), h the height field [m],
///                                          K = `gain_N` [N], independent of the normal force
///   F   = F_n·n + (F_x, F_y, 0) − D                D the drag of the friction (force/friction.h)
///
/// `law = constant` (default) is the law of the source. `law = force`: F_x and F_y are multiplied by F_n/(1 N), so that the
/// texture is felt in proportion to the normal force and does not jump at contact.
///
/// A sinusoid h = A·sin(2πx/L) pushes with at most F_max = K·2πA/L. Slopes are derivatives with respect to the device's
/// motion, so they include `motion_scale`.
///
/// In contact and without friction the force of `constant` is −∇(½·k·w² + K·h), so a closed path does no work. A hand that
/// touches down at one height and lifts off at another gains or loses K times their difference. The force of `force` is no
/// gradient: on a tip that moves from h₁ to h₂ at depth w₁ and back at w₂, the surface does the work K·k·(w₂ − w₁)·(h₂ −
/// h₁)/(1 N).
///
/// Limits: with `constant` the force along the surface jumps from zero to its full value at contact.
///
/// [Minsky 1995] Minsky: Computational haptics: the Sandpaper system for synthesizing texture for a
/// force-feedback display.
ForceModel lateral_gradient_model();

}  // namespace asperity
