// Declares the model of a rigid tip on an elastic foundation.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a rigid tip on a soft textured surface whose places deform independently: a bed of springs.
///
///   p = k_w·max(0, w)     k_w `foundation_N_per_m3` [N/m³]; w = h − h_A − z the overlap (elastic_halfspace.h)
///   F = ∫ p·(−∂h/∂x, −∂h/∂y, 1) dA − D,   T = ∫ r × p·(−∂h/∂x, −∂h/∂y, 1) dA
///
/// F (without friction) and T are the gradient of the energy ½·k_w·∫ max(0, w)² dA. Closed forms, on a plane: ball F = π·k_w·R·δ²,
/// flat end F = π·k_w·R²·δ.
///
/// A layer of thickness b that is bonded to a rigid body has k_w ≈ (1 − ν)·E/((1 + ν)(1 − 2ν)·b) [Johnson 1985, section 4.3]. A
/// half-space has no k_w: under a wave of length λ it is as stiff as k_w = πE*/λ.
///
/// Limits: as elastic_halfspace, without its conditions on the size of the body.
///
/// ForceRenderer::limits counts ticks: `contact`; `cell_border` (the contact reached the border of the cells; a ball on a plane
/// does so from δ = 0.53 R on, and loses force from 0.57 R on: 2 % at 0.73 R, 10 % at R).
ForceModel winkler_model();

}  // namespace asperity
