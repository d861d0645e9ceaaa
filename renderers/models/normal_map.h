// Declares the normal map model: a flat plate whose force is turned by a map of normals, as in haptic frameworks.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a flat plate whose force keeps its magnitude and is turned along the normal of a texture.
///
///   w   = max(0, z_s − p_z)                  penetration of the flat plate [m]
///   F_n = k·w                                k the Material's stiffness [N/m]
///   m̂   = (−s·g_x, −s·g_y, 1)/|…|            s = `height_scale` [1], g the slope of the map [1]
///   F   = F_n·m̂ − D                D the drag of F_n·m̂_z, the rendered normal force (force/friction.h)
///
/// |F| = F_n for every slope (without friction). `law = grey_level` (default) is the map that a framework computes from
/// the picture of the heights, lowest black and highest white, with G of 0 to 255 at column u and row v [CHAI3D]:
///
///   m_uv = (−c·(G_{u+1,v} − G_{u−1,v}), −c·(G_{u,v+1} − G_{u,v−1}), 1)/|…|,   c = 0.01 for each grey level
///
/// Each component is stored as ⌊128 + 127·m⌋, and g = −(m_x, m_y)/m_z of the components interpolated bilinearly. G and the
/// components have `bits` bits: 8 as in the framework, 24 for practically no rounding. The slopes do not depend on the
/// size of the picture or on the height of the relief: they are slopes per texel, and `motion_scale` does not enter.
///
/// `law = physical`: g = ∇h of the height field, with respect to the device's motion, so it includes `motion_scale`. It is
/// the `local_normal` of `sinusoid` with the depth counted from the plane.
///
/// The force is not conservative: the work on a loop is that of F_n on the slopes, which no change of depth returns.
///
/// Limits: the plate stays flat, so the tip does not move over the texture. Rounding down makes small slopes asymmetric:
/// with 8 bits a slope of 0.001 is 0 upwards and 0.008 downwards. At the border of a repeated picture the differences
/// continue into the next copy; the framework takes those of the nearest texels.
///
/// [CHAI3D] Conti et al.: CHAI3D 3.3, cNormalMap::createMap (BSD licence).
ForceModel normal_map_model();

}  // namespace asperity
