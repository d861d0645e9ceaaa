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
///   F   = F_n·n + (F_x, F_y, 0) − μ·F_n·v_t/√(v_t² + v₀²)
///
/// A sinusoid h = A·sin(2πx/L) pushes with at most F_max = K·2πA/L. Slopes are derivatives with respect to the device's
/// motion, so they include `motion_scale`.
///
/// In contact and without friction the force is −∇(½·k·w² + K·h), so a closed path does no work. A hand that touches
/// down at one height and lifts off at another gains or loses K times their difference.
///
/// Limits: the force along the surface jumps from zero to its full value at contact.
///
/// [Minsky 1995] Minsky: Computational haptics: the Sandpaper system for synthesizing texture for a
/// force-feedback display.
ForceModel lateral_gradient_model();

}  // namespace asperity
