// Declares the height map model of [Wu 2009]: heights from a photograph, rendered through a spring.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a height field through a spring, by one of two readings of the source's equations.
///
/// Symbols: d(x, y) height of the field [m]; s `height_scale` [1]; z_s the patch's plane, p_z the
/// tip [m]; k, μ the Material's stiffness [N/m] and friction [1]; H `depth_limit_m` [m];
/// g `lateral_gradient_gain` [1]; n = ẑ the patch's normal.
///
/// `law = corrected` (default):
///
///   w   = max(0, z_s + s·d(x, y) − p_z)      penetration [m], texture included
///   F_n = k·min(w, H)                        saturates continuously at depth H [N]
///   F   = F_n·n − g·F_n·s·∇d − D                D the drag of the friction (force/friction.h)
///
/// With g = 1, μ = 0 and w < H the force is −∇U of the energy U = ½·k·w²: a closed path does no work. With g = 0 (the
/// default) it points up for any slope, as in the source. ∇d is the derivative with respect to the device's motion, so
/// it includes `motion_scale`.
///
/// `law = literal` applies equations 1 to 3 as printed. k is the Material's; the force acts below the plane only (w > 0
/// with w = Δw = z_s − p_z):
///
///   F_t = k·s·d(x, y)·n                      (1) `offset = none`; with `subtract_min`
///                                                k·s·(d(x, y) − min d)·n
///   F_f = k₁·Δw·n                            (2) k₁ = `k1_N_per_m`
///   F_c = F_t + F_f                          (3) and k₁·H·n, without texture, where Δw > H
///
/// The friction of equation 2 is the spring of the plate, so the literal law has no force along the surface and ignores
/// μ and g. Since d of the pipeline has mean zero, equation 1 pulls the probe down over the valleys where k·s·d <
/// −k₁·Δw; this follows from the equation and is kept. The force jumps by F_t at contact and at depth H.
///
/// Limits: no mass and no damping. The normal force of `corrected` never exceeds k·H, so a hand that presses harder
/// sinks through the surface.
///
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel height_map_model();

}  // namespace asperity
