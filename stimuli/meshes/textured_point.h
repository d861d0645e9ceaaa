// Where the surface of a textured mesh lies.

#pragma once

#include <cstddef>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The displacement at a place of the atlas, bilinear between texels. The place lies between the
/// centres of the outermost ones.
double displacement_m(const DisplacementAtlas& atlas, const glm::dvec2& place) noexcept;

/// The point of the displaced surface that the model of TexturedMesh gives.
glm::dvec3 textured_point_m(const TexturedMesh& mesh, std::size_t triangle,
                            const glm::dvec3& barycentric) noexcept;

}  // namespace asperity
