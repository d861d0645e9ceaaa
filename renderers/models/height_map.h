// The chapter's model: a height map read out of a photograph, felt through a spring.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// The force of a textured spring, in two readings of its source.
///
/// Symbols: d(x, y) height of the field [m]; s `height_scale` [1]; z_s the patch's plane, p_z the
/// tip [m]; k, μ the Material's stiffness [N/m] and friction [1]; H `depth_limit_m` [m];
/// g `lateral_gradient_gain` [1]; n = ẑ the patch's normal.
///
/// `law = corrected` (default):
///
///   w   = max(0, z_s + s·d(x, y) − p_z)      penetration [m], texture included
///   F_n = k·min(w, H)                        saturates continuously at depth H [N]
///   F   = F_n·n − g·F_n·s·∇d − μ·F_n·v_t/√(v_t² + v₀²)
///
/// With g = 1, μ = 0 and w < H the force is −∇U of the energy U = ½·k·w²: a hand that returns has
/// gained nothing. With g = 0, as by default, it points up whatever the slope, as in the
/// source. ∇d is taken over the device's motion, so `motion_scale` enters it.
///
/// `law = literal`, equations 1 to 3 as printed, k the Material's, below the plane only (w > 0 with
/// w = Δw = z_s − p_z):
///
///   F_t = k·s·d(x, y)·n                      (1) `offset = none`; with `subtract_min`
///                                                k·s·(d(x, y) − min d)·n
///   F_f = k₁·Δw·n                            (2) k₁ = `k1_N_per_m`
///   F_c = F_t + F_f                          (3) and k₁·H·n, without texture, where Δw > H
///
/// What equation 2 calls friction is the spring of the plate, so the literal law has no force along
/// the surface and ignores μ and g. Since d of the pipeline has mean zero, equation 1 *pulls* over
/// the valleys where k·s·d < −k₁·Δw: that is what the equation says, and it is kept. The force
/// jumps by F_t at contact and at depth H.
///
/// Limits: no mass, no damping. The normal force of `corrected` never exceeds k·H, so a hand that
/// presses harder sinks through.
///
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel height_map_model();

}  // namespace asperity
