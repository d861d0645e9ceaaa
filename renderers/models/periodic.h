// Declares the periodic model: a relief of a few plane waves with whole numbers of periods, rendered through a spring.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a double Fourier series of heights through a spring [Dominguez-Ramirez 2003].
///
///   h(x, y) = s·Σ_{i=1..4} [a_i·cos φ_i + b_i·sin φ_i],   φ_i = 2π·(m_i·x/L_x + n_i·y/L_y)
///   w       = max(0, z_s + h − p_z)         penetration [m]
///   F       = k·w·n' − D                    k the Material's stiffness [N/m], D the drag of k·w·n'·n (force/friction.h)
///
/// m_i = `waves_x_i` (0 to 8), n_i = `waves_y_i` (−8 to 8), a_i = `cosine_amplitude_i_m`, b_i = `sine_amplitude_i_m`, L_x = `period_x_m`, L_y =
/// `period_y_m`, s = `height_scale`; x and y are 0 at the patch's centre, and h has mean 0. A term with a_i = b_i = 0 is
/// left out.
///
/// `force_direction`, as for `sinusoid`: `fixed` (default) n' = n; `local_normal` n' = (−∂h/∂x, −∂h/∂y, 1)/√(1 + |∇h|²);
/// `gradient` n' = (−∂h/∂x, −∂h/∂y, 1), with which the force without friction is −∇U of U = ½·k·w². Slopes are
/// derivatives with respect to the device's motion, so they include `motion_scale`.
///
/// Each wave is given once: cos and sin of (−m, −n) are those of (m, n) up to a sign, so terms have m > 0, or m = 0 and n >
/// 0, and two terms of different (m, n). Then the waves are orthogonal over L_x by L_y:
///
///   RMS² of the heights = s²·Σ(a_i² + b_i²)/2
///   mean of |∇h|²       = s²·Σ(2π)²·((m_i/L_x)² + (n_i/L_y)²)·(a_i² + b_i²)/2
///
/// One term b = A, m = 1 is `sinusoid` with L = L_x, its plane raised by A. A square grating of height ±H consists of b =
/// 4H/(πm) for m = 1, 3, 5, 7; its edges overshoot by 9.21 % of the step 2H (8.95 % with infinitely many terms, the limit
/// of Gibbs).
///
/// The values suggested for a texture sample are those of `sinusoid`: one wave of the RMS of the heights, as long as the
/// sample's dominant wavelength.
///
/// Limits: four waves, no saturation with depth.
///
/// Errors: std::invalid_argument for terms that are not in this half of the plane, or twice the same wave.
///
/// [Dominguez-Ramirez 2003] Dominguez-Ramirez, Parra-Vega: Texture, roughness and shape haptic perception of deformable virtual
/// objects with constrained Lagrangian formulation.
ForceModel periodic_model();

}  // namespace asperity
