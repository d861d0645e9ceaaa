// Where in the device's workspace a surface lies and what happens at its border.

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// What lies beyond the samples of a height field.
enum class Tiling {
  bounded,  ///< the height field ends: the height beyond it is that of its nearest edge
  repeat,   ///< the height field repeats
  mirror,   ///< the height field repeats, every other copy mirrored: no seam in height
};

/// What the hand meets at the border of the patch.
enum class PatchEdge {
  wall,  ///< a wall of the surface's stiffness keeps the probe inside the patch while it is below
         ///< the surface
  fade,  ///< the force fades to zero over `edge_width_m` inside the border, as a smoothstep
};

/// The rectangle of the workspace in which a texture is felt.
///
/// The patch lies in a plane parallel to the device's x–y plane, +z outward. Its own frame has its
/// origin in the patch's centre. Motion maps 1 : 1 to the surface unless `motion_scale` says
/// otherwise: surface = motion_scale · (device − centre) in x and y; z is never scaled.
///
/// Units: metres, in the device's frame; `motion_scale` is dimensionless.
struct SurfacePatch {
  glm::dvec3 centre_m{0.0};
  glm::dvec2 extent_m{0.10, 0.10};
  Tiling tiling = Tiling::repeat;
  PatchEdge edge = PatchEdge::fade;
  double edge_width_m = 0.005;
  double motion_scale = 1.0;
};

}  // namespace asperity
