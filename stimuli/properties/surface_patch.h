// Declares the position of a surface in the device's workspace and its border.

#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace asperity {

/// The heights outside the samples of a height field.
enum class Tiling {
  bounded,  ///< not repeated: the height outside is that of the nearest edge
  repeat,   ///< repeated
  mirror,   ///< repeated, with every other copy mirrored: no seam in height
};

/// The force at the border of the patch.
enum class PatchEdge {
  wall,  ///< a wall of the surface's stiffness keeps the probe inside the patch during contact; where
         ///< contact begins beyond the border, the wall begins at the probe and follows it inwards
  fade,  ///< the force fades to zero over `edge_width_m` inside the border, as a smoothstep
};

/// The rectangle of the workspace that contains a texture.
///
/// The patch lies in a plane parallel to the device's x–y plane, +z outward. Its own frame has its origin in the
/// patch's centre. Motion on the surface is motion of the device times `motion_scale` in x and y: surface =
/// motion_scale · (device − centre) + texture_origin; z is never scaled.
///
/// Units: metres, in the device's frame; `motion_scale` is dimensionless.
struct SurfacePatch {
  glm::dvec3 centre_m{0.0};
  glm::dvec2 extent_m{0.10, 0.10};
  Tiling tiling = Tiling::repeat;
  PatchEdge edge = PatchEdge::fade;
  double edge_width_m = 0.005;
  double motion_scale = 1.0;
  glm::dvec2 texture_origin_m{0.0};  ///< the point of the texture at the patch's centre
};

}  // namespace asperity
