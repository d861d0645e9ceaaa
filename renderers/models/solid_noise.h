// Declares the solid noise model: a relief cut out of noise that fills space, rendered through a spring.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders heights that a plane cuts out of solid noise through a spring [Fritz 1996, Perlin 2002].
///
///   h(x, y) = A·Σ_{o=0..m−1} 2^{−o}·N_o(q_o),   q_o = (2^o/λ)·R_o·(x, y, 0) + c_o
///   w   = max(0, z_s + h − p_z)                penetration [m]
///   F_n = k·w                                  k the Material's stiffness [N/m]
///   F   = F_n·(−g·∂h/∂x, −g·∂h/∂y, 1) − D     D the drag of the friction (force/friction.h)
///
/// N_o is gradient noise (force/gradient_noise.h) of the octave o; A = `amplitude_m`, λ = `wavelength_m` the lattice of the
/// first octave, m = `octaves`, g = `lateral_gradient_gain`; x and y are on the texture, 0 at the patch's centre. The
/// rotation R_o and the offset c_o of every octave are drawn from the seed: a plane through the corners of the lattice
/// would be flat in rows, in all octaves at the same places. A place has the same height whenever it
/// is felt. Every presentation has a relief of its own, unless `relief` states a number: presentations with the same
/// number have the same relief.
///
///   RMS of the heights = A·√(E[N²]·Σ 4^{−o}) = 0.27·A of one octave, 0.309·A of three
///
/// of the mean over all planes; that of a small patch scatters about it. Slopes are derivatives with respect to the
/// device's motion, so they include `motion_scale`. With g = 1 the force without friction is −∇U of U = ½·k·w².
///
/// The values suggested for a texture sample are the A with its RMS in three octaves, and its dominant wavelength as λ.
///
/// Limits: with one octave the directions of the lattice can be felt. No saturation with depth. The sources evaluate the
/// noise at the probe; here it is evaluated at the projection of the probe on the plane, so that pressing does not change
/// the texture.
///
/// [Fritz 1996] Fritz, Barner: Stochastic models for haptic texture.
/// [Perlin 2002] Perlin: Improving noise.
ForceModel solid_noise_model();

}  // namespace asperity
