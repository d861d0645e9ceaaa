// Declares the points of a textured mesh's surface.

#pragma once

#include <cstddef>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The displacement at a position of the atlas, bilinear between texels. The position must lie between the centres of
/// the outermost texels.
double displacement_m(const DisplacementAtlas& atlas, const glm::dvec2& place) noexcept;

/// The point of the displaced surface, by the model of TexturedMesh.
glm::dvec3 textured_point_m(const TexturedMesh& mesh, std::size_t triangle,
                            const glm::dvec3& barycentric) noexcept;

}  // namespace asperity
